//! Uploads a scene to a device.

use std::borrow::Cow;
use std::sync::Arc;

use organza_shaders::resolve::DIVIDE_ABOVE;
use organza_shaders::unit_cube::SceneBox;

use super::device_scene::{DeviceScene, Roulette};
use super::field::DeviceField;
use super::occupancy::Occupancy;
use super::options::UploadOptions;
use super::packed::{pack, upload};
use muslin_device::Device;
use organza_core::error::argument;
use organza_core::scene::Placement;
use organza_core::{Result, Scene};

impl DeviceScene {
    /// See [`Renderer::upload_with`](crate::Renderer::upload_with).
    pub(crate) fn upload(
        device: &Arc<Device>,
        scene: &Scene,
        options: UploadOptions,
    ) -> Result<Self> {
        scene.validate()?;
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
        let scene_box = SceneBox::new(config.aabb, is_contracted);
        let scene = Self {
            device: Arc::clone(device),
            gaussians: scene.gaussians.len() as u32,
            divide_above: DIVIDE_ABOVE,
            ray_steps: 1,
            roulette: Roulette::default(),
            scene_box: device.upload("scene box", &scene_box.pack())?,
            color: field("color", &config.color_grid, color, &tensors.color)?,
            transmittance: field(
                "transmittance",
                &config.transmittance_grid,
                transmittance,
                &tensors.transmittance,
            )?,
            tensors,
            config: config.clone(),
            occupancy: Occupancy::new(device, config, &scene_box)?,
            place: Placement::default(),
            ground: None,
            beside: Vec::new(),
            fields: Vec::new(),
            version: Arc::default(),
        };
        scene.update_occupancy(device)?;
        Ok(scene)
    }

    /// Fails if the grids are halves: a half has no gradient. Nor have several scenes together.
    pub(crate) fn require_gradients(&self) -> Result<()> {
        if !self.beside.is_empty() {
            return argument("scenes that are shown together have no gradients");
        }
        match self.color.half_table {
            None => Ok(()),
            Some(_) => argument(
                "the scene's grids are halves, without gradients; upload it without `half_grids`",
            ),
        }
    }
}
