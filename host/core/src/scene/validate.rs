//! Checks that a scene's tensors agree with its configuration.

use std::path::Path;

use super::Scene;
use super::spec::{MAX_VALUES, TensorSpec};
use crate::error::{Error, IN_MEMORY, Result};

impl TensorSpec {
    /// Checks that the number of values is right and that all are finite.
    pub fn check(&self, values: &[f32]) -> Result<()> {
        let origin = Path::new(IN_MEMORY);
        if values.len() != self.values() {
            return Err(wrong_shape(self, vec![values.len()], origin));
        }
        check_finite(self, values, origin)
    }
}

impl Scene {
    /// Checks that the configuration is in range, that there are Gaussians, that every tensor has the shape that the
    /// configuration gives it, and that every value is finite.
    ///
    /// # Errors
    /// [`Error::BadConfig`], [`Error::EmptyScene`], [`Error::WrongShape`], [`Error::TooManyValues`] or
    /// [`Error::NotFinite`], for the first problem found in that order.
    pub fn validate(&self) -> Result<()> {
        self.validate_at(Path::new(IN_MEMORY))
    }

    pub(super) fn validate_at(&self, origin: &Path) -> Result<()> {
        self.config.validate_at(origin)?;
        if self.gaussians.is_empty() {
            return Err(Error::EmptyScene { origin: origin.to_owned() });
        }
        self.check_layers(origin)?;
        let tensors = self.tensors();
        for (spec, data) in &tensors {
            if data.len() != spec.values() {
                return Err(wrong_shape(spec, vec![data.len()], origin));
            }
        }
        check_sizes(tensors.iter().map(|(spec, _)| spec), origin)?;
        tensors.iter().try_for_each(|(spec, data)| check_finite(spec, data, origin))
    }

    /// Checks the layers' widths. After that, [`Self::tensors`] is in the configuration's order.
    fn check_layers(&self, origin: &Path) -> Result<()> {
        let networks = [&self.color.network, &self.transmittance.network];
        for (network, field) in networks.into_iter().zip(self.config.fields()) {
            // Go on to the longer of the two: a layer that only one side has is a difference, too.
            for index in 0..network.layers.len().max(field.widths.len() - 1) {
                let layer = network.layers.get(index);
                let found = layer.map_or(Vec::new(), |layer| vec![layer.outputs, layer.inputs]);
                let pair = field.widths.get(index..index + 2);
                let expected = pair.map_or(Vec::new(), |pair| vec![pair[1], pair[0]]);
                if found != expected {
                    return Err(wrong_shape(&field.weight(index, expected), found, origin));
                }
            }
        }
        Ok(())
    }
}

fn wrong_shape(spec: &TensorSpec, found: Vec<usize>, origin: &Path) -> Error {
    Error::WrongShape {
        origin: origin.to_owned(),
        tensor: spec.name.clone(),
        found,
        expected: spec.shape.clone(),
        why: spec.why,
    }
}

/// Checks that the kernels can address every tensor.
pub(super) fn check_sizes<'a>(
    mut specs: impl Iterator<Item = &'a TensorSpec>,
    origin: &Path,
) -> Result<()> {
    match specs.find(|spec| spec.values() >= MAX_VALUES) {
        Some(spec) => Err(Error::TooManyValues {
            origin: origin.to_owned(),
            tensor: spec.name.clone(),
            values: spec.values(),
        }),
        None => Ok(()),
    }
}

fn check_finite(spec: &TensorSpec, data: &[f32], origin: &Path) -> Result<()> {
    match data.iter().position(|value| !value.is_finite()) {
        Some(index) => Err(Error::NotFinite {
            origin: origin.to_owned(),
            tensor: spec.name.clone(),
            index,
            value: data[index],
        }),
        None => Ok(()),
    }
}
