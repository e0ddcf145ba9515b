//! Dense layers (Eq. 2 and 10).

use super::numeric::Number;
use organza_core::scene::Network;

/// An output of a layer before its activation: `w . x + b`, w its row of W.
pub fn affine<N: Number>(weights: &[N], bias: N, inputs: &[N]) -> N {
    assert_eq!(weights.len(), inputs.len(), "weights and inputs");
    weights.iter().zip(inputs).fold(bias, |sum, (&w, &x)| sum + w * x)
}

/// max(x, 0)
pub fn relu<N: Number>(x: N) -> N {
    x.above(0.0, x, N::from(0.0))
}

/// A whole network: ReLU after every layer but the last.
pub fn network(network: &Network, mut values: Vec<f64>) -> Vec<f64> {
    let wide = |row: &[f32]| row.iter().copied().map(f64::from).collect::<Vec<_>>();
    for (index, layer) in network.layers.iter().enumerate() {
        let rows = layer.weight.chunks_exact(layer.inputs).zip(&layer.bias);
        let is_hidden = index + 1 < network.layers.len();
        values = rows
            .map(|(row, &bias)| affine(&wide(row), f64::from(bias), &values))
            .map(|x| if is_hidden { relu(x) } else { x })
            .collect();
    }
    values
}
