//! The space of the networks and the rays.

/// A point of the world in the unit cube's space: `x' = 0.05 + 0.9 (x - lo) / (hi - lo)` for each axis.
pub fn unit(x: [f64; 3], [low, high]: [[f64; 3]; 2]) -> [f64; 3] {
    std::array::from_fn(|axis| 0.05 + 0.9 * (x[axis] - low[axis]) / (high[axis] - low[axis]))
}
