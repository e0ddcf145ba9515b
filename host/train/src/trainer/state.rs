//! The state that a step changes.

use crate::densification::Population;
use crate::optimizer::Optimizer;
use crate::{Checkpoint, TrainConfig};
use glam::Vec4;
use muslin_device::{Buffer, Device};
use organza_core::scene::Gaussians;
use organza_core::{Error, Result};
use organza_render::{DeviceScene, Renderer, SceneGradient};

/// The state that a step changes.
#[derive(Debug)]
pub(super) struct TrainerState {
    pub scene: DeviceScene,
    pub optimizer: Optimizer,
    pub gradient: SceneGradient,
}

impl TrainerState {
    /// The state of a checkpoint, without what is learned of each photograph.
    pub fn new(renderer: &Renderer, config: &TrainConfig, checkpoint: &Checkpoint) -> Result<Self> {
        let device = renderer.device();
        let mut scene = renderer.upload(&checkpoint.scene)?;
        if !config.ablation.divide {
            scene.never_divide();
        }
        let optimizer = Optimizer::new(device, &checkpoint.moments)?;
        let gradient = SceneGradient::new(device, &scene)?;
        let state = Self { scene, optimizer, gradient };
        state.write_statistics(device, &checkpoint.statistics)?;
        Ok(state)
    }

    /// Whether the next gradient includes T's.
    pub fn set_transmittance(&mut self, is_learned: bool) {
        self.gradient.has_transmittance = is_learned;
    }

    /// All Gaussians. Waits once.
    pub fn population(&self, device: &Device) -> Result<Population> {
        let of_moments = self.optimizer.of_gaussians();
        let tensors = [&self.scene.tensors().gaussians, of_moments[0], of_moments[1]];
        let tensors = tensors.into_iter().flat_map(|tensors| tensors.as_ref().into_vec());
        let mut buffers: Vec<_> = tensors.map(Buffer::view).collect();
        buffers.push(self.gradient.statistics.view());
        let words = device.read_all(&buffers)?;
        let mut values = words.iter().map(|words| bytemuck::cast_slice::<u32, f32>(words));
        let mut next = || values.next().expect("as many as buffers");
        let mut gaussians = || {
            let mut gaussians = Gaussians::zeros(self.scene.config(), self.scene.len())?;
            let targets = gaussians.tensors_mut().into_vec();
            targets.into_iter().for_each(|target| target.copy_from_slice(next()));
            Ok::<_, Error>(gaussians)
        };
        Ok(Population {
            gaussians: gaussians()?,
            moments: [gaussians()?, gaussians()?],
            statistics: next().as_chunks().0.to_vec(),
        })
    }

    /// Replaces all Gaussians. The fields stay.
    pub fn replace_gaussians(&mut self, device: &Device, population: &Population) -> Result<()> {
        self.scene.replace_gaussians(device, &population.gaussians)?;
        self.optimizer.replace_gaussians(device, &population.moments)?;
        self.gradient.replace_gaussians(device, &self.scene)?;
        self.write_statistics(device, &population.statistics)
    }

    /// `[N]`: see [`SceneGradient::statistics`].
    pub fn statistics(&self, device: &Device) -> Result<Vec<[f32; 4]>> {
        let statistics = device.read(&self.gradient.statistics)?;
        Ok(statistics.iter().map(|v| v.to_array()).collect())
    }

    fn write_statistics(&self, device: &Device, statistics: &[[f32; 4]]) -> Result<()> {
        let statistics: Vec<_> = statistics.iter().map(|&v| Vec4::from_array(v)).collect();
        Ok(device.write(&self.gradient.statistics, 0, &statistics)?)
    }
}
