//! Derivatives in f64.

/// The gradient of `loss`: each value moved by `step` of its size (of 1e-3 at least), once and twice, both ways.
///
/// The error of such a difference is of the fourth order: with a step of 1e-3, about 1e-12 of what a function that
/// is smooth at that scale changes by.
pub fn central(values: &[f64], step: f64, loss: impl Fn(&[f64]) -> f64) -> Vec<f64> {
    let mut moved = values.to_vec();
    let derivative = |index: usize| {
        let value = values[index];
        let by = step * value.abs().max(1e-3);
        let mut at = |value: f64| {
            moved[index] = value;
            loss(&moved)
        };
        let mut difference = |by: f64| at(value + by) - at(value - by);
        let [once, twice] = [difference(by), difference(2.0 * by)];
        moved[index] = value;
        (8.0 * once - twice) / (12.0 * by)
    };
    (0..values.len()).map(derivative).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn differences_are_derivatives() {
        let [x, y] = [0.7, -1.3];
        let found = central(&[x, y], 1e-3, |v| v[0].sin() * v[1].exp());
        let expected = [x.cos() * y.exp(), x.sin() * y.exp()];
        for (found, expected) in found.iter().zip(expected) {
            assert!((found / expected - 1.0).abs() < 1e-11, "{found} for {expected}");
        }
    }
}
