//! The checkpoint of a training whose Gaussians are dealt to ranks. In memory, each rank has its shard. The file is
//! that of any run: rank 0 writes it, and has the others' rows one tensor of one rank at a time.

use std::path::Path;

use serde::{Deserialize, Serialize};

use super::{Checkpoint, MOMENTS, STATISTICS};
use crate::ranks::{hear, tell};
use crate::{Binding, PerPhotograph, Progress};
use organza_core::error::{IN_MEMORY, Result};
use organza_core::ranks::{Grid, Ranks, ThreadRanks};
use organza_core::scene::{
    Scene, SceneConfig, SceneShard, Tensor, TensorSpec, range_of, scene_metadata, write_streamed,
};

/// The parts of a scene that all ranks know.
#[derive(Debug, Serialize, Deserialize)]
struct Outline {
    config: SceneConfig,
    gaussians: usize,
    progress: Progress,
    exposures: Option<PerPhotograph>,
    poses: Option<PerPhotograph>,
}

impl Checkpoint {
    /// Gives the other ranks their shards, which `shard` makes or reads. This is that of rank 0.
    pub(crate) fn send_to_ranks(
        &mut self,
        Grid { all: ranks, shards }: Grid<'_>,
        shard: impl Fn(usize) -> Result<Self>,
    ) -> Result<()> {
        let outline = Outline {
            config: self.scene.config.clone(),
            gaussians: self.gaussians,
            progress: self.progress,
            exposures: self.exposures.clone(),
            poses: self.poses.clone(),
        };
        tell(ranks, &outline)?;
        for rank in 1..ranks.size() {
            let mut for_each = vec![Vec::new(); ranks.size()];
            for_each[rank] = match rank % shards {
                0 => self.bytes_of_values(),
                other => shard(other)?.bytes_of_values(),
            };
            ranks.exchange(for_each)?;
        }
        Ok(())
    }

    /// The shard of another rank, from rank 0, which [sends it](Checkpoint::send_to_ranks).
    pub(crate) fn receive(grid: Grid<'_>) -> Result<Self> {
        let ranks = grid.all;
        let Outline { config, gaussians, progress, exposures, poses } = hear(ranks)?;
        let range = range_of(gaussians, grid.shard(), grid.shards);
        let scene = Scene::zeros(config, range.len())?;
        let mut shard = Self::from_shard(SceneShard { scene, range, gaussians }, progress)?;
        (shard.exposures, shard.poses) = (exposures, poses);
        for rank in 1..ranks.size() {
            let bytes = ranks.exchange(vec![Vec::new(); ranks.size()])?.swap_remove(0);
            if rank != ranks.rank() {
                continue;
            }
            let mut rest = &bytes[..];
            for values in shard.values_mut() {
                let (mine, after) = rest.split_at(size_of_val(values));
                bytemuck::cast_slice_mut(values).copy_from_slice(mine);
                rest = after;
            }
        }
        Ok(shard)
    }

    /// All its values, one after the other.
    fn bytes_of_values(&mut self) -> Vec<u8> {
        self.values_mut()
            .into_iter()
            .flat_map(|values| bytemuck::cast_slice(values))
            .copied()
            .collect()
    }

    fn values_mut(&mut self) -> Vec<&mut [f32]> {
        let Self { scene, moments: [first, second], statistics, .. } = self;
        let tensors = [scene, first, second].into_iter().flat_map(Scene::tensors_mut);
        let mut values: Vec<_> = tensors.map(|(_, values)| values).collect();
        values.push(statistics.as_flattened_mut());
        values
    }

    /// Writes the file, beside and renamed. It is bound to a run's settings and data, if to any.
    ///
    /// # Errors
    /// The same errors as [`Scene::save`]: [`Error::NotFinite`](organza_core::Error::NotFinite) where training has overflowed.
    pub fn save(&self, path: impl AsRef<Path>, binding: Option<&Binding>) -> Result<()> {
        self.save_shards(path, binding, &ThreadRanks::alone())
    }

    /// Writes the checkpoint of all ranks, as [`Checkpoint::save`] does: the file does not depend on the number of
    /// ranks, and every command reads it. Rank 0 calls this, and all others [`Checkpoint::hand_over`].
    ///
    /// # Errors
    /// The same errors as [`Checkpoint::save`]; [`Error::Rank`](organza_core::Error::Rank) where another rank has failed.
    pub fn save_shards(
        &self,
        path: impl AsRef<Path>,
        binding: Option<&Binding>,
        ranks: &dyn Ranks,
    ) -> Result<()> {
        let config = self.scene.config.to_json()?;
        let beside = self.metadata(binding)?;
        let mut metadata = scene_metadata(&config).to_vec();
        metadata.extend(beside.iter().map(|(key, text)| (*key, &**text)));
        let photographs = self.photograph_tensors();
        let mut specs: Vec<_> =
            self.tensors(&photographs).into_iter().map(|(spec, _)| spec).collect();
        if ranks.size() > 1 {
            let of_all = specs.iter_mut().filter(|spec| is_row(&spec.name));
            of_all.for_each(|spec| spec.shape[0] = self.gaussians);
        }
        let shapes: Vec<_> = specs.iter().map(|spec| (&*spec.name, &spec.shape[..])).collect();
        write_streamed(path, &shapes, &metadata, |write| self.stream(ranks, write))
    }

    /// Takes part in [`Checkpoint::save_shards`] of rank 0.
    ///
    /// # Errors
    /// The same errors as [`Checkpoint::save_shards`].
    pub fn hand_over(&self, ranks: &dyn Ranks) -> Result<()> {
        self.stream(ranks, &mut |_| Ok(()))
    }

    /// Calls `write` with all values of all ranks, tensor by tensor, on rank 0.
    fn stream(&self, ranks: &dyn Ranks, write: &mut dyn FnMut(&[f32]) -> Result<()>) -> Result<()> {
        // with more ranks than slices, some have no Gaussians
        if !self.range.is_empty() || ranks.size() == 1 {
            self.scene.validate()?;
        }
        self.check(Path::new(IN_MEMORY))?;
        let photographs = self.photograph_tensors();
        for (spec, values) in self.tensors(&photographs) {
            write(values)?;
            if !is_row(&spec.name) {
                continue;
            }
            for rank in 1..ranks.size() {
                let mut for_each = vec![Vec::new(); ranks.size()];
                if rank == ranks.rank() {
                    for_each[0] = bytemuck::cast_slice(values).to_vec();
                }
                let received = ranks.exchange(for_each)?;
                if ranks.rank() == 0 {
                    let values: Vec<f32> = bytemuck::pod_collect_to_vec(&received[rank]);
                    write(&values)?;
                }
            }
        }
        Ok(())
    }

    /// The tensors of the file, in its order; `photographs` are those of [`Checkpoint::photograph_tensors`].
    fn tensors<'a>(&'a self, photographs: &'a [(String, Tensor)]) -> Vec<(TensorSpec, &'a [f32])> {
        let mut tensors = self.scene.tensors();
        tensors.extend(self.beside_scene(photographs));
        tensors.sort_by(|(a, _), (b, _)| a.name.cmp(&b.name));
        tensors
    }
}

/// Whether a tensor of a checkpoint has a row for each Gaussian.
fn is_row(name: &str) -> bool {
    let of_scene = MOMENTS.iter().find_map(|prefix| name.strip_prefix(prefix)).unwrap_or(name);
    of_scene.starts_with("gaussians.") || name == STATISTICS
}
