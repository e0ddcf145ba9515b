//! The loss of a rendered batch (Kerbl et al. 2023, Eq. 7).

use super::numeric::Number;

/// `(|d|, 1 - SSIM, d^2, m)` of a pixel, summed over its channels; d is the difference of the images.
pub fn sums<N: Number>(d: [N; 3], dissimilarity: N, valid: N) -> [N; 4] {
    [N::sum(d.map(N::abs)), dissimilarity, N::sum(d.map(|d| d * d)), valid]
}

/// The derivative of |d|: 0 at 0, and for denormals, which a GPU may flush to 0.
pub fn sign(d: f64) -> f64 {
    if d.abs() < 2_f64.powi(-126) { 0.0 } else { d.signum() }
}
