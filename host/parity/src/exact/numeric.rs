//! The numbers of the equations.

pub use muslin_check::number::{Dual, Number, Rounded, gradient, listed};

/// `a . b`
pub fn dot<N: Number>(a: [N; 3], b: [N; 3]) -> N {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// `a x b`
pub fn cross<N: Number>(a: [N; 3], b: [N; 3]) -> [N; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Numbers of a tensor.
pub fn row<N: Number, const LEN: usize>(values: &[f32], index: usize) -> [N; LEN] {
    std::array::from_fn(|at| N::from(values[LEN * index + at].into()))
}
