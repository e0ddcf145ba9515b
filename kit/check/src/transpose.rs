//! Holds a backward kernel to its forward kernel.

/// Checks that `<J v, u> = <v, J^T u>`. `J v` are the [slopes](muslin::dual) of a forward kernel's outputs along `v`, and
/// `J^T u` is what the backward kernel computes of `u`. `tolerance` is a part of the terms' sizes.
///
/// # Panics
/// If the two differ, or if all terms are 0.
pub fn assert_transpose(name: &str, forward: [&[f64]; 2], backward: [&[f64]; 2], tolerance: f64) {
    let product = |[a, b]: [&[f64]; 2]| {
        assert_eq!(a.len(), b.len(), "{name}: a product of as many numbers");
        let terms = || a.iter().zip(b).filter(|(a, _)| **a != 0.0).map(|(a, b)| a * b);
        (terms().sum::<f64>(), terms().map(f64::abs).sum::<f64>())
    };
    let (forward, size) = product(forward);
    let (backward, other_size) = product(backward);
    assert!(size > 0.0, "{name}: nothing has a slope");
    assert!(
        (forward - backward).abs() <= tolerance * size.max(other_size),
        "{name}: <J v, u> is {forward:e}, and <v, J^T u> {backward:e}"
    );
}
