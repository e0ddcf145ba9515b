//! Names and shapes of the tensors in a scene file, and the reason for each shape.

use super::config::SceneConfig;
use super::grid::GridConfig;
use super::tensor_file::TensorRef;

/// Kernels address values with 32 bits, and one bit is kept free.
pub(super) const MAX_VALUES: usize = 1 << 31;

/// The declaration of one tensor in a scene file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TensorSpec {
    /// Name in the file.
    pub name: String,
    /// Shape, row-major.
    pub shape: Vec<usize>,
    /// The reason for the shape, for messages.
    pub why: &'static str,
}

impl TensorSpec {
    /// The tensor with its values, for writing.
    #[must_use]
    pub fn with_data<'a>(&'a self, data: &'a [f32]) -> TensorRef<'a> {
        TensorRef { name: &self.name, shape: &self.shape, data }
    }

    /// Number of values in the tensor.
    #[must_use]
    pub fn values(&self) -> usize {
        self.shape.iter().fold(1, |values, &size| values.saturating_mul(size))
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

    fn bias(&self, layer: usize, outputs: usize) -> TensorSpec {
        let name = format!("{}.mlp.{layer}.bias", self.name);
        TensorSpec { name, shape: vec![outputs], why: self.why[3] }
    }

    /// All tensors, in the order of [`Field::tensors`](super::Field::tensors).
    fn tensors(&self) -> Vec<TensorSpec> {
        let mut specs = vec![self.table()];
        for (layer, pair) in self.widths.windows(2).enumerate() {
            specs.push(self.weight(layer, vec![pair[1], pair[0]]));
            specs.push(self.bias(layer, pair[1]));
        }
        specs
    }
}

impl SceneConfig {
    /// Every tensor of a scene file with this configuration and `gaussians` Gaussians, in the order of
    /// [`Scene::tensors`](super::Scene::tensors).
    #[must_use]
    pub fn tensors(&self, gaussians: usize) -> Vec<TensorSpec> {
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
