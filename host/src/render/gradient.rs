//! Gradients of a scene's tensors, as they lie on a device.

use glam::Vec4;

use super::DeviceScene;
use super::field::DeviceField;
use super::hash_grid::HashGridGradient;
use crate::error::{Error, Result};
use organza_device::{Buffer, Device};

/// Gradients of all tensors of a scene; kernels add to them.
#[derive(Debug)]
pub struct SceneGradient {
    /// `[11 N]`: position `[N, 3]`, rotation `[N, 4]`, log_scale `[N, 3]`, opacity `[N]`.
    pub gaussians: Buffer<f32>,
    /// `[N]`: the sum of |dL/dmean2d| over cameras, the cameras that saw the Gaussian, its largest radius in pixels, 0.
    pub statistics: Buffer<Vec4>,
    /// The statistics as they were when the step began.
    statistics_before: Buffer<Vec4>,
    /// `[N, M]`
    pub material: Buffer<f32>,
    /// `[N, U]`
    pub extra: Buffer<f32>,
    /// Of the color field.
    pub color: FieldGradient,
    /// Of the transmittance field.
    pub transmittance: FieldGradient,
    /// Whether the transmittance field and the extra vectors are wanted at all.
    pub(crate) has_transmittance: bool,
}

/// Gradients of a hash grid and its network.
#[derive(Debug)]
pub struct FieldGradient {
    /// Packed as [`DeviceField::parameters`].
    pub parameters: Buffer<Vec4>,
    /// Of the hash grid's table.
    pub table: HashGridGradient,
}

impl SceneGradient {
    /// Zeros, for a scene.
    ///
    /// # Errors
    /// [`Error::Argument`] where the scene's grids or networks are halves; as [`Device::zeros`].
    pub fn new(device: &Device, scene: &DeviceScene) -> Result<Self> {
        scene.require_gradients()?;
        let gaussians = scene.len();
        Ok(Self {
            gaussians: device.zeros("gradient of the Gaussians", 11 * gaussians)?,
            statistics: device.zeros("statistics", gaussians)?,
            statistics_before: device.zeros("statistics before", gaussians)?,
            material: device.zeros("gradient of the material", scene.material.len())?,
            extra: device.zeros("gradient of the extra vectors", scene.extra.len())?,
            color: FieldGradient::new(device, &scene.color)?,
            transmittance: FieldGradient::new(device, &scene.transmittance)?,
            has_transmittance: true,
        })
    }

    /// Looks whether every gradient of a hash grid was a number.
    ///
    /// # Errors
    /// [`Error::Diverged`] where one was not; as [`Device::read`].
    pub fn check(&self, device: &Device) -> Result<()> {
        for (name, field) in [("color", &self.color), ("transmittance", &self.transmittance)] {
            if device.read(&field.table.status)?[0] != 0 {
                let reason = format!("a gradient of the {name} field is NaN or infinite");
                return Err(Error::Diverged { reason });
            }
        }
        Ok(())
    }

    /// A step begins.
    pub(crate) fn begin(&self, device: &Device) {
        device.copy(&self.statistics, &self.statistics_before);
    }

    /// As it was when the step began.
    pub(crate) fn restart(&self, device: &Device) {
        device.copy(&self.statistics_before, &self.statistics);
        [&self.gaussians, &self.material, &self.extra].into_iter().for_each(|b| device.clear(b));
        for field in [&self.color, &self.transmittance] {
            device.clear(&field.parameters);
            field.table.clear(device);
        }
    }

    /// Clears what says which blocks of the tables have a gradient: for the next step.
    pub(crate) fn clear_touched(&self, device: &Device) {
        device.clear(&self.color.table.touched);
        device.clear(&self.transmittance.table.touched);
    }
}

impl FieldGradient {
    fn new(device: &Device, field: &DeviceField) -> Result<Self> {
        Ok(Self {
            parameters: device.zeros("gradient of a network", field.parameters.len())?,
            table: HashGridGradient::new(device, field)?,
        })
    }
}
