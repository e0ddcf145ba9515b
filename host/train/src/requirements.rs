//! The needs of a run, checked before it begins: settings in range, frames, and the least memory.

use super::config::TrainConfig;
use muslin_device::memory;
use organza_core::error::{Error, Result, format_bytes};
use organza_core::tile::Tile;
use organza_data::Dataset;

/// Bytes per Gaussian, besides its tensors, while it gets its position: the position and its neighbors.
const PLACE_BYTES: u64 = 80;
/// Bytes per pixel of a step: the photograph's color, and whether the pixel is valid.
const PIXEL_BYTES: u64 = 4 * 4;
/// Bytes per pixel of the part of a step that is rendered at once: its color, the loss and the gradients.
const PART_PIXEL_BYTES: u64 = 256;
/// Largest number of bytes that a run needs for such pixels: larger steps are rendered in parts.
const MAX_PIXEL_BYTES: u64 = 2 << 30;

impl TrainConfig {
    /// Fails if a run cannot fit into memory, before anything is read or allocated.
    ///
    /// # Errors
    /// [`DeviceError::OutOfMemory`](organza_core::error::DeviceError::OutOfMemory) with the least memory needed, by its
    /// parts, and the memory available.
    pub fn check_memory(&self) -> Result<()> {
        let tiles = u64::from(self.run.tiles_per_step);
        let pixels = tiles * u64::from(self.run.tile_size).pow(2);
        let part = (pixels * PART_PIXEL_BYTES).min(MAX_PIXEL_BYTES);
        let step = pixels * PIXEL_BYTES + tiles * size_of::<Tile>() as u64 + part;
        // The photographs and their points are not known yet.
        let [photographs, gaussians] = match self.data.path {
            Some(_) => [0, 1],
            None => [built_in_bytes(self), u64::from(self.first_gaussians())],
        };
        let scene = scene_bytes(self, gaussians);
        let [views, tiles, moments] = [photographs, step, scene].map(format_bytes);
        let what = format!(
            "the run (views {views}, the tiles of a step {tiles}, the scene and Adam's moments \
             {moments})"
        );
        Ok(memory::check(photographs.saturating_add(step).saturating_add(scene), &what)?)
    }
}

/// Fails if a scene of this many Gaussians and Adam's moments do not fit.
pub(super) fn check_scene(config: &TrainConfig, gaussians: u64) -> Result<()> {
    let what = format!("a scene of {gaussians} Gaussians with Adam's moments");
    Ok(memory::check(scene_bytes(config, gaussians), &what)?)
}

/// Bytes of a scene and of two moments of the same shape.
fn scene_bytes(config: &TrainConfig, gaussians: u64) -> u64 {
    let scene = config.scene_config([0.0; 3], [[0.0; 3], [1.0; 3]]);
    let specs = scene.tensors(gaussians as usize);
    let values = specs.iter().fold(0_u64, |sum, spec| sum.saturating_add(spec.values() as u64));
    values.saturating_mul(3 * 4).saturating_add(gaussians * PLACE_BYTES)
}

fn built_in_bytes(config: &TrainConfig) -> u64 {
    3 * u64::from(config.data.built_in_views) * u64::from(config.data.built_in_side).pow(2)
}

/// Checks settings that were made in code like settings from a file.
pub(super) fn check(config: &TrainConfig, dataset: &Dataset) -> Result<()> {
    config.validate()?;
    if dataset.train.is_empty() {
        let reason = "the data set has no frame to train on".to_owned();
        return Err(Error::Invalid { origin: dataset.path.clone(), reason });
    }
    Ok(())
}
