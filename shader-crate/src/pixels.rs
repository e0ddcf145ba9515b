//! Pixels of 8 bits, so that the host reads a third of the bytes for an image.

use muslin::math;
use muslin::prelude::*;

/// Parameters of [`pixels`].
#[params]
pub struct PixelsParams {
    /// K S S
    pub count: u32,
    /// S S
    pub area: u32,
}

/// `rgba [K, S, S]` of `image [K, 3, S, S]`: red in the lowest byte, then green and blue, each the nearest of 256 levels of a value that is
/// clamped to 0 to 1; NaN is 0. The highest byte is 255 if all three values are finite, and 0 otherwise.
#[kernel(threads(64), over(params.count))]
pub fn pixels(id: Invocation, params: &PixelsParams, image: Read<f32>, rgba: Write<u32>) {
    let index = id.index();
    if index < params.count {
        let area = params.area;
        let at = index / area * (3 * area) + index % area;
        let r = image.read(at);
        let g = image.read(at + area);
        let b = image.read(at + 2 * area);
        let are_finite = math::is_finite(r) && math::is_finite(g) && math::is_finite(b);
        let finite = if are_finite { 255 << 24 } else { 0 };
        rgba.write(index, level(r) | level(g) << 8 | level(b) << 16 | finite);
    }
}

/// The nearest of 256 levels, halves upward.
#[inline(always)]
fn level(value: f32) -> u32 {
    // NaN is in neither branch
    let value = if value >= 1.0 {
        255.0
    } else if value > 0.0 {
        value * 255.0
    } else {
        0.0
    };
    let whole = value as u32;
    // the product takes part in no sum, which would round, or which a driver could fuse
    if value >= whole as f32 + 0.5 { whole + 1 } else { whole }
}
