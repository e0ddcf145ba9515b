//! The values that a Gaussian adds to depth and normal.

use super::numeric::{Number, dot};
use super::project::{Gaussian, View, unit_axes};

/// The center's coordinate along the camera's axis.
pub fn depth<N: Number>(view: &View<N>, gaussian: &Gaussian<N>) -> N {
    view.place(gaussian.position)[2]
}

/// The shortest axis, the first of several, turned toward the camera.
pub fn normal<N: Number>(view: &View<N>, gaussian: &Gaussian<N>) -> [N; 3] {
    let lengths = gaussian.log_scale.map(Number::value);
    let min = lengths.into_iter().fold(f64::INFINITY, f64::min);
    let shortest = lengths.iter().position(|&length| length == min).expect("it is one of them");
    let axis = unit_axes(gaussian.rotation)[shortest];
    let from_camera = std::array::from_fn(|i| gaussian.position[i] - view.eye[i]);
    let away = dot(axis, from_camera);
    axis.map(|part| away.above(0.0, -part, part))
}
