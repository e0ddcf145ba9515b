//! The color's head (Eq. 3), backwards.

/// The number whose sigmoid is `y`: beyond 745 that of an f64 is 0 or 1.
#[must_use]
pub fn logit(y: f64) -> f64 {
    (y / (1.0 - y)).ln().clamp(-745.0, 745.0)
}
