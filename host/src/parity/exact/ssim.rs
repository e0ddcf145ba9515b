//! The structural similarity (Wang, Bovik, Sheikh and Simoncelli 2004, Eq. 13) of windows under a mask.

use super::numeric::Number;

/// The Gaussian weight of a distance in pixels: sigma 1.5, none past five; those of all eleven have the sum 1.
#[must_use]
pub fn weight(distance: usize) -> f64 {
    let gauss = |distance: i32| (-f64::from(distance * distance) / 4.5).exp();
    let all: f64 = (-5..=5).map(gauss).sum();
    if distance <= 5 { gauss(distance as i32) / all } else { 0.0 }
}

/// The weighted sum of a row or column of values around place `at`.
#[must_use]
pub fn weighted_sum(at: usize, values: impl Iterator<Item = f64>) -> f64 {
    let weights = [0, 1, 2, 3, 4, 5].map(weight);
    let terms = values.enumerate().filter_map(|(tap, value)| {
        let weight = weights.get(tap.abs_diff(at))?;
        Some(weight * value)
    });
    terms.sum()
}

/// SSIM of the means of x and y, the sum of their variances, and their covariance.
#[must_use]
pub fn similarity<N: Number>([x, y]: [N; 2], variances: N, covariance: N) -> N {
    let [two, c1, c2] = [2.0, 0.01_f64.powi(2), 0.03_f64.powi(2)].map(N::from);
    (two * x * y + c1) * (two * covariance + c2) / ((x * x + y * y + c1) * (variances + c2))
}

/// SSIM of a window's pixels: weights, which need not have the sum 1, and the values of x and y.
#[must_use]
pub fn of_pixels(pixels: &[[f64; 3]]) -> f64 {
    let total: f64 = pixels.iter().map(|[weight, ..]| weight).sum();
    let mean = |value: &dyn Fn(f64, f64) -> f64| {
        pixels.iter().map(|&[weight, x, y]| weight / total * value(x, y)).sum::<f64>()
    };
    let [x, y] = [mean(&|x, _| x), mean(&|_, y| y)];
    let variances = mean(&|a, b| (a - x).powi(2) + (b - y).powi(2));
    similarity([x, y], variances, mean(&|a, b| (a - x) * (b - y)))
}

/// 1 - SSIM of a window, from its weighted sums of d = x - y, s = x + y - 1, d^2, s^2, and of the weights.
#[must_use]
pub fn dissimilarity<N: Number>([d, s, dd, ss, weight]: [N; 5]) -> N {
    let [one, two, four] = [1.0, 2.0, 4.0].map(N::from);
    let [d, s, dd, ss] = [d, s, dd, ss].map(|sum| sum / weight);
    let (of_d, of_s) = (dd - d * d, ss - s * s);
    let means = [(s + one + d) / two, (s + one - d) / two];
    one - similarity(means, (of_s + of_d) / two, (of_s - of_d) / four)
}
