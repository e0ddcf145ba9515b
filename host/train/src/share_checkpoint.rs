//! The checkpoint of a training whose Gaussians are dealt to ranks. In memory, each rank has its share. The file is that of
//! any run: rank 0 writes it, and has the others' rows one tensor of one rank at a time.

use std::ops::Range;
use std::path::Path;

use serde::{Deserialize, Serialize};

use super::binding::Binding;
use super::checkpoint::{Checkpoint, MOMENTS, Progress, STATISTICS};
use super::config::TrainConfig;
use super::per_photograph::PerPhotograph;
use organza_core::error::{Error, IN_MEMORY, Result};
use organza_core::ranks::{Grid, Ranks};
use organza_core::scene::{Scene, SceneConfig, SceneShare, Tensor, TensorSpec, range_of};
use organza_core::scene::{scene_metadata, write_streamed};

/// Where training stands, for one rank: the state of its [share](SceneShare) of the Gaussians, and of all fields.
#[derive(Clone, Debug, PartialEq)]
pub struct CheckpointShare {
    /// The state of the share's Gaussians and of the fields.
    pub state: Checkpoint,
    /// The share's Gaussians among those of the whole scene.
    pub range: Range<usize>,
    /// Gaussians of the whole scene.
    pub gaussians: usize,
}

/// What all ranks know of a scene.
#[derive(Debug, Serialize, Deserialize)]
struct Outline {
    config: SceneConfig,
    gaussians: usize,
    progress: Progress,
    exposures: Option<PerPhotograph>,
    poses: Option<PerPhotograph>,
}

impl CheckpointShare {
    /// The share of a rank, of a checkpoint in memory.
    #[must_use]
    pub fn of(whole: &Checkpoint, rank: usize, ranks: usize) -> Self {
        let SceneShare { scene, range, gaussians } = SceneShare::of(&whole.scene, rank, ranks);
        let moments =
            whole.moments.each_ref().map(|moment| SceneShare::of(moment, rank, ranks).scene);
        let statistics = whole.statistics[range.clone()].to_vec();
        let mut state = Checkpoint::of_scene(scene, moments, statistics, whole.progress);
        state.exposures.clone_from(&whole.exposures);
        state.poses.clone_from(&whole.poses);
        Self { state, range, gaussians }
    }

    /// The state of a rank's share of so many Gaussians.
    pub(super) fn of_state(state: Checkpoint, gaussians: usize, rank: usize, ranks: usize) -> Self {
        Self { state, range: range_of(gaussians, rank, ranks), gaussians }
    }

    /// The share of a rank before the first step of training `scene`.
    ///
    /// # Errors
    /// As [`Checkpoint::begin`].
    pub(super) fn begin(
        scene: &Scene,
        config: &TrainConfig,
        rank: usize,
        ranks: usize,
    ) -> Result<Self> {
        let SceneShare { scene, range, gaussians } = SceneShare::of(scene, rank, ranks);
        Ok(Self { state: Checkpoint::begin(scene, config)?, range, gaussians })
    }

    /// Reads the share of a rank from a checkpoint of any run, and no more of it.
    ///
    /// # Errors
    /// As [`Checkpoint::load`].
    pub fn load(path: impl AsRef<Path>, rank: usize, ranks: usize) -> Result<Self> {
        let path = path.as_ref();
        let progress = Progress::load(path)?;
        let other = Some((STATISTICS, 4));
        let (share, moments, statistics) =
            SceneShare::load_more(path, rank, ranks, MOMENTS, other)?;
        let statistics = statistics.as_chunks().0.to_vec();
        let SceneShare { scene, range, gaussians } = share;
        let mut state = Checkpoint::of_scene(scene, moments, statistics, progress);
        state.read_photographs(path)?;
        state.check(path)?;
        Ok(Self { state, range, gaussians })
    }

    /// Gives the other ranks their shares, which `share` makes or reads. This is that of rank 0.
    pub(super) fn deal(
        &self,
        Grid { all: ranks, shares }: Grid<'_>,
        share: impl Fn(usize) -> Result<Self>,
    ) -> Result<()> {
        let Self { state, gaussians, .. } = self;
        let outline = Outline {
            config: state.scene.config.clone(),
            gaussians: *gaussians,
            progress: state.progress,
            exposures: state.exposures.clone(),
            poses: state.poses.clone(),
        };
        let outline = serde_json::to_vec(&outline)
            .map_err(|error| Error::Argument { reason: error.to_string() })?;
        ranks.broadcast(outline)?;
        for rank in 1..ranks.size() {
            let mut for_each = vec![Vec::new(); ranks.size()];
            let mut other = share(rank % shares)?;
            for values in other.values_mut() {
                for_each[rank].extend_from_slice(bytemuck::cast_slice(values));
            }
            drop(other);
            ranks.exchange(for_each)?;
        }
        Ok(())
    }

    /// The share of another rank, from rank 0, which [deals](CheckpointShare::deal).
    pub(super) fn receive(grid: Grid<'_>) -> Result<Self> {
        let ranks = grid.all;
        let outline = ranks.broadcast(Vec::new())?;
        let outline: Outline = serde_json::from_slice(&outline)
            .map_err(|error| Error::Argument { reason: format!("rank 0 has sent {error}") })?;
        let Outline { config, gaussians, progress, exposures, poses } = outline;
        let range = range_of(gaussians, grid.share(), grid.shares);
        let scene = Scene::zeros(config, range.len())?;
        let (moments, statistics) = ([scene.clone(), scene.clone()], vec![[0.0; 4]; range.len()]);
        let state = Checkpoint { scene, moments, statistics, exposures, poses, progress };
        let mut share = Self { state, range, gaussians };
        for rank in 1..ranks.size() {
            let bytes = ranks.exchange(vec![Vec::new(); ranks.size()])?.swap_remove(0);
            if rank != ranks.rank() {
                continue;
            }
            let mut rest = &bytes[..];
            for values in share.values_mut() {
                let (mine, after) = rest.split_at(size_of_val(values));
                bytemuck::cast_slice_mut(values).copy_from_slice(mine);
                rest = after;
            }
        }
        Ok(share)
    }

    /// All its values.
    fn values_mut(&mut self) -> Vec<&mut [f32]> {
        let Checkpoint { scene, moments: [first, second], statistics, .. } = &mut self.state;
        let tensors = [scene, first, second].into_iter().flat_map(Scene::tensors_mut);
        let mut values: Vec<_> = tensors.map(|(_, values)| values).collect();
        values.push(statistics.as_flattened_mut());
        values
    }

    /// Writes the checkpoint of all ranks, as [`Checkpoint::save`] does: the file does not depend on the number of ranks, and
    /// every command reads it. Rank 0 calls this, and all others [`CheckpointShare::hand_over`].
    ///
    /// # Errors
    /// As [`Checkpoint::save`]; [`Error::Rank`] where another rank has failed.
    pub fn save(
        &self,
        path: impl AsRef<Path>,
        binding: Option<&Binding>,
        ranks: &dyn Ranks,
    ) -> Result<()> {
        let config = self.state.scene.config.to_json()?;
        let beside = self.state.metadata(binding)?;
        let mut metadata = scene_metadata(&config).to_vec();
        metadata.extend(beside.iter().map(|(key, text)| (*key, &**text)));
        let photographs = self.state.of_photographs();
        let specs: Vec<_> = self.tensors(&photographs).into_iter().map(|(spec, _)| spec).collect();
        let of_all: Vec<Vec<usize>> = specs
            .iter()
            .map(|spec| match is_row(&spec.name) {
                true => [&[self.gaussians], &spec.shape[1..]].concat(),
                false => spec.shape.clone(),
            })
            .collect();
        let of_all: Vec<_> =
            specs.iter().zip(&of_all).map(|(spec, shape)| (&*spec.name, &shape[..])).collect();
        write_streamed(path, &of_all, &metadata, |write| self.stream(ranks, write))
    }

    /// Takes part in [`CheckpointShare::save`] of rank 0.
    ///
    /// # Errors
    /// As [`CheckpointShare::save`].
    pub fn hand_over(&self, ranks: &dyn Ranks) -> Result<()> {
        self.stream(ranks, &mut |_| Ok(()))
    }

    /// Calls `write` with all values of all ranks, tensor by tensor, on rank 0.
    fn stream(&self, ranks: &dyn Ranks, write: &mut dyn FnMut(&[f32]) -> Result<()>) -> Result<()> {
        let origin = Path::new(IN_MEMORY);
        if !self.range.is_empty() {
            self.state.scene.validate()?;
        }
        self.state.check(origin)?;
        let photographs = self.state.of_photographs();
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

    /// The tensors of the file, in its order; `photographs` are those of [`Checkpoint::of_photographs`].
    fn tensors<'a>(&'a self, photographs: &'a [(String, Tensor)]) -> Vec<(TensorSpec, &'a [f32])> {
        let mut tensors = self.state.scene.tensors();
        tensors.extend(self.state.beside_scene(photographs));
        tensors.sort_by(|(a, _), (b, _)| a.name.cmp(&b.name));
        tensors
    }
}

/// Whether a tensor of a checkpoint has a row for each Gaussian.
fn is_row(name: &str) -> bool {
    let of_scene = MOMENTS.iter().find_map(|prefix| name.strip_prefix(prefix)).unwrap_or(name);
    of_scene.starts_with("gaussians.") || name == STATISTICS
}
