//! What a rendered batch has missed (Kerbl et al. 2023, Eq. 7).

/// `(|d|, 1 - SSIM, d^2, m)` of a pixel with the differences d of its channels; 1 - SSIM is their sum already.
#[must_use]
pub fn sums(d: [f64; 3], dissimilarity: f64, valid: f64) -> [f64; 4] {
    let sum = |of: fn(f64) -> f64| d.into_iter().map(of).sum::<f64>();
    [sum(f64::abs), dissimilarity, sum(|d| d * d), valid]
}

/// The loss from the sums over `valid` pixels: `(1 - w) |x - y| + w (1 - SSIM)`, the mean over their three channels.
#[must_use]
pub fn mean(absolute: f64, dissimilarity: f64, valid: f64, weight: f64) -> f64 {
    ((1.0 - weight) * absolute + weight * dissimilarity) / (3.0 * valid)
}

/// d|d|/dd: 0 at 0, and where an f32 is so small that a GPU may take it for 0.
#[must_use]
pub fn sign(d: f64) -> f64 {
    if d.abs() < 2_f64.powi(-126) { 0.0 } else { d.signum() }
}
