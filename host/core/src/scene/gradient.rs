//! The gradient of a loss with respect to every tensor of a scene.

use std::ops::Deref;
use std::path::Path;

use super::Scene;
use super::tensor_file::write_tensors;
use crate::error::{Error, Result};
use crate::ranks::Ranks;

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

    /// Gathers the gradients of ranks' [shards](super::SceneShard). Rank 0 gets the gradient of the whole scene,
    /// other ranks get `None`.
    ///
    /// # Errors
    /// The same errors as [`Scene::zeros`] and [`Ranks::max`].
    pub fn gather(self, ranks: &dyn Ranks) -> Result<Option<Self>> {
        let mine = self.0.gaussians.tensors().into_vec();
        let mut for_each = vec![Vec::new(); ranks.size()];
        for_each[0] =
            mine.iter().flat_map(|values| bytemuck::cast_slice(values)).copied().collect();
        let all = ranks.exchange(for_each)?;
        if ranks.rank() > 0 {
            return Ok(None);
        }
        let widths = self.0.config.gaussian_specs(1).map(|spec| size_of::<f32>() * spec.values());
        let widths = widths.into_vec();
        let row: usize = widths.iter().sum();
        let lens = all.iter().map(|bytes| bytes.len() / row);
        let mut whole = Scene::zeros(self.0.config, lens.clone().sum())?;
        let mut begin = 0;
        for (bytes, len) in all.iter().zip(lens) {
            let mut rest = &bytes[..];
            for (target, width) in whole.gaussians.tensors_mut().into_vec().into_iter().zip(&widths)
            {
                let (values, after) = rest.split_at(width * len);
                let target: &mut [u8] = bytemuck::cast_slice_mut(target);
                target[begin * width..][..values.len()].copy_from_slice(values);
                rest = after;
            }
            begin += len;
        }
        whole.color = self.0.color;
        whole.transmittance = self.0.transmittance;
        Ok(Some(Self(whole)))
    }

    /// The gradient of the tensor named `name`, such as `gaussians.position`, row-major.
    #[must_use]
    pub fn tensor(&self, name: &str) -> Option<&[f32]> {
        self.tensors().into_iter().find(|(spec, _)| spec.name == name).map(|(_, values)| values)
    }

    /// The values, in the shape of the scene.
    #[must_use]
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
        let tensors = self.0.tensors_with_prefix(PREFIX);
        let tensors: Vec<_> = tensors.iter().map(|(spec, data)| spec.with_data(data)).collect();
        write_tensors(path, &tensors, &[])
    }
}
