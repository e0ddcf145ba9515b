//! The values that a Gaussian adds to depth and normal.

use super::project::{Gaussian, View, unit_axes};

/// The center's coordinate along the camera's axis.
pub fn depth(view: &View, gaussian: &Gaussian<f64>) -> f64 {
    view.place(gaussian.position)[2]
}

/// The shortest axis, the first of several, turned toward the camera; and the cosine of its angle with the ray to the
/// camera, by which it was turned: 0 at a grazing angle, where rounding decides.
pub fn normal(view: &View, gaussian: &Gaussian<f64>) -> ([f64; 3], f64) {
    let axes = unit_axes(gaussian.rotation);
    let [x, y, z] = gaussian.log_scale;
    let shortest = [x, y, z].into_iter().position(|length| length <= x.min(y).min(z));
    let axis = axes[shortest.expect("numbers have a least")];
    let to_camera: [f64; 3] = std::array::from_fn(|i| view.eye[i] - gaussian.position[i]);
    let length = to_camera.iter().fold(0.0_f64, |length, part| length.hypot(*part));
    let cosine: f64 = axis.iter().zip(to_camera).map(|(a, b)| a * (b / length)).sum();
    (axis.map(|part| if cosine < 0.0 { -part } else { part }), cosine.abs())
}
