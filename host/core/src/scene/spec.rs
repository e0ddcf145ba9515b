//! The names and shapes of a scene file's tensors, and why they have them.

use super::config::SceneConfig;
use super::grid::GridConfig;
use super::tensor_file::TensorRef;

/// The kernels address values with 32 bits, of which one is kept free.
pub(super) const MAX_VALUES: usize = 1 << 31;

/// What a scene file says about one tensor.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TensorSpec {
    /// Its name in the file.
    pub name: String,
    /// Its shape, row-major.
    pub shape: Vec<usize>,
    /// Where the shape comes from, for messages.
    pub why: &'static str,
}

impl TensorSpec {
    /// The tensor with these values, for writing.
    #[must_use]
    pub fn of<'a>(&'a self, data: &'a [f32]) -> TensorRef<'a> {
        TensorRef { name: &self.name, shape: &self.shape, data }
    }

    /// How many values the tensor holds.
    #[must_use]
    pub fn values(&self) -> usize {
        self.shape.iter().fold(1, |values, &size| values.saturating_mul(size))
    }
}

/// A field of a scene as the configuration has it.
pub(super) struct FieldSpec<'a> {
    /// What the names of its tensors begin with.
    name: &'static str,
    /// Its hash grid.
    pub grid: &'a GridConfig,
    /// Its network: the inputs, the hidden layers, the outputs.
    pub widths: Vec<usize>,
    /// Why the tensors have their shapes: the grid, the first weight, every other weight, every bias.
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

    /// A layer's weights; layers are counted from 0.
    pub fn weight(&self, layer: usize, shape: Vec<usize>) -> TensorSpec {
        let why = self.why[if layer == 0 { 1 } else { 2 }];
        TensorSpec { name: format!("{}.mlp.{layer}.weight", self.name), shape, why }
    }

    fn bias(&self, layer: usize, outputs: usize) -> TensorSpec {
        let name = format!("{}.mlp.{layer}.bias", self.name);
        TensorSpec { name, shape: vec![outputs], why: self.why[3] }
    }

    /// All its tensors, in the order of [`Field::tensors`](super::Field::tensors).
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
