//! A scene: Gaussians, two hash grids and two networks, and the file that holds them.

mod config;
mod file;
mod gaussians;
mod gradient;
mod grid;
mod ground;
mod network;
mod placement;
mod tensor_file;
mod tensor_spec;
mod tensors;
mod trained_on;
mod validate;

#[cfg(test)]
mod tests;

pub use config::{
    COLOR_OUTPUTS, Contraction, MAX_HIDDEN_LAYERS, MAX_HIDDEN_WIDTH, MAX_OCCUPANCY, MAX_SAMPLES,
    MAX_SH_DEGREE, MAX_VECTOR, MlpConfig, SLOPE, SceneConfig, TRANSMITTANCE_OUTPUTS,
};
pub use file::scene_metadata;
pub use gaussians::{GaussianTensors, Gaussians, along_a_curve, logit};
pub use gradient::Gradient;
pub use grid::{
    FEATURE_WIDTHS, GridConfig, GridLevelGeometry, MAX_LEVELS, MAX_LOG2_TABLE, MAX_RESOLUTION,
};
pub use ground::Ground;
pub use network::{Field, Layer, Network};
pub use placement::{Place, Placement};
pub use tensor_file::{
    Tensor, read_metadata, read_tensor, read_tensors, read_tensors_from, tensors_to_bytes,
    write_tensors,
};
pub use tensor_spec::TensorSpec;
pub use tensors::{FieldTensors, Tensors};
pub use trained_on::TrainedOn;

use std::path::Path;

use crate::camera::Camera;
use crate::error::Result;
use muslin_error::memory;

/// A scene: its configuration and all its tensors.
///
/// ```
/// use organza_core::{Scene, demo};
///
/// let mut scene = demo::scene();
/// // makes every Gaussian smaller by a tenth
/// for log_scale in scene.gaussians.log_scale.as_flattened_mut() {
///     *log_scale += 0.9_f32.ln();
/// }
///
/// let folder = tempfile::tempdir().expect("a folder");
/// let path = folder.path().join("scene.safetensors");
/// scene.save(&path)?;
/// assert_eq!(Scene::load(&path)?, scene);
/// # Ok::<(), organza_core::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// Shapes and constants.
    pub config: SceneConfig,
    /// The Gaussians to be splatted.
    pub gaussians: Gaussians,
    /// The color grid and network.
    pub color: Field,
    /// The transmittance grid and network.
    pub transmittance: Field,
}

impl Scene {
    /// The box to look at, which has nearly all of the opacity: see [`bounds`]. `config.aabb` is larger.
    pub fn visible_box(&self) -> [[f64; 3]; 2] {
        let Gaussians { position, log_scale, opacity, .. } = &self.gaussians;
        bounds(position, log_scale, opacity)
    }

    /// Reads cameras of the world, as [`Camera::load_all`] does, into this scene. A scene has coordinates of its own: see
    /// [`Placement`].
    ///
    /// # Errors
    /// The same errors as [`Camera::load_all`].
    pub fn load_cameras(&self, path: impl AsRef<Path>) -> Result<Vec<Camera>> {
        self.config.placement.load_cameras(path)
    }

    /// A scene of `gaussians` Gaussians in which every tensor is zero: a start to fill in, or storage for gradients.
    /// Zero quaternions are not rotations, so such a scene renders as background.
    ///
    /// # Errors
    /// [`Error::BadConfig`](crate::error::Error::BadConfig); [`Error::Invalid`](crate::error::Error::Invalid) for one that would
    /// be larger than the kernels can address; [`DeviceError::OutOfMemory`](crate::error::DeviceError::OutOfMemory).
    pub fn zeros(config: SceneConfig, gaussians: usize) -> Result<Self> {
        config.validate()?;
        let specs = config.tensors(gaussians);
        validate::check_sizes(specs.iter())?;
        let values: u64 = specs.iter().map(|spec| spec.values() as u64).sum();
        // Checks all tensors together: each alone may fit.
        memory::check(values * size_of::<f32>() as u64, "the scene")?;
        let [color, transmittance] = config.fields().map(|spec| -> Result<Field> {
            let table = spec.table();
            let grid = memory::zeros(table.values(), &table.name)?;
            Ok(Field { grid, network: Network::zeros(&spec.widths) })
        });
        Ok(Self {
            gaussians: Gaussians::zeros(&config, gaussians)?,
            color: color?,
            transmittance: transmittance?,
            config,
        })
    }

    /// Every tensor in the scene's file with its values, row-major, in the order of [`SceneConfig::tensors`].
    pub fn tensors(&self) -> Vec<(TensorSpec, &[f32])> {
        let specs = self.config.all_tensors(self.gaussians.len());
        let fields = [&self.color, &self.transmittance].into_iter().flat_map(Field::tensors);
        let values = self.gaussians.tensors().into_vec().into_iter().chain(fields);
        specs.into_iter().zip(values).filter(|(spec, _)| spec.is_in_scene()).collect()
    }

    /// Like [`Self::tensors`], with `prefix` before each name: for a file that is not a scene.
    pub fn tensors_with_prefix(&self, prefix: &str) -> Vec<(TensorSpec, &[f32])> {
        let mut tensors = self.tensors();
        tensors.iter_mut().for_each(|(spec, _)| spec.name.insert_str(0, prefix));
        tensors
    }

    /// Like [`Self::tensors`], but mutable.
    pub fn tensors_mut(&mut self) -> Vec<(TensorSpec, &mut [f32])> {
        let specs = self.config.all_tensors(self.gaussians.len());
        let fields =
            [&mut self.color, &mut self.transmittance].into_iter().flat_map(Field::tensors_mut);
        let values = self.gaussians.tensors_mut().into_vec().into_iter().chain(fields);
        specs.into_iter().zip(values).filter(|(spec, _)| spec.is_in_scene()).collect()
    }
}

/// Part of the opacity that [`bounds`] leaves out at each end of an axis.
const LEFT_OUT: f64 = 0.01;
/// Standard deviations that a Gaussian reaches.
const SUPPORT: f64 = 3.0;

/// The box of nearly all of the opacity: opacities weight the Gaussians, so a few far, large and faint ones do not matter.
/// The box has a margin for a Gaussian of median size. Opacities are logits, scales are logarithms.
pub fn bounds(position: &[[f32; 3]], log_scale: &[[f32; 3]], opacity: &[f32]) -> [[f64; 3]; 2] {
    let weight = opacity.iter().map(|logit| 1.0 / (1.0 + f64::from(-logit).exp()));
    let weight: Vec<_> = weight.collect();
    let total: f64 = weight.iter().sum();
    let largest = log_scale.iter().map(|scale| scale.iter().copied().fold(f32::MIN, f32::max));
    let [middle] = quantiles(largest.zip(weight.iter().copied()), [0.5 * total]);
    let margin = SUPPORT * middle.exp();
    let ends: [[f64; 2]; 3] = std::array::from_fn(|axis| {
        let places = position.iter().map(|place| place[axis]).zip(weight.iter().copied());
        quantiles(places, [LEFT_OUT, 1.0 - LEFT_OUT].map(|part| part * total))
    });
    [ends.map(|[low, _]| low - margin), ends.map(|[_, high]| high + margin)]
}

/// Whether a place lies in a box along the axes, whose surface belongs to it: its corners with the smallest and the largest coordinates.
pub fn is_in_box([low, high]: [[f32; 3]; 2], place: [f32; 3]) -> bool {
    (0..3).all(|axis| (low[axis]..=high[axis]).contains(&place[axis]))
}

/// Weighted quantiles: the values at which the summed weights reach the given parts; 0 without values.
fn quantiles<const N: usize>(
    values: impl Iterator<Item = (f32, f64)>,
    weights: [f64; N],
) -> [f64; N] {
    let mut values: Vec<_> = values.collect();
    values.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
    weights.map(|weight| {
        let mut sum = 0.0;
        let found = values.iter().find(|(_, own)| {
            sum += own;
            sum >= weight
        });
        found.map_or(0.0, |(value, _)| f64::from(*value))
    })
}
