//! B3. The shape of a Gaussian's falloff (Eq. 18): more pointed than a Gaussian, a Gaussian, or flatter, nearly a disc.

use crate::project::falloff;
use muslin::math::{abs, exp};
use muslin::prelude::*;

/// How flat a falloff is, k of Eq. 18, from -1/2 to 1: `(1 - e^-s) / (1 + 2 e^-s)`, without overflow for any value s of the
/// tensor `shape`. A Gaussian has 0.
#[inline(always)]
pub fn flatness(s: f32) -> f32 {
    let e = exp(-abs(s));
    if s < 0.0 { (e - 1.0) / (e + 2.0) } else { (1.0 - e) / (1.0 + 2.0 * e) }
}

/// The derivative dk/ds of [`flatness`], of k.
#[inline(always)]
pub fn flatness_slope(k: f32) -> f32 {
    (k + 0.5) * (1.0 - k) * (2.0 / 3.0)
}

/// A Gaussian's falloff f with its shape, `f + k (disc(f) - f)`, where `disc(f) = g^2 (3 - 2 g)` and `g = f (2 - f)`.
#[derive(Clone, Copy)]
pub struct Shaped<L> {
    /// From 0 to 1, which are f's own. It grows with f.
    pub value: L,
    /// Its derivative by f.
    pub by_falloff: L,
    /// Its derivative by k.
    pub by_flatness: L,
}

impl<L: Lane> Shaped<L> {
    /// Of f and k.
    #[inline(always)]
    pub fn new(f: L, flatness: f32) -> Self {
        let one = L::splat(1.0);
        let k = L::splat(flatness);
        let g = f * (L::splat(2.0) - f);
        let disc = g * g * (L::splat(3.0) - (g + g));
        let below = one - f;
        let disc_slope = L::splat(12.0) * g * (below * below * below);
        let by_flatness = disc - f;
        let by_falloff = one + k * (disc_slope - one);
        Self { value: f + k * by_flatness, by_falloff, by_flatness }
    }
}

/// The falloff at a squared Mahalanobis distance, with a shape. It ends where the Gaussian's ends.
#[inline(always)]
pub fn shaped_falloff<L: Lane>(q: L, flatness: f32) -> L {
    Shaped::new(falloff(q), flatness).value
}
