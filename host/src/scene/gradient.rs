//! The gradient of a loss with respect to every tensor of a scene.

use std::path::Path;

use super::gaussians::Gaussians;
use super::network::Field;
use super::spec::TensorSpec;
use super::tensor_file::write_tensors;
use super::{Scene, SceneConfig};
use crate::error::{Error, Result};

/// What the names of gradients begin with in a file.
const PREFIX: &str = "grad.";

/// dLoss/dtensor for every tensor of a scene, in the shape of the scene.
///
/// ```
/// use organza::{DeviceOptions, Renderer, Tile, TileBatch, demo};
///
/// let renderer = Renderer::new(organza::open_device(&DeviceOptions::cpu(None))?);
/// let scene = renderer.upload(&demo::scene())?;
/// let cameras = demo::turntable(1, 32);
/// let batch = TileBatch { side: 8, tiles: vec![Tile { camera: 0, origin: [12, 12] }] };
///
/// // the loss is the sum of all values, so dL/dY is 1 everywhere
/// let ones = vec![1.0; batch.output_shape().iter().product()];
/// let gradient = renderer.gradient(&scene, &cameras, &batch, &ones)?;
/// assert_eq!(gradient.gaussians().position.len(), scene.len());
/// assert!(gradient.tensor("gaussians.opacity").is_some_and(|g| g.iter().any(|&g| g != 0.0)));
/// # Ok::<(), organza::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Gradient(Scene);

impl Gradient {
    /// From values in the shape of a scene.
    pub(crate) fn of(values: Scene) -> Self {
        Self(values)
    }

    /// The configuration of the scene that it is a gradient of.
    #[must_use]
    pub fn config(&self) -> &SceneConfig {
        &self.0.config
    }

    /// Of the Gaussians.
    #[must_use]
    pub fn gaussians(&self) -> &Gaussians {
        &self.0.gaussians
    }

    /// Of the color grid and network.
    #[must_use]
    pub fn color(&self) -> &Field {
        &self.0.color
    }

    /// Of the transmittance grid and network.
    #[must_use]
    pub fn transmittance(&self) -> &Field {
        &self.0.transmittance
    }

    /// The name and shape of every tensor of the scene, and its gradient, row-major.
    #[must_use]
    pub fn tensors(&self) -> Vec<(TensorSpec, &[f32])> {
        self.0.tensors()
    }

    /// The gradient of the tensor with a name, such as `gaussians.position`, row-major.
    #[must_use]
    pub fn tensor(&self, name: &str) -> Option<&[f32]> {
        self.tensors().into_iter().find(|(spec, _)| spec.name == name).map(|(_, values)| values)
    }

    /// The values, in the shape of the scene that it is a gradient of.
    #[must_use]
    pub fn into_values(self) -> Scene {
        self.0
    }

    /// Writes a safetensors file with `grad.<tensor>` for each tensor of the scene, atomically.
    ///
    /// # Errors
    /// [`Error::Diverged`] where a value is not finite; [`Error::WriteFile`].
    pub fn save(&self, path: impl AsRef<Path>) -> Result<()> {
        for (spec, values) in self.tensors() {
            if let Some(index) = values.iter().position(|value| !value.is_finite()) {
                let (name, value) = (spec.name, values[index]);
                let reason = format!(
                    "the gradient of `{name}` holds {value} at flat index {index}, more than f32 \
                     can hold; nothing was written"
                );
                return Err(Error::Diverged { reason });
            }
        }
        let tensors = self.0.tensors_with_prefix(PREFIX);
        let tensors: Vec<_> = tensors.iter().map(|(spec, data)| spec.of(data)).collect();
        write_tensors(path, &tensors, &[])
    }
}
