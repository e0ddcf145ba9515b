//! The inverse of the color's head (Eq. 3).

/// The number whose sigmoid is `y`, limited to 745: beyond it an f64 sigmoid is 0 or 1.
pub fn logit(y: f64) -> f64 {
    (y / (1.0 - y)).ln().clamp(-745.0, 745.0)
}
