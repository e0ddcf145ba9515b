//! A scene on a device.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use organza_shaders::hash_grid::GridLevel;

use super::field::DeviceField;
use super::occupancy::Occupancy;
use super::packed::{pack, replace_gaussians, unpack};
use muslin_device::{Buffer, Device};
use organza_core::error::{Result, argument};
use organza_core::scene::{Gaussians, Ground, Placement, Scene, SceneConfig, Tensors, TrainedOn};

/// Russian roulette in training: what is smaller than a bound survives with a probability of its size over the bound, and then counts as the
/// bound. So sums keep their means, and less is computed. With a bound of 0, all survive as they are.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Roulette {
    /// The bound for how full the occupancy grid is at a step of a ray: what does not survive is no sample of T.
    pub samples: f32,
    /// The bound for |dL/dlog T| of a ray, for each sample of which it is the gradient.
    pub gradients: f32,
}

/// A scene whose tensors lie on a device. A clone is the same scene, on the same memory.
#[derive(Clone, Debug)]
pub struct DeviceScene {
    pub(super) device: Arc<Device>,
    pub(crate) config: SceneConfig,
    pub(crate) gaussians: u32,
    /// Eq. 13 divides sums above this: 1, or [never](Self::never_divide).
    pub(crate) divide_above: f32,
    /// See [`DeviceScene::with_ray_steps`].
    pub(crate) ray_steps: u32,
    /// See [`DeviceScene::with_roulette`].
    pub(crate) roulette: Roulette,
    pub(crate) scene_box: Buffer<f32>,
    pub(crate) tensors: Tensors<Buffer<f32>>,
    pub(crate) color: DeviceField,
    pub(crate) transmittance: DeviceField,
    pub(crate) occupancy: Occupancy,
    /// Where the scene lies in the coordinates of the one that it is [put](Self::put) beside.
    pub(crate) place: Placement,
    /// See [`DeviceScene::stand_on`].
    pub(crate) ground: Option<Ground>,
    /// The scenes that are shown with this one.
    pub(crate) beside: Vec<Self>,
    /// The other scenes' fields, with this scene's Gaussians: see [`composition`](super::composition).
    pub(crate) fields: Vec<Self>,
    /// Number of calls of [`DeviceScene::write`].
    pub(crate) version: Arc<AtomicU64>,
}

impl DeviceScene {
    /// The device that the scene is on.
    pub fn device(&self) -> &Device {
        &self.device
    }

    /// The scene's configuration.
    pub fn config(&self) -> &SceneConfig {
        &self.config
    }

    /// Says what the scene is trained on.
    pub fn set_trained_on(&mut self, trained_on: TrainedOn) {
        self.config.trained_on = Some(trained_on);
    }

    /// Each tensor's values. Writing to them changes the scene. A grid of 16-bit floats has no values here.
    pub fn tensors(&self) -> &Tensors<Buffer<f32>> {
        &self.tensors
    }

    /// How full the cells of the occupancy grid are, x fastest, with a border of empty cells; one value without a grid.
    pub fn occupancy(&self) -> &Buffer<f32> {
        &self.occupancy.table
    }

    /// Number of Gaussians.
    pub fn len(&self) -> usize {
        self.gaussians as usize
    }

    /// Whether there are no Gaussians; an empty scene is not uploaded.
    pub fn is_empty(&self) -> bool {
        self.gaussians == 0
    }

    /// Half the longest side of the scene's box, in world units.
    pub fn extent(&self) -> f64 {
        let [low, high] = self.config.aabb;
        (0..3).map(|axis| (high[axis] - low[axis]) / 2.0).fold(0.0, f64::max)
    }

    /// Bytes that the scene takes on the device.
    pub fn bytes(&self) -> u64 {
        let tensors: u64 = self.tensors.iter().map(|(_, buffer)| buffer.bytes()).sum();
        let fields = [&self.color, &self.transmittance].map(DeviceField::bytes_beside_tensors);
        tensors + fields.iter().sum::<u64>() + Occupancy::bytes(&self.config) as u64
    }

    /// Bytes that a scene takes on a device after [`Renderer::upload`](crate::Renderer::upload).
    pub fn bytes_of(scene: &Scene) -> u64 {
        let tensors: usize = pack(scene).iter().map(|(_, values)| size_of_val(&**values)).sum();
        let grids = [&scene.config.color_grid, &scene.config.transmittance_grid];
        let levels: u32 = grids.iter().map(|grid| grid.levels).sum();
        (tensors + levels as usize * size_of::<GridLevel>() + Occupancy::bytes(&scene.config))
            as u64
    }

    /// The scene as it is now.
    ///
    /// # Errors
    /// The same errors as [`Device::read`]; [`Error::Argument`](organza_core::Error::Argument) where the grids are
    /// halves.
    pub fn download(&self, device: &Device) -> Result<Scene> {
        self.require_gradients()?;
        let read = |buffer: &Buffer<f32>, values: &mut [f32]| device.read_into(buffer, 0, values);
        unpack(&self.config, self.len(), self.tensors.as_ref(), read)
    }

    /// Replaces a tensor's values, after everything that was dispatched before. `name` is a name of [`Scene::tensors`], such
    /// as `gaussians.position` or `color.mlp.0.weight`; values are row-major. Nothing is allocated on a CPU.
    ///
    /// A [`Tape`](crate::Tape) of the scene as it was before has no gradient anymore.
    ///
    /// # Errors
    /// [`Error::Argument`](organza_core::Error::Argument) where there is no such tensor, or where the scene was
    /// uploaded as halves; [`Error::Invalid`](organza_core::Error::Invalid) for another number of values, or one that is
    /// not finite; the same errors as [`Device::write`].
    pub fn write(&self, device: &Device, name: &str, values: &[f32]) -> Result<()> {
        self.require_gradients()?;
        let specs = self.config.tensors(self.len());
        let Some(spec) = specs.iter().find(|spec| spec.name == name) else {
            let names: Vec<_> = specs.iter().map(|spec| &*spec.name).collect();
            return argument(format!("a scene has no tensor `{name}`, only {}", names.join(", ")));
        };
        spec.check(values)?;
        self.version.fetch_add(1, Ordering::Relaxed);
        if let Some((_, buffer)) = self.tensors.iter().find(|(own, _)| *own == name) {
            device.write(buffer, 0, values)?;
            if name.starts_with("gaussians.") {
                self.update_occupancy(device)?;
            }
            return Ok(());
        }
        let (field, rest) = match name.strip_prefix("color.mlp.") {
            Some(rest) => (&self.color, rest),
            None => (&self.transmittance, name.trim_start_matches("transmittance.mlp.")),
        };
        let (layer, kind) = rest.split_once('.').expect("a layer's tensor");
        let place = &field.layers[layer.parse::<usize>().expect("a layer's number")];
        let parameters = field.parameters.view::<f32>();
        if kind == "bias" {
            return Ok(device.write(&parameters, place.bias_value(), values)?);
        }
        let mut packed = vec![0.0; place.weight_values().len()];
        place.pack_weight(values, &mut packed);
        Ok(device.write(&parameters, place.weight_values().start, &packed)?)
    }

    /// Replaces all Gaussians.
    ///
    /// # Errors
    /// The same errors as [`Device::upload`]. The scene is then not complete.
    pub fn replace_gaussians(&mut self, device: &Device, gaussians: &Gaussians) -> Result<()> {
        self.gaussians = 0;
        replace_gaussians(device, &mut self.tensors, gaussians)?;
        self.gaussians = gaussians.len() as u32;
        self.version = Arc::default();
        self.update_occupancy(device)
    }

    /// Recomputes the occupancy grid. Call it whenever Gaussians have moved.
    ///
    /// # Errors
    /// The same errors as [`Device::dispatch`].
    pub fn update_occupancy(&self, device: &Device) -> Result<()> {
        let gaussians = &self.tensors.gaussians;
        Ok(self.occupancy.update(device, &self.config, &self.scene_box, gaussians)?)
    }

    /// Turns off the division of Eq. 13, for comparisons.
    pub fn never_divide(&mut self) {
        self.divide_above = f32::MAX;
    }

    /// The blur that weights compensate for, in square pixels; 0 if they do not.
    pub(crate) fn compensated_blur(&self) -> f32 {
        if self.config.antialiased { self.config.blur as f32 } else { 0.0 }
    }

    /// The length of T's steps, in the unit cube.
    pub(crate) fn ray_step(&self) -> f64 {
        self.config.step * f64::from(self.ray_steps)
    }

    /// The same scene, on the same memory, with steps of T that are `ray_steps` times as long as sigma.
    pub(crate) fn with_ray_steps(&self, ray_steps: u32) -> Self {
        let mut seen = Self { ray_steps, ..self.clone() };
        for other in seen.beside.iter_mut().chain(&mut seen.fields) {
            *other = other.with_ray_steps(ray_steps);
        }
        seen
    }

    /// The same scene, on the same memory, for training.
    #[must_use]
    pub fn with_roulette(self, roulette: Roulette) -> Self {
        Self { roulette, ..self }
    }

    /// The same scene, on the same memory, for the coarse steps of a training: for images that are `factor` times smaller,
    /// with steps of T that are `ray_steps` times as long as sigma.
    ///
    /// A pixel is the mean of `factor` x `factor` pixels. Their positions have a variance of `(factor^2 - 1) / 12` along each
    /// axis. It is added to the blur, in square pixels of the smaller image.
    pub fn coarser(&self, factor: u32, ray_steps: u32) -> Self {
        let square = f64::from(factor).powi(2);
        let mut seen = self.with_ray_steps(ray_steps);
        seen.config.blur = (self.config.blur + (square - 1.0) / 12.0) / square;
        seen
    }
}
