//! The space of the networks and the rays.

use super::numeric::Number;

/// A point of the world in the unit cube's space: `x' = 0.05 + 0.9 (x - lo) / (hi - lo)` for each axis, and
/// `x' = 0.25 + 0.5 (x - lo) / (hi - lo)` if the space outside the box is contracted.
pub fn unit<N: Number>(x: [N; 3], [low, high]: [[f64; 3]; 2], is_contracted: bool) -> [N; 3] {
    let margin = if is_contracted { 0.25 } else { 0.05 };
    std::array::from_fn(|axis| {
        let share = (x[axis] - N::from(low[axis])) / N::from(high[axis] - low[axis]);
        N::from(margin) + N::from(1.0 - 2.0 * margin) * share
    })
}

/// Maps all of the unit cube's space into the cube. The scene's box, its middle half, stays unchanged.
pub fn contract<N: Number>(x: [N; 3]) -> [N; 3] {
    let half = N::from(0.5);
    let q = x.map(|x| x - half);
    let n = q.into_iter().fold(N::from(0.25), |n, q| n.max(q.abs()));
    q.map(|q| half + q * (half - N::from(1.0) / (N::from(16.0) * n)) / n)
}
