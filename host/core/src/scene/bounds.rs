//! Where most of a scene is.

/// Part of the opacity that [`bounds`] leaves out at each end of an axis.
const LEFT_OUT: f64 = 0.01;
/// Standard deviations that a Gaussian reaches.
const SUPPORT: f64 = 3.0;

/// The box of nearly all of the opacity: a Gaussian counts as much as it is opaque. So a few that are far away, large and
/// faint do not matter. All have the margin of a Gaussian of middle size. Opacities are logits, scales logarithms.
#[must_use]
pub fn bounds(position: &[[f32; 3]], log_scale: &[[f32; 3]], opacity: &[f32]) -> [[f64; 3]; 2] {
    let weight = opacity.iter().map(|logit| 1.0 / (1.0 + f64::from(-logit).exp()));
    let weight: Vec<_> = weight.collect();
    let total: f64 = weight.iter().sum();
    let largest = log_scale.iter().map(|scale| scale.iter().copied().fold(f32::MIN, f32::max));
    let [middle] = quantiles(largest.zip(weight.iter().copied()), [0.5 * total]);
    let margin = SUPPORT * middle.exp();
    let ends: [[f64; 2]; 3] = std::array::from_fn(|axis| {
        let places = position.iter().map(|place| place[axis]).zip(weight.iter().copied());
        quantiles(places, [LEFT_OUT, 1.0 - LEFT_OUT].map(|part| part * total))
    });
    [ends.map(|[low, _]| low - margin), ends.map(|[_, high]| high + margin)]
}

/// The values up to which values have these weights together; 0 where there are none.
fn quantiles<const N: usize>(
    values: impl Iterator<Item = (f32, f64)>,
    weights: [f64; N],
) -> [f64; N] {
    let mut values: Vec<_> = values.collect();
    values.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
    weights.map(|weight| {
        let mut sum = 0.0;
        let found = values.iter().find(|(_, own)| {
            sum += own;
            sum >= weight
        });
        found.map_or(0.0, |(value, _)| f64::from(*value))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn large_and_faint_gaussians_far_away_do_not_count() {
        let mut position: Vec<_> = (0..200).map(|at| [at as f32 / 199.0, -1.0, 0.5]).collect();
        let mut log_scale = vec![[0.01_f32.ln(), -9.0, -9.0]; 200];
        let mut opacity = vec![2.0; 200];
        let near = bounds(&position, &log_scale, &opacity);
        let expected = [[-0.03, -1.03, 0.47], [1.03, -0.97, 0.53]];
        for (found, expected) in near.as_flattened().iter().zip(expected.as_flattened()) {
            assert!((found - expected).abs() < 0.02, "{near:?}");
        }
        // a tenth of all, of opacity 0.005
        for at in 0..20 {
            position.push([at as f32 * 5.0 - 50.0, 36.0, -25.0]);
            log_scale.push([3.0; 3]);
            opacity.push(-5.3);
        }
        let found = bounds(&position, &log_scale, &opacity);
        let apart =
            found.as_flattened().iter().zip(near.as_flattened()).map(|(a, b)| (a - b).abs());
        assert!(apart.fold(0.0, f64::max) < 0.01, "{found:?}, not {near:?}");
    }

    #[test]
    fn one_gaussian_has_the_box_of_its_size() {
        let [low, high] = bounds(&[[1.0, 2.0, 3.0]], &[[0.0, -1.0, -2.0]], &[-1.0]);
        assert_eq!((low, high), ([-2.0, -1.0, 0.0], [4.0, 5.0, 6.0]));
    }
}
