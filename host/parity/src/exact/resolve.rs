//! Eq. 13: pixels from their sums.

use super::numeric::Number;

/// A channel of a pixel, from C and S.
pub fn pixel<N: Number>(color: N, weight: N, background: f64) -> N {
    let covered = color + (N::from(1.0) - weight) * N::from(background);
    weight.above(1.0, color / weight, covered)
}
