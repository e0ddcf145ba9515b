//! The structural similarity (Wang, Bovik, Sheikh and Simoncelli 2004, Eq. 13) of windows under a mask.

use super::numeric::Number;
use organza_core::metrics;

/// The Gaussian weights of a window along one axis, by the distance from its center in pixels: sigma is 1.5, and the
/// eleven weights add up to 1.
pub fn weights() -> [f64; 6] {
    let gauss = |distance: i32| (-f64::from(distance * distance) / 4.5).exp();
    let all: f64 = (-5..=5).map(gauss).sum();
    [0, 1, 2, 3, 4, 5].map(|distance| gauss(distance) / all)
}

/// The weighted sum of a row or column of values around place `at`.
pub fn weighted_sum<N: Number>(at: usize, values: impl Iterator<Item = N>) -> N {
    let weights = weights();
    let terms = values.enumerate().filter_map(|(tap, value)| {
        let weight = *weights.get(tap.abs_diff(at))?;
        Some(N::from(weight) * value)
    });
    N::sum(terms)
}

/// SSIM from the means of x and y, the sum of their variances, and their covariance.
pub fn similarity<N: Number>([x, y]: [N; 2], variances: N, covariance: N) -> N {
    let [two, c1, c2] = [2.0, 0.01_f64.powi(2), 0.03_f64.powi(2)].map(N::from);
    (two * x * y + c1) * (two * covariance + c2) / ((x * x + y * y + c1) * (variances + c2))
}

/// SSIM of a window from its pixels: weight, x and y of each. The weights need not add up to 1.
pub fn window_ssim<N: Number>(pixels: &[(f64, [N; 2])]) -> N {
    let total: f64 = pixels.iter().map(|(weight, _)| weight).sum();
    let mean = |value: &dyn Fn(N, N) -> N| {
        pixels.iter().fold(N::from(0.0), |sum, &(weight, [x, y])| {
            sum + N::from(weight / total) * value(x, y)
        })
    };
    let [x, y] = [mean(&|x, _| x), mean(&|_, y| y)];
    let variances = mean(&|a, b| (a - x) * (a - x) + (b - y) * (b - y));
    similarity([x, y], variances, mean(&|a, b| (a - x) * (b - y)))
}

/// 1 - SSIM of a window, from its weighted sums of d = x - y, s = x + y - 1, d^2, s^2, and of the weights.
pub fn dissimilarity<N: Number>([d, s, dd, ss, weight]: [N; 5]) -> N {
    let [one, two, four] = [1.0, 2.0, 4.0].map(N::from);
    let [d, s, dd, ss] = [d, s, dd, ss].map(|sum| sum / weight);
    let of_d = dd - d * d;
    let of_s = ss - s * s;
    let means = [(s + one + d) / two, (s + one - d) / two];
    one - similarity(means, (of_s + of_d) / two, (of_s - of_d) / four)
}

/// The window's weights, as kernels have them.
pub fn window() -> Vec<f32> {
    metrics::window().map(|weight| weight as f32).to_vec()
}
