//! Eq. 14 and 15: who is a member of a tile.

/// `dist(x, B_t)`, to the closed box.
pub fn distance(center: [f64; 2], origin: [i32; 2], side: u32) -> f64 {
    let outside = |axis: usize| {
        let low = f64::from(origin[axis]);
        (low - center[axis]).max(center[axis] - low - f64::from(side)).max(0.0)
    };
    outside(0).hypot(outside(1))
}

/// Whether a support reaches a tile: its radius has the kernel's margin for rounding, and is negative where the
/// Gaussian is culled.
pub fn reaches(center: [f64; 2], radius: f64, origin: [i32; 2], side: u32) -> bool {
    radius >= 0.0 && distance(center, origin, side) <= radius * 1.001 + 0.01
}
