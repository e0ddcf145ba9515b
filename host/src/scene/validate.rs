//! Whether a scene's tensors agree with its configuration.

use std::path::Path;

use super::spec::{MAX_VALUES, TensorId, TensorSpec};
use super::{Network, Scene};
use crate::error::{Error, IN_MEMORY, Result};

impl Scene {
    /// Checks that the configuration is in range, that there are Gaussians, that every tensor has
    /// the shape the configuration gives it, and that every value is finite.
    ///
    /// # Errors
    /// [`Error::BadConfig`], [`Error::EmptyScene`], [`Error::WrongShape`],
    /// [`Error::TooManyValues`], [`Error::NotFinite`], for the first thing found in that order.
    pub fn validate(&self) -> Result<()> {
        self.validate_at(Path::new(IN_MEMORY))
    }

    pub(super) fn validate_at(&self, origin: &Path) -> Result<()> {
        self.config.validate_at(origin)?;
        if self.gaussians.is_empty() {
            return Err(Error::EmptyScene { origin: origin.to_owned() });
        }
        self.check_layers(origin)?;
        let specs = self.config.tensors(self.gaussians.len());
        let tensors = self.tensors();
        for (spec, (_, data)) in specs.iter().zip(&tensors) {
            if data.len() != spec.values() {
                return Err(wrong_shape(spec.id, vec![data.len()], spec.shape.clone(), origin));
            }
        }
        check_sizes(&specs, origin)?;
        for (id, data) in tensors {
            check_finite(id, data, origin)?;
        }
        Ok(())
    }

    /// Checks the layers' widths, after which [`Self::tensors`] has the configuration's order.
    fn check_layers(&self, origin: &Path) -> Result<()> {
        type Id = fn(usize) -> TensorId;
        let networks: [(&Network, Vec<usize>, Id); 2] = [
            (&self.color.network, self.config.color_widths(), TensorId::ColorWeight),
            (
                &self.transmittance.network,
                self.config.transmittance_widths(),
                TensorId::TransmittanceWeight,
            ),
        ];
        for (network, widths, id) in networks {
            // To the longer of the two: a layer that only one side has is a difference too.
            for index in 0..network.layers.len().max(widths.len() - 1) {
                let layer = network.layers.get(index);
                let found = layer.map_or(Vec::new(), |layer| vec![layer.outputs, layer.inputs]);
                let pair = widths.get(index..index + 2);
                let expected = pair.map_or(Vec::new(), |pair| vec![pair[1], pair[0]]);
                if found != expected {
                    return Err(wrong_shape(id(index), found, expected, origin));
                }
            }
        }
        Ok(())
    }
}

fn wrong_shape(id: TensorId, found: Vec<usize>, expected: Vec<usize>, origin: &Path) -> Error {
    Error::WrongShape {
        origin: origin.to_owned(),
        tensor: id.name(),
        found,
        expected,
        why: id.why(),
    }
}

/// Checks that the kernels can address every tensor.
pub(super) fn check_sizes(specs: &[TensorSpec], origin: &Path) -> Result<()> {
    match specs.iter().find(|spec| spec.values() >= MAX_VALUES) {
        Some(spec) => Err(Error::TooManyValues {
            origin: origin.to_owned(),
            tensor: spec.name.clone(),
            values: spec.values(),
        }),
        None => Ok(()),
    }
}

fn check_finite(id: TensorId, data: &[f32], origin: &Path) -> Result<()> {
    match data.iter().position(|value| !value.is_finite()) {
        Some(index) => Err(Error::NotFinite {
            origin: origin.to_owned(),
            tensor: id.name(),
            index,
            value: data[index],
        }),
        None => Ok(()),
    }
}
