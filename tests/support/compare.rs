//! Comparisons that report the difference of two tensors, and its place.

/// The difference of two tensors.
#[derive(Clone, Copy, Debug, Default)]
pub struct Difference {
    /// Largest absolute difference.
    pub absolute: f64,
    /// Index of the largest difference.
    pub index: usize,
    /// Norm of the difference, relative to the norm of the expected values.
    pub relative: f64,
    /// Largest absolute difference, relative to the root mean square of the expected values.
    pub largest: f64,
}

/// Compares two tensors of one length, without NaN.
pub fn difference(actual: &[f32], expected: &[f32]) -> Difference {
    assert_eq!(actual.len(), expected.len(), "lengths differ");
    let norm = expected.iter().map(|&x| f64::from(x).powi(2)).sum::<f64>().sqrt().max(1e-30);
    let mut found = Difference::default();
    let mut squares = 0.0;
    for (index, (&a, &e)) in actual.iter().zip(expected).enumerate() {
        let absolute = (f64::from(a) - f64::from(e)).abs();
        assert!(!absolute.is_nan(), "NaN at {index}: {a} for {e}");
        squares += absolute * absolute;
        if absolute > found.absolute {
            found.absolute = absolute;
            found.index = index;
        }
    }
    found.relative = squares.sqrt() / norm;
    found.largest = found.absolute / (norm / (expected.len().max(1) as f64).sqrt());
    found
}

/// Asserts that two tensors nowhere differ by more than `tolerance`.
pub fn assert_close(what: &str, actual: &[f32], expected: &[f32], tolerance: f64) {
    let found = difference(actual, expected);
    let at = found.index;
    let a = actual.get(found.index);
    let e = expected.get(found.index);
    let apart = found.absolute;
    assert!(
        apart <= tolerance,
        "{what}: {apart:.3e} apart at {at}, {a:?} for {e:?}; allowed is {tolerance:.1e}"
    );
    println!("{what}: {apart:.2e} absolute");
}

/// Asserts that two tensors differ by at most `tolerance` in relative norm. Also, no value may differ by more than
/// ten times the tolerance, relative to the tensor's root mean square.
pub fn assert_close_relative(what: &str, actual: &[f32], expected: &[f32], tolerance: f64) {
    let found = difference(actual, expected);
    let at = found.index;
    let a = actual.get(found.index);
    let e = expected.get(found.index);
    let relative = found.relative;
    let largest = found.largest;
    assert!(
        relative <= tolerance && largest <= 10.0 * tolerance,
        "{what}: {relative:.3e} relative, most at {at}, {a:?} for {e:?} ({largest:.3e}); allowed is {tolerance:.1e}"
    );
    println!("{what}: {relative:.2e} relative, {largest:.2e} at most");
}

/// The bits of values.
pub fn bits(values: &[f32]) -> Vec<u32> {
    values.iter().map(|value| value.to_bits()).collect()
}
