//! The gradient of a loss with respect to every tensor of a scene.

use std::ops::Deref;
use std::path::Path;

use super::Scene;
use super::tensor_file::write_tensors;
use crate::error::{Error, Result};

/// Prefix of gradients' names in a file.
const PREFIX: &str = "grad.";

/// dL/dtensor for every tensor of a scene. It reads like the scene: `gradient.gaussians.position`.
#[derive(Clone, Debug, PartialEq)]
pub struct Gradient(Scene);

impl Deref for Gradient {
    type Target = Scene;

    fn deref(&self) -> &Scene {
        &self.0
    }
}

impl Gradient {
    /// A gradient from values in the shape of a scene.
    pub fn new(values: Scene) -> Self {
        Self(values)
    }

    /// The gradient of the tensor named `name`, such as `gaussians.position`, row-major.
    pub fn tensor(&self, name: &str) -> Option<&[f32]> {
        self.tensors().into_iter().find(|(spec, _)| spec.name == name).map(|(_, values)| values)
    }

    /// The values, in the shape of the scene.
    pub fn into_values(self) -> Scene {
        self.0
    }

    /// Writes a safetensors file with `grad.<tensor>` for each tensor of the scene, atomically.
    ///
    /// # Errors
    /// [`Error::Diverged`] if a value is not finite; [`Error::WriteFile`].
    pub fn save(&self, path: impl AsRef<Path>) -> Result<()> {
        for (spec, values) in self.tensors() {
            if let Some(index) = values.iter().position(|value| !value.is_finite()) {
                let name = spec.name;
                let value = values[index];
                let reason = format!(
                    "the gradient of `{name}` holds {value} at flat index {index}, more than f32 \
                     can hold; nothing was written"
                );
                return Err(Error::Diverged { reason });
            }
        }
        write_tensors(path, &self.0.tensors_with_prefix(PREFIX), &[])
    }
}
