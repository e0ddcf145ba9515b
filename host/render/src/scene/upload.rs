//! How a scene is stored on a device, and which scenes cannot be.

use std::borrow::Cow;
use std::sync::Arc;

use organza_shaders::resolve::DIVIDE_ABOVE;
use organza_shaders::unit_cube::SceneBox;

use super::device_scene::DeviceScene;
use super::device_shard::DeviceShard;
use super::options::UploadOptions;
use super::packed::{pack, upload};
use crate::batch::renderer::Renderer;
use crate::forward::field::DeviceField;
use organza_core::error::{Error, Result};
use organza_core::scene::{Scene, SceneShard};

impl Renderer {
    /// Copies a scene to the device, as it is; [`Renderer::upload_with`] has choices.
    ///
    /// # Errors
    /// The errors of [`Scene::validate`], and [`DeviceError::OutOfMemory`](organza_core::error::DeviceError::OutOfMemory).
    pub fn upload(&self, scene: &Scene) -> Result<DeviceScene> {
        self.upload_with(scene, UploadOptions::default())
    }

    /// Like [`Renderer::upload`], with choices that are for rendering alone.
    ///
    /// # Errors
    /// The same errors as [`Renderer::upload`]; [`Error::Invalid`] where [`UploadOptions`] says that it is refused.
    pub fn upload_with(&self, scene: &Scene, options: UploadOptions) -> Result<DeviceScene> {
        scene.validate()?;
        let device = self.device();
        let config = &scene.config;
        let mut packed = pack(scene);
        if options.half_grids {
            // the halves are there instead
            for field in [&mut packed.color, &mut packed.transmittance] {
                field.grid = Cow::default();
            }
        }
        let tensors = upload(device, packed)?;
        let field = |name, grid, field, tensors| {
            DeviceField::new(device, name, grid, field, tensors, options)
        };
        let color = &scene.color;
        let transmittance = &scene.transmittance;
        let is_contracted = !config.contraction.is_none();
        let scene_box = SceneBox::new(config.aabb, is_contracted).pack();
        Ok(DeviceScene {
            device: Arc::clone(&self.device),
            gaussians: scene.gaussians.len() as u32,
            divide_above: DIVIDE_ABOVE,
            ray_steps: 1,
            scene_box: device.upload("scene box", &scene_box)?,
            color: field("color", &config.color_grid, color, &tensors.color)?,
            transmittance: field(
                "transmittance",
                &config.transmittance_grid,
                transmittance,
                &tensors.transmittance,
            )?,
            tensors,
            config: config.clone(),
            version: Arc::default(),
        })
    }
}

impl DeviceScene {
    /// Fails where the grids are halves: the numbers that they were are not there.
    pub(crate) fn require_gradients(&self) -> Result<()> {
        match self.color.half_table {
            None => Ok(()),
            Some(_) => {
                let reason = "the scene's grids are halves, without gradients; upload it without `half_grids`";
                Err(Error::Argument { reason: reason.into() })
            }
        }
    }
}

impl DeviceShard {
    /// The Gaussians of `scene`, which are a shard, and its fields.
    ///
    /// # Errors
    /// The same errors as [`Renderer::upload_with`].
    pub fn upload(renderer: &Renderer, scene: &Scene, options: UploadOptions) -> Result<Self> {
        let Scene { config, gaussians, color, transmittance } = scene;
        if !gaussians.is_empty() {
            scene.validate()?;
        }
        let mut fields = Scene::zeros(config.clone(), 1)?;
        (fields.color, fields.transmittance) = (color.clone(), transmittance.clone());
        let fields = renderer.upload_with(&fields, options)?;
        let mut uploaded = Self { fields, blocks: Vec::new(), is_whole: false };
        uploaded.replace_gaussians(renderer.device(), gaussians)?;
        Ok(uploaded)
    }
}

impl Renderer {
    /// Copies a shard to the device.
    ///
    /// # Errors
    /// The same errors as [`Renderer::upload_with`].
    pub fn upload_shard(&self, shard: &SceneShard, options: UploadOptions) -> Result<DeviceShard> {
        DeviceShard::upload(self, &shard.scene, options)
    }
}
