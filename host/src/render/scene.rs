//! A scene on a device.

use organza_shaders::resolve::DIVIDE_ABOVE;
use organza_shaders::unit_cube::SceneBox;

use super::field::DeviceField;
use super::{Renderer, UploadOptions};
use crate::error::Result;
use crate::scene::{Scene, SceneConfig};
use organza_device::Buffer;

/// A scene whose tensors lie on a device.
#[derive(Debug)]
pub struct DeviceScene {
    pub(super) config: SceneConfig,
    pub(super) gaussians: u32,
    /// Eq. 13's, but in comparisons.
    pub(crate) divide_above: f32,
    pub(super) scene_box: Buffer<f32>,
    pub(super) position: Buffer<f32>,
    pub(super) rotation: Buffer<f32>,
    pub(super) log_scale: Buffer<f32>,
    pub(super) opacity: Buffer<f32>,
    pub(super) material: Buffer<f32>,
    pub(super) extra: Buffer<f32>,
    pub(super) color: DeviceField,
    pub(super) transmittance: DeviceField,
}

impl Renderer {
    /// Copies a scene to the device, as it is; [`Renderer::upload_with`] has choices.
    ///
    /// # Errors
    /// What [`Scene::validate`] finds, and [`Error::OutOfMemory`](crate::Error::OutOfMemory).
    pub fn upload(&self, scene: &Scene) -> Result<DeviceScene> {
        scene.validate()?;
        self.upload_moments(scene)
    }

    /// As [`Renderer::upload`], for tensors that are no scene, such as an optimizer's.
    pub(crate) fn upload_moments(&self, scene: &Scene) -> Result<DeviceScene> {
        self.upload_fields(scene, UploadOptions::default())
    }

    /// As [`Renderer::upload_with`], without looking at the scene or the device.
    pub(super) fn upload_fields(
        &self,
        scene: &Scene,
        options: UploadOptions,
    ) -> Result<DeviceScene> {
        let device = self.device();
        let config = &scene.config;
        let gaussians = &scene.gaussians;
        let upload = |grid, field, name| DeviceField::upload(device, grid, field, options, name);
        Ok(DeviceScene {
            gaussians: gaussians.len() as u32,
            divide_above: DIVIDE_ABOVE,
            scene_box: device.upload("scene box", &SceneBox::new(config.aabb).pack())?,
            position: device.upload("gaussians.position", gaussians.position.as_flattened())?,
            rotation: device.upload("gaussians.rotation", gaussians.rotation.as_flattened())?,
            log_scale: device.upload("gaussians.log_scale", gaussians.log_scale.as_flattened())?,
            opacity: device.upload("gaussians.opacity", &gaussians.opacity)?,
            material: device.upload("gaussians.material", &gaussians.material)?,
            extra: device.upload("gaussians.extra", &gaussians.extra)?,
            color: upload(&config.color_grid, &scene.color, "color")?,
            transmittance: upload(
                &config.transmittance_grid,
                &scene.transmittance,
                "transmittance",
            )?,
            config: config.clone(),
        })
    }
}

impl DeviceScene {
    /// The scene's configuration.
    #[must_use]
    pub fn config(&self) -> &SceneConfig {
        &self.config
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

    /// Bytes that the scene takes on the device.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        [
            &self.position,
            &self.rotation,
            &self.log_scale,
            &self.opacity,
            &self.material,
            &self.extra,
        ]
        .iter()
        .map(|buffer| buffer.bytes())
        .sum::<u64>()
            + self.color.bytes()
            + self.transmittance.bytes()
    }
}
