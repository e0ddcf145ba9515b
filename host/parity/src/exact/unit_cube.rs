//! The space of the networks and the rays.

/// A point of the world in the unit cube's space: `x' = 0.05 + 0.9 (x - lo) / (hi - lo)` for each axis, and
/// `x' = 0.25 + 0.5 (x - lo) / (hi - lo)` where what lies outside the box is contracted.
pub fn unit(x: [f64; 3], [low, high]: [[f64; 3]; 2], is_contracted: bool) -> [f64; 3] {
    let margin = if is_contracted { 0.25 } else { 0.05 };
    std::array::from_fn(|axis| {
        margin + (1.0 - 2.0 * margin) * (x[axis] - low[axis]) / (high[axis] - low[axis])
    })
}

/// All of the unit cube's space to the cube, and the scene's box, its middle half, to itself.
pub fn contract(x: [f64; 3]) -> [f64; 3] {
    let q = x.map(|x| x - 0.5);
    let n = q.iter().fold(0.25, |n, q| q.abs().max(n));
    q.map(|q| 0.5 + q * (0.5 - 1.0 / (16.0 * n)) / n)
}
