//! One value for each tensor of a scene: a buffer, a gradient, an optimizer's moments, or a learning rate.

use std::convert::Infallible;

use super::config::SceneConfig;
use super::gaussians::GaussianTensors;
use super::grid::GridConfig;
use super::tensor_spec::TensorSpec;

/// One `T` for each tensor of a scene. All layers of a network are one tensor, as on a device.
///
/// The fields are named as in [`Scene`](super::Scene).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tensors<T> {
    /// The Gaussians' values.
    pub gaussians: GaussianTensors<T>,
    /// The color field's values.
    pub color: FieldTensors<T>,
    /// The transmittance field's values.
    pub transmittance: FieldTensors<T>,
}

/// One `T` for each tensor of a field.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FieldTensors<T> {
    /// The hash grid's table, `[entries, features]`.
    pub grid: T,
    /// All parameters of the network.
    pub network: T,
}

impl<T> Tensors<T> {
    /// Borrows each value.
    pub fn as_ref(&self) -> Tensors<&T> {
        Tensors {
            gaussians: self.gaussians.as_ref(),
            color: self.color.as_ref(),
            transmittance: self.transmittance.as_ref(),
        }
    }

    /// Calls `f` with each tensor's name and value, always in the same order. The names are as in a scene file.
    /// The networks are `color.mlp` and `transmittance.mlp`.
    ///
    /// # Errors
    /// The first error of `f`.
    pub fn try_map<U, E>(
        self,
        mut f: impl FnMut(&'static str, T) -> Result<U, E>,
    ) -> Result<Tensors<U>, E> {
        Ok(Tensors {
            gaussians: self.gaussians.try_map(&mut f)?,
            color: self.color.try_map(["color.grid", "color.mlp"], &mut f)?,
            transmittance: self
                .transmittance
                .try_map(["transmittance.grid", "transmittance.mlp"], &mut f)?,
        })
    }

    /// Like [`Tensors::try_map`], for an `f` that cannot fail.
    pub fn map<U>(self, mut f: impl FnMut(&'static str, T) -> U) -> Tensors<U> {
        let Ok(mapped) = self.try_map(|name, value| Ok::<_, Infallible>(f(name, value)));
        mapped
    }

    /// Pairs each value with the other's value for the same tensor.
    pub fn zip<U>(self, other: Tensors<U>) -> Tensors<(T, U)> {
        Tensors {
            gaussians: self.gaussians.zip(other.gaussians),
            color: self.color.zip(other.color),
            transmittance: self.transmittance.zip(other.transmittance),
        }
    }

    /// Each tensor's name and value.
    pub fn iter(&self) -> impl Iterator<Item = (&'static str, &T)> {
        self.as_ref().into_iter()
    }
}

impl<T> IntoIterator for Tensors<T> {
    type Item = (&'static str, T);
    type IntoIter = std::vec::IntoIter<Self::Item>;

    fn into_iter(self) -> Self::IntoIter {
        let mut list = Vec::new();
        self.map(|name, value| list.push((name, value)));
        list.into_iter()
    }
}

impl<T> FieldTensors<T> {
    /// Borrows each value.
    pub fn as_ref(&self) -> FieldTensors<&T> {
        FieldTensors { grid: &self.grid, network: &self.network }
    }

    /// Calls `f` with each tensor's name and value.
    ///
    /// # Errors
    /// The first error of `f`.
    pub fn try_map<U, E>(
        self,
        [grid, network]: [&'static str; 2],
        mut f: impl FnMut(&'static str, T) -> Result<U, E>,
    ) -> Result<FieldTensors<U>, E> {
        Ok(FieldTensors { grid: f(grid, self.grid)?, network: f(network, self.network)? })
    }

    /// Pairs each value with the other's value for the same tensor.
    pub fn zip<U>(self, other: FieldTensors<U>) -> FieldTensors<(T, U)> {
        FieldTensors { grid: (self.grid, other.grid), network: (self.network, other.network) }
    }
}

/// The configuration of one field of a scene.
pub(super) struct FieldSpec<'a> {
    /// Prefix of its tensors' names.
    name: &'static str,
    /// Configuration of the hash grid.
    pub grid: &'a GridConfig,
    /// Widths of the network: inputs, hidden layers, outputs.
    pub widths: Vec<usize>,
    /// Reasons for the tensors' shapes: the grid, the first weight, every other weight, every bias.
    why: [&'static str; 4],
}

impl FieldSpec<'_> {
    /// The grid's table.
    pub fn table(&self) -> TensorSpec {
        TensorSpec {
            name: format!("{}.grid", self.name),
            shape: vec![self.grid.entries(), self.grid.features as usize],
            why: self.why[0],
        }
    }

    /// The weights of a layer, counted from 0.
    pub fn weight(&self, layer: usize, shape: Vec<usize>) -> TensorSpec {
        let why = self.why[if layer == 0 { 1 } else { 2 }];
        TensorSpec { name: format!("{}.mlp.{layer}.weight", self.name), shape, why }
    }

    /// All tensors, in the order of [`Field::tensors`](super::Field::tensors).
    fn tensors(&self) -> Vec<TensorSpec> {
        let mut specs = vec![self.table()];
        for (layer, pair) in self.widths.windows(2).enumerate() {
            specs.push(self.weight(layer, vec![pair[1], pair[0]]));
            let name = format!("{}.mlp.{layer}.bias", self.name);
            specs.push(TensorSpec { name, shape: vec![pair[1]], why: self.why[3] });
        }
        specs
    }
}

impl SceneConfig {
    /// Every tensor of a scene file with this configuration and `gaussians` Gaussians, in the order of
    /// [`Scene::tensors`](super::Scene::tensors).
    pub fn tensors(&self, gaussians: usize) -> Vec<TensorSpec> {
        let mut specs = self.all_tensors(gaussians);
        specs.retain(TensorSpec::is_in_scene);
        specs
    }

    /// [`Self::tensors`], and those that a scene with this configuration does not have.
    pub(super) fn all_tensors(&self, gaussians: usize) -> Vec<TensorSpec> {
        let mut specs = self.gaussian_specs(gaussians).into_vec();
        specs.extend(self.fields().iter().flat_map(FieldSpec::tensors));
        specs
    }

    /// The color field and the transmittance field.
    pub(super) fn fields(&self) -> [FieldSpec<'_>; 2] {
        [
            FieldSpec {
                name: "color",
                grid: &self.color_grid,
                widths: self.color_widths(),
                why: [
                    "entries by features of config field `color_grid`",
                    "outputs by inputs; the inputs are (sh_degree + 1)^2, then levels * features of \
                     color_grid, then material",
                    "outputs by inputs, from config field `color_mlp.hidden`",
                    "outputs, from config field `color_mlp.hidden`",
                ],
            },
            FieldSpec {
                name: "transmittance",
                grid: &self.transmittance_grid,
                widths: self.transmittance_widths(),
                why: [
                    "entries by features of config field `transmittance_grid`",
                    "outputs by inputs; the inputs are levels * features of transmittance_grid, then \
                     extra",
                    "outputs by inputs, from config field `transmittance_mlp.hidden`",
                    "outputs, from config field `transmittance_mlp.hidden`",
                ],
            },
        ]
    }
}
