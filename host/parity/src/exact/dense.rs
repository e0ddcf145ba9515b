//! Dense layers (Eq. 2 and 10).

use super::numeric::Number;

/// An output of a layer before its activation: `w . x + b`, w its row of W.
pub fn affine<N: Number>(weights: &[N], bias: N, inputs: &[N]) -> N {
    assert_eq!(weights.len(), inputs.len(), "weights and inputs");
    weights.iter().zip(inputs).fold(bias, |sum, (&w, &x)| sum + w * x)
}

/// max(x, 0)
pub fn relu<N: Number>(x: N) -> N {
    x.above(0.0, x, N::from(0.0))
}
