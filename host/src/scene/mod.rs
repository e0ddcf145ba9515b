//! A scene: Gaussians, two hash grids and two networks, and the file that holds them.

mod config;
mod file;
mod grid;
mod network;
mod spec;
mod tensor_file;
mod validate;
mod warnings;

#[cfg(test)]
mod tests;

pub use config::{
    COLOR_OUTPUTS, MAX_HIDDEN_LAYERS, MAX_HIDDEN_WIDTH, MAX_SAMPLES, MAX_SH_DEGREE, MAX_VECTOR,
    MlpConfig, SceneConfig, TRANSMITTANCE_OUTPUTS,
};
pub(crate) use file::read_scene;
pub use grid::{
    FEATURE_WIDTHS, GridConfig, GridLevelGeometry, Interpolation, MAX_LEVELS, MAX_LOG2_TABLE,
    MAX_RESOLUTION,
};
pub use network::{Field, Layer, Network};
pub use spec::{TensorId, TensorSpec};
pub use tensor_file::{Tensor, TensorRef, read_tensors, write_tensors};
pub(crate) use tensor_file::{read_metadata, read_tensors_from};

use crate::error::Result;
use crate::memory;

/// A scene: its configuration and all its tensors.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// Shapes and constants.
    pub config: SceneConfig,
    /// What is splatted.
    pub gaussians: Gaussians,
    /// The color grid and network.
    pub color: Field,
    /// The transmittance grid and network.
    pub transmittance: Field,
}

/// N Gaussians, one vector per attribute.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Gaussians {
    /// Centers in world space.
    pub position: Vec<[f32; 3]>,
    /// Quaternions w x y z, not normalized.
    pub rotation: Vec<[f32; 4]>,
    /// Natural logarithms of the scales along the rotated axes, in world units.
    pub log_scale: Vec<[f32; 3]>,
    /// Opacity logits.
    pub opacity: Vec<f32>,
    /// Material vectors, `[N, material]`, row-major.
    pub material: Vec<f32>,
    /// Extra vectors, `[N, extra]`, row-major.
    pub extra: Vec<f32>,
}

impl Gaussians {
    /// N, the number of Gaussians.
    #[must_use]
    pub fn len(&self) -> usize {
        self.position.len()
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.position.is_empty()
    }
}

impl Scene {
    /// A scene of `gaussians` Gaussians with every tensor zero: a start to fill in, or a place for
    /// gradients. Zero quaternions are no rotations, so such a scene renders as background.
    ///
    /// # Errors
    /// [`Error::BadConfig`](crate::error::Error::BadConfig);
    /// [`Error::TooManyValues`](crate::error::Error::TooManyValues) where a tensor would be larger
    /// than the kernels can address; [`Error::OutOfMemory`](crate::error::Error::OutOfMemory).
    pub fn zeros(config: SceneConfig, gaussians: usize) -> Result<Self> {
        config.validate()?;
        let specs = config.tensors(gaussians);
        validate::check_sizes(&specs, crate::error::IN_MEMORY.as_ref())?;
        let values: u64 = specs.iter().map(|spec| spec.values() as u64).sum();
        // All at once: each tensor alone may fit.
        memory::check(values * size_of::<f32>() as u64, "the scene")?;
        let field = |name: &str, grid: &GridConfig, widths: &[usize]| {
            let table = memory::zeros(grid.entries() * grid.features as usize, name)?;
            Ok(Field { grid: table, network: Network::zeros(widths) })
        };
        let vector = |name: &str, length: u32| memory::zeros(gaussians * length as usize, name);
        Ok(Self {
            gaussians: Gaussians {
                position: memory::zeros(gaussians, "gaussians.position")?,
                rotation: memory::zeros(gaussians, "gaussians.rotation")?,
                log_scale: memory::zeros(gaussians, "gaussians.log_scale")?,
                opacity: memory::zeros(gaussians, "gaussians.opacity")?,
                material: vector("gaussians.material", config.material)?,
                extra: vector("gaussians.extra", config.extra)?,
            },
            color: field("color.grid", &config.color_grid, &config.color_widths())?,
            transmittance: field(
                "transmittance.grid",
                &config.transmittance_grid,
                &config.transmittance_widths(),
            )?,
            config,
        })
    }

    /// Every tensor's values, row-major, in the order of [`SceneConfig::tensors`].
    #[must_use]
    pub fn tensors(&self) -> Vec<(TensorId, &[f32])> {
        use TensorId as Id;
        let gaussians = &self.gaussians;
        let mut tensors = vec![
            (Id::Position, gaussians.position.as_flattened()),
            (Id::Rotation, gaussians.rotation.as_flattened()),
            (Id::LogScale, gaussians.log_scale.as_flattened()),
            (Id::Opacity, &gaussians.opacity),
            (Id::Material, &gaussians.material),
            (Id::Extra, &gaussians.extra),
            (Id::ColorGrid, &self.color.grid),
            (Id::TransmittanceGrid, &self.transmittance.grid),
        ];
        for (index, layer) in self.color.network.layers.iter().enumerate() {
            tensors.push((Id::ColorWeight(index), &layer.weight));
            tensors.push((Id::ColorBias(index), &layer.bias));
        }
        for (index, layer) in self.transmittance.network.layers.iter().enumerate() {
            tensors.push((Id::TransmittanceWeight(index), &layer.weight));
            tensors.push((Id::TransmittanceBias(index), &layer.bias));
        }
        tensors
    }

    /// Every tensor's values for writing, in the order of [`Self::tensors`].
    #[must_use]
    pub fn tensors_mut(&mut self) -> Vec<(TensorId, &mut [f32])> {
        use TensorId as Id;
        let gaussians = &mut self.gaussians;
        let mut tensors = vec![
            (Id::Position, gaussians.position.as_flattened_mut()),
            (Id::Rotation, gaussians.rotation.as_flattened_mut()),
            (Id::LogScale, gaussians.log_scale.as_flattened_mut()),
            (Id::Opacity, &mut gaussians.opacity),
            (Id::Material, &mut gaussians.material),
            (Id::Extra, &mut gaussians.extra),
            (Id::ColorGrid, &mut self.color.grid),
            (Id::TransmittanceGrid, &mut self.transmittance.grid),
        ];
        for (index, layer) in self.color.network.layers.iter_mut().enumerate() {
            tensors.push((Id::ColorWeight(index), &mut layer.weight));
            tensors.push((Id::ColorBias(index), &mut layer.bias));
        }
        for (index, layer) in self.transmittance.network.layers.iter_mut().enumerate() {
            tensors.push((Id::TransmittanceWeight(index), &mut layer.weight));
            tensors.push((Id::TransmittanceBias(index), &mut layer.bias));
        }
        tensors
    }
}
