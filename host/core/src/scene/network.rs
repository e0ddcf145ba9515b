//! Dense networks and the fields they form with a hash grid.

/// A hash grid and the network that reads it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Field {
    /// The grid's table, `[entries, features]`, row-major, level after level.
    pub grid: Vec<f32>,
    /// The network.
    pub network: Network,
}

/// Dense layers: ReLU after every one but the last, which is linear.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Network {
    /// The layers, first to last.
    pub layers: Vec<Layer>,
}

/// One dense layer, `W x + b`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Layer {
    /// W, `[outputs, inputs]`, row-major, as PyTorch stores it.
    pub weight: Vec<f32>,
    /// b, `[outputs]`.
    pub bias: Vec<f32>,
    /// Number of inputs.
    pub inputs: usize,
    /// Number of outputs.
    pub outputs: usize,
}

impl Field {
    /// The values of every tensor: the grid's, then each layer's weight and bias.
    pub(super) fn tensors(&self) -> Vec<&[f32]> {
        let layers = self.network.layers.iter();
        let layers = layers.flat_map(|layer| [&layer.weight[..], &layer.bias]);
        std::iter::once(&self.grid[..]).chain(layers).collect()
    }

    /// Like [`Field::tensors`], but mutable.
    pub(super) fn tensors_mut(&mut self) -> Vec<&mut [f32]> {
        let layers = self.network.layers.iter_mut();
        let layers = layers.flat_map(|layer| [&mut layer.weight[..], &mut layer.bias]);
        std::iter::once(&mut self.grid[..]).chain(layers).collect()
    }
}

impl Network {
    /// A network of zeros. `widths` has the form of [`Self::widths`]:
    /// [`SceneConfig::color_widths`](super::SceneConfig::color_widths), for example.
    pub fn zeros(widths: &[usize]) -> Self {
        Self { layers: widths.windows(2).map(|pair| Layer::zeros(pair[0], pair[1])).collect() }
    }

    /// The number of inputs of each layer, then the number of outputs of the last layer.
    pub fn widths(&self) -> Vec<usize> {
        let inputs = self.layers.iter().map(|layer| layer.inputs);
        inputs.chain(self.layers.last().map(|layer| layer.outputs)).collect()
    }
}

impl Layer {
    /// A layer of zeros.
    pub fn zeros(inputs: usize, outputs: usize) -> Self {
        Self { weight: vec![0.0; inputs * outputs], bias: vec![0.0; outputs], inputs, outputs }
    }
}
