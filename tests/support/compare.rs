//! Comparisons that say how far two tensors are apart, and where most.

/// How far two tensors are apart.
#[derive(Clone, Copy, Debug, Default)]
pub struct Difference {
    /// Largest absolute difference.
    pub absolute: f64,
    /// Its index.
    pub index: usize,
    /// Norm of the difference over the norm of what was expected.
    pub relative: f64,
    /// Largest absolute difference over the root mean square of what was expected.
    pub largest: f64,
}

/// Compares two tensors.
///
/// # Panics
/// If their lengths differ, or one holds a NaN.
#[must_use]
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
            (found.absolute, found.index) = (absolute, index);
        }
    }
    found.relative = squares.sqrt() / norm;
    found.largest = found.absolute / (norm / (expected.len().max(1) as f64).sqrt());
    found
}

/// Fails where two tensors differ by more than `tolerance` anywhere.
///
/// # Panics
/// See above.
pub fn assert_close(what: &str, actual: &[f32], expected: &[f32], tolerance: f64) {
    let found = difference(actual, expected);
    let (at, a, e) = (found.index, actual.get(found.index), expected.get(found.index));
    let apart = found.absolute;
    assert!(
        apart <= tolerance,
        "{what}: {apart:.3e} apart at {at}, {a:?} for {e:?}; allowed is {tolerance:.1e}"
    );
    println!("{what}: {apart:.2e} absolute");
}

/// Fails where two tensors differ by more than `tolerance` in norm, relatively, or any value by more than ten times
/// that of the tensor's root mean square.
///
/// # Panics
/// See above.
pub fn assert_close_relative(what: &str, actual: &[f32], expected: &[f32], tolerance: f64) {
    let found = difference(actual, expected);
    let (at, a, e) = (found.index, actual.get(found.index), expected.get(found.index));
    let (relative, largest) = (found.relative, found.largest);
    assert!(
        relative <= tolerance && largest <= 10.0 * tolerance,
        "{what}: {relative:.3e} relative, most at {at}, {a:?} for {e:?} ({largest:.3e}); allowed is {tolerance:.1e}"
    );
    println!("{what}: {relative:.2e} relative, {largest:.2e} at most");
}
