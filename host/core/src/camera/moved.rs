//! Small motions of a camera: how poses are refined.

use glam::DVec3;

use super::Camera;

impl Camera {
    /// The camera after a small motion in its own space, in OpenCV axes (x right, y down, z forward): first a
    /// rotation vector w in radians, then a shift v in world units. A point t in camera space becomes `t' = exp([w]x)
    /// t + v`, so the camera turns about its own center.
    ///
    /// ```
    /// use organza_core::Camera;
    ///
    /// let camera = Camera::look_at([0.0, -4.0, 1.0], [0.0; 3], [0.0, 0.0, 1.0], 0.8, [640, 480])?;
    /// // the scene comes half a unit nearer: the camera has moved half a unit forward
    /// let moved = camera.moved([0.0, 0.0, 0.0, 0.0, 0.0, -0.5]);
    /// assert!((moved.depth([0.0; 3]) - camera.depth([0.0; 3]) + 0.5).abs() < 1e-12);
    /// # Ok::<(), organza_core::Error>(())
    /// ```
    #[must_use]
    pub fn moved(&self, [wx, wy, wz, vx, vy, vz]: [f64; 6]) -> Self {
        let [w, v] = [DVec3::new(wx, wy, wz), DVec3::new(vx, vy, vz)];
        // rows of W, then of W' = exp([w]x) W: its columns are W's, turned
        let rows = self.axes();
        let columns = [0, 1, 2].map(|axis| turned(w, rows.map(|row| row[axis]).into()));
        let mut camera = self.clone();
        for (row, column) in camera.camera_to_world.iter_mut().zip(columns) {
            // OpenGL axes
            [row[0], row[1], row[2]] = [column.x, -column.y, -column.z];
            // t' = W' (x - eye) + v = W' (x - eye'), with eye' = eye - W'^T v
            row[3] -= column.dot(v);
        }
        camera
    }
}

/// `exp([w]x) t`: t turned about w by its length (Rodrigues).
pub fn turned(w: DVec3, t: DVec3) -> DVec3 {
    let [sine, cosine, _] = coefficients(w);
    let once = w.cross(t);
    t + sine * once + cosine * w.cross(once)
}

/// `J^T g`, where `exp([w + dw]x) = exp([J dw]x) exp([w]x)`. It turns the gradient g by a further small rotation into
/// the gradient by the rotation vector w. J is the left Jacobian of SO(3).
pub fn to_rotation_vector(w: DVec3, g: DVec3) -> DVec3 {
    let [_, cosine, rest] = coefficients(w);
    // J = 1 + cosine [w]x + rest [w]x^2, and [w]x^T = -[w]x
    let once = w.cross(g);
    g - cosine * once + rest * w.cross(once)
}

/// `sin(a) / a`, `(1 - cos(a)) / a^2` and `(a - sin(a)) / a^3` of the angle a.
fn coefficients(w: DVec3) -> [f64; 3] {
    let square = w.length_squared();
    let angle = square.sqrt();
    if angle < 1e-2 {
        // three terms of the series are exact to f64 here
        let series = |a: f64, b: f64, c: f64| 1.0 / a * (1.0 - square / b * (1.0 - square / c));
        return [series(1.0, 6.0, 20.0), series(2.0, 12.0, 30.0), series(6.0, 20.0, 42.0)];
    }
    let (sine, cosine) = angle.sin_cos();
    [sine / angle, (1.0 - cosine) / square, (angle - sine) / (square * angle)]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn camera() -> Camera {
        Camera::look_at([0.3, -4.0, 1.0], [0.1, 0.2, 0.0], [0.0, 0.0, 1.0], 0.8, [64, 48]).unwrap()
    }

    /// A place in the camera's OpenCV axes.
    fn seen(camera: &Camera, place: DVec3) -> DVec3 {
        let offset = place - DVec3::from(camera.eye());
        camera.axes().map(|axis| axis.dot(offset)).into()
    }

    #[test]
    fn moved_cameras_see_places_turned_and_shifted() {
        let camera = camera();
        let place = DVec3::new(0.7, -0.4, 0.2);
        let axis = DVec3::new(0.6, -0.48, 0.64);
        let shift = DVec3::new(0.1, 0.2, -0.3);
        for angle in [0.0, 1e-9, 5e-3, 9.99e-3, 1.01e-2, 0.5, 3.0] {
            let w = angle * axis;
            let moved = camera.moved([w.x, w.y, w.z, shift.x, shift.y, shift.z]);
            moved.validate(0).expect("a rotation");
            let t = seen(&camera, place);
            // t turns about the axis: the part along it stays, the part across turns
            let along = axis.dot(t) * axis;
            let across = t - along;
            let (sine, cosine) = f64::sin_cos(angle);
            let expected = along + cosine * across + sine * axis.cross(across) + shift;
            let found = seen(&moved, place);
            assert!(found.abs_diff_eq(expected, 1e-13), "{angle}: {found} and {expected}");
        }
    }

    /// The loss is linear in the place as the camera sees it.
    #[test]
    fn a_gradient_by_a_small_turn_becomes_one_by_the_rotation_vector() {
        let t = DVec3::new(0.4, -0.3, 3.0);
        let slope = DVec3::new(0.2, 0.7, -0.1);
        for w in [[0.0; 3], [1e-3, 2e-3, -1e-3], [0.02, -0.01, 0.03], [0.9, -0.4, 0.3]] {
            let w = DVec3::from(w);
            let loss = |w: DVec3| slope.dot(turned(w, t));
            let found = to_rotation_vector(w, turned(w, t).cross(slope));
            for axis in 0..3 {
                let at = |step: f64| {
                    let mut w = w;
                    w[axis] += step;
                    loss(w)
                };
                let expected = (at(1e-5) - at(-1e-5)) / 2e-5;
                assert!((found[axis] - expected).abs() < 1e-9, "{w:?}: {found:?}, {expected}");
            }
        }
    }
}
