//! The one table of a scene's tensors: their names, their shapes and why they have them.

use super::config::SceneConfig;

/// The kernels address values with 32 bits, of which one is kept free.
pub(super) const MAX_VALUES: usize = 1 << 31;

/// Which tensor of a scene. Layers are counted from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum TensorId {
    /// Centers in world space, `[N, 3]`.
    Position,
    /// Quaternions w x y z, not normalized, `[N, 4]`.
    Rotation,
    /// Natural logarithms of the scales, `[N, 3]`.
    LogScale,
    /// Opacity logits, `[N]`.
    Opacity,
    /// Material vectors, `[N, M]`.
    Material,
    /// Extra vectors, `[N, U]`.
    Extra,
    /// The color grid's table, `[entries, features]`.
    ColorGrid,
    /// The transmittance grid's table, `[entries, features]`.
    TransmittanceGrid,
    /// Weights of a layer of the color network, `[outputs, inputs]`.
    ColorWeight(usize),
    /// Biases of a layer of the color network, `[outputs]`.
    ColorBias(usize),
    /// Weights of a layer of the transmittance network, `[outputs, inputs]`.
    TransmittanceWeight(usize),
    /// Biases of a layer of the transmittance network, `[outputs]`.
    TransmittanceBias(usize),
}

/// The name and shape of one tensor.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TensorSpec {
    /// Which tensor.
    pub id: TensorId,
    /// Its name in a scene file.
    pub name: String,
    /// Its shape, row-major.
    pub shape: Vec<usize>,
}

impl TensorId {
    /// The tensor's name in a scene file.
    #[must_use]
    pub fn name(self) -> String {
        match self {
            Self::Position => "gaussians.position".to_owned(),
            Self::Rotation => "gaussians.rotation".to_owned(),
            Self::LogScale => "gaussians.log_scale".to_owned(),
            Self::Opacity => "gaussians.opacity".to_owned(),
            Self::Material => "gaussians.material".to_owned(),
            Self::Extra => "gaussians.extra".to_owned(),
            Self::ColorGrid => "color.grid".to_owned(),
            Self::TransmittanceGrid => "transmittance.grid".to_owned(),
            Self::ColorWeight(layer) => format!("color.mlp.{layer}.weight"),
            Self::ColorBias(layer) => format!("color.mlp.{layer}.bias"),
            Self::TransmittanceWeight(layer) => format!("transmittance.mlp.{layer}.weight"),
            Self::TransmittanceBias(layer) => format!("transmittance.mlp.{layer}.bias"),
        }
    }

    /// Where the tensor's shape comes from, for messages.
    pub(super) fn why(self) -> &'static str {
        match self {
            Self::Position => "x, y, z of each Gaussian",
            Self::Rotation => "a quaternion w, x, y, z for each Gaussian of gaussians.position",
            Self::LogScale => "three scales for each Gaussian of gaussians.position",
            Self::Opacity => "one logit for each Gaussian of gaussians.position",
            Self::Material => "config field `material` values for each Gaussian",
            Self::Extra => "config field `extra` values for each Gaussian",
            Self::ColorGrid => "entries by features of config field `color_grid`",
            Self::TransmittanceGrid => "entries by features of config field `transmittance_grid`",
            Self::ColorWeight(0) => {
                "outputs by inputs; the inputs are (sh_degree + 1)^2, then levels * features of \
                 color_grid, then material"
            }
            Self::TransmittanceWeight(0) => {
                "outputs by inputs; the inputs are levels * features of transmittance_grid, then \
                 extra"
            }
            Self::ColorWeight(_) => "outputs by inputs, from config field `color_mlp.hidden`",
            Self::TransmittanceWeight(_) => {
                "outputs by inputs, from config field `transmittance_mlp.hidden`"
            }
            Self::ColorBias(_) => "outputs, from config field `color_mlp.hidden`",
            Self::TransmittanceBias(_) => "outputs, from config field `transmittance_mlp.hidden`",
        }
    }
}

impl TensorSpec {
    fn new(id: TensorId, shape: &[usize]) -> Self {
        Self { id, name: id.name(), shape: shape.to_vec() }
    }

    /// How many values the tensor holds.
    #[must_use]
    pub fn values(&self) -> usize {
        self.shape.iter().fold(1, |values, &size| values.saturating_mul(size))
    }
}

impl SceneConfig {
    /// Every tensor of a scene with this configuration and `gaussians` Gaussians, in the order of
    /// [`Scene::tensors`](super::Scene::tensors).
    #[must_use]
    pub fn tensors(&self, gaussians: usize) -> Vec<TensorSpec> {
        use TensorId as Id;
        let spec = TensorSpec::new;
        let grid = |id, config: &super::GridConfig| {
            spec(id, &[config.entries(), config.features as usize])
        };
        let mut specs = vec![
            spec(Id::Position, &[gaussians, 3]),
            spec(Id::Rotation, &[gaussians, 4]),
            spec(Id::LogScale, &[gaussians, 3]),
            spec(Id::Opacity, &[gaussians]),
            spec(Id::Material, &[gaussians, self.material as usize]),
            spec(Id::Extra, &[gaussians, self.extra as usize]),
            grid(Id::ColorGrid, &self.color_grid),
            grid(Id::TransmittanceGrid, &self.transmittance_grid),
        ];
        let mut network = |widths: Vec<usize>, weight: fn(_) -> _, bias: fn(_) -> _| {
            for (layer, pair) in widths.windows(2).enumerate() {
                specs.push(spec(weight(layer), &[pair[1], pair[0]]));
                specs.push(spec(bias(layer), &[pair[1]]));
            }
        };
        network(self.color_widths(), Id::ColorWeight, Id::ColorBias);
        network(self.transmittance_widths(), Id::TransmittanceWeight, Id::TransmittanceBias);
        specs
    }
}
