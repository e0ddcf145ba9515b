//! Central differences, and how far a kernel is from them.

use organza::Device;
use organza_tests::devices;

/// Largest relative error of a gradient's norm.
const TOLERANCE: f64 = 1e-3;

/// The CPU with every instruction set that it has, and the GPU where there is one.
pub fn everywhere() -> Vec<(&'static str, Device)> {
    let gpus = devices::all().into_iter().filter(|(name, _)| *name != "cpu");
    devices::cpus().into_iter().chain(gpus).collect()
}

/// The gradient of `loss`: each value moved by `step` of its size (of 1e-3 at least), both ways.
pub fn central(values: &[f64], step: f64, loss: impl Fn(&[f64]) -> f64) -> Vec<f64> {
    let mut moved = values.to_vec();
    let mut derivative = |index: usize| {
        let value: f64 = values[index];
        let by = step * value.abs().max(1e-3);
        let mut at = |value: f64| {
            moved[index] = value;
            loss(&moved)
        };
        let difference = at(value + by) - at(value - by);
        moved[index] = value;
        difference / (2.0 * by)
    };
    (0..values.len()).map(&mut derivative).collect()
}

/// Norm of the difference over the norm of what is expected.
pub fn relative(found: &[f32], expected: &[f64]) -> f64 {
    assert_eq!(found.len(), expected.len(), "lengths differ");
    let apart = found.iter().zip(expected).map(|(&a, &b)| (f64::from(a) - b).powi(2));
    let size: f64 = expected.iter().map(|x| x * x).sum();
    apart.sum::<f64>().sqrt() / size.sqrt().max(1e-30)
}

/// Fails where a gradient is off.
pub fn hold(what: &str, found: &[f32], expected: &[f64]) {
    let relative = relative(found, expected);
    println!("{what}: {relative:.1e}");
    // a NaN is not below anything
    assert!(relative <= TOLERANCE, "{what}: {relative:.2e} relative, allowed is {TOLERANCE:.0e}");
}
