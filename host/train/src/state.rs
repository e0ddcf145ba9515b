//! The state that a step changes: the scene on the device, the moments of Adam and the gradient.

use glam::Vec4;

use super::checkpoint::Checkpoint;
use super::config::TrainConfig;
use super::optimizer::Optimizer;
use muslin_device::Device;
use organza_core::error::Result;
use organza_render::{DeviceShard, Renderer, SceneGradient, ShardGradient};

/// The state that a step changes.
#[derive(Debug)]
pub(super) struct TrainerState {
    /// The whole scene, or a shard of it.
    pub shard: DeviceShard,
    pub optimizer: Optimizer,
    pub gradient: ShardGradient,
    /// Gaussians of the whole scene.
    pub gaussians: usize,
}

impl TrainerState {
    /// The state of the checkpoint of `shard`, with values for each of the photographs.
    pub fn new(
        renderer: &Renderer,
        config: &TrainConfig,
        mut shard: DeviceShard,
        checkpoint: &Checkpoint,
        photographs: usize,
    ) -> Result<Self> {
        let device = renderer.device();
        if !config.ablation.divide {
            shard.never_divide();
        }
        let optimizer = Optimizer::new(device, &shard, &checkpoint.moments)?;
        let mut fields = SceneGradient::new(device, shard.fields())?;
        if config.poses.refine {
            fields = fields.with_poses(device, photographs)?;
        }
        let gradient = ShardGradient::new(device, &shard, fields)?;
        let state = Self { shard, optimizer, gradient, gaussians: checkpoint.gaussians };
        state.write_statistics(device, &checkpoint.statistics)?;
        Ok(state)
    }

    /// Whether the next gradient is also that of T.
    pub fn set_transmittance(&mut self, is_learned: bool) {
        let blocks = self.gradient.blocks.iter_mut();
        blocks
            .chain([&mut self.gradient.fields])
            .for_each(|part| part.has_transmittance = is_learned);
    }

    /// The Gaussians are those of a checkpoint from now on; the fields stay.
    pub fn replace_gaussians(&mut self, device: &Device, checkpoint: &Checkpoint) -> Result<()> {
        self.gaussians = checkpoint.gaussians;
        self.shard.replace_gaussians(device, &checkpoint.scene.gaussians)?;
        self.optimizer.replace_gaussians(device, &checkpoint.moments)?;
        self.gradient.replace_gaussians(device, &self.shard)?;
        self.write_statistics(device, &checkpoint.statistics)
    }

    /// `[N]`, of the Gaussians that are here: see [`SceneGradient::statistics`].
    pub fn statistics(&self, device: &Device) -> Result<Vec<[f32; 4]>> {
        let mut statistics = Vec::with_capacity(self.shard.len());
        for block in &self.gradient.blocks {
            statistics.extend(device.read(&block.statistics)?.iter().map(|v| v.to_array()));
        }
        Ok(statistics)
    }

    fn write_statistics(&self, device: &Device, statistics: &[[f32; 4]]) -> Result<()> {
        let mut rest = statistics;
        for block in &self.gradient.blocks {
            let (mine, after) = rest.split_at(block.statistics.len());
            let mine: Vec<_> = mine.iter().map(|&v| Vec4::from_array(v)).collect();
            device.write(&block.statistics, 0, &mine)?;
            rest = after;
        }
        Ok(())
    }
}
