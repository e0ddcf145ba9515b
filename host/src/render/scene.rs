//! A scene on a device.

use organza_shaders::hash_grid::GridLevel;

use super::field::DeviceField;
use super::packed::{pack, unpack};
use crate::error::Result;
use crate::scene::{Scene, SceneConfig, Tensors};
use organza_device::{Buffer, Device};

/// A scene whose tensors lie on a device.
#[derive(Debug)]
pub struct DeviceScene {
    pub(super) config: SceneConfig,
    pub(super) gaussians: u32,
    /// Eq. 13's, but in comparisons.
    pub(crate) divide_above: f32,
    pub(super) scene_box: Buffer<f32>,
    pub(super) tensors: Tensors<Buffer<f32>>,
    pub(super) color: DeviceField,
    pub(super) transmittance: DeviceField,
}

impl DeviceScene {
    /// The scene's configuration.
    #[must_use]
    pub fn config(&self) -> &SceneConfig {
        &self.config
    }

    /// Each tensor's values. Writing to them changes the scene. A grid of 16-bit floats has no values here.
    #[must_use]
    pub fn tensors(&self) -> &Tensors<Buffer<f32>> {
        &self.tensors
    }

    /// Number of Gaussians.
    #[must_use]
    pub fn len(&self) -> usize {
        self.gaussians as usize
    }

    /// Whether there are no Gaussians; an empty scene is not uploaded.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.gaussians == 0
    }

    /// Half the longest side of the scene's box, in world units.
    #[must_use]
    pub fn extent(&self) -> f64 {
        let [low, high] = self.config.aabb;
        (0..3).map(|axis| (high[axis] - low[axis]) / 2.0).fold(0.0, f64::max)
    }

    /// Bytes that the scene takes on the device.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        let tensors: u64 = self.tensors.iter().map(|(_, buffer)| buffer.bytes()).sum();
        tensors + self.color.bytes_beside_tensors() + self.transmittance.bytes_beside_tensors()
    }

    /// Bytes that a scene takes on a device after [`Renderer::upload`](super::Renderer::upload).
    #[must_use]
    pub fn bytes_of(scene: &Scene) -> u64 {
        let tensors: usize = pack(scene).iter().map(|(_, values)| size_of_val(&**values)).sum();
        let grids = [&scene.config.color_grid, &scene.config.transmittance_grid];
        let levels: u32 = grids.iter().map(|grid| grid.levels).sum();
        (tensors + levels as usize * size_of::<GridLevel>()) as u64
    }

    /// The scene as it is now.
    ///
    /// # Errors
    /// As [`Device::read`]; [`Error::Argument`](crate::Error::Argument) where the grids are halves.
    pub fn download(&self, device: &Device) -> Result<Scene> {
        self.require_full_grids()?;
        unpack(&self.config, self.len(), self.tensors.as_ref(), |buffer| Ok(device.read(buffer)?))
    }
}
