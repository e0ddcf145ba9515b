//! The pose of each photograph's camera: a small motion, learned with the scene.

use std::collections::BTreeMap;

use glam::DVec3;

use super::config::OptimizerConfig;
use super::per_photograph::{PerPhotograph, VALUES};
use organza_core::camera::{Camera, to_rotation_vector, turned};
use organza_core::error::Result;

/// The poses of all training photographs.
///
/// The values of a photograph are a rotation vector w and a shift v, in the form of [`Camera::moved`]. They give the
/// current camera relative to the given one.
///
/// If all cameras turn, shift or spread together, and the scene with them, no image changes. But held-out views would
/// no longer fit. So each step removes the motion that all cameras have in common: see [`PoseSet::center`].
#[derive(Clone, Debug)]
pub(super) struct PoseSet {
    pub learned: PerPhotograph,
    given: Vec<Camera>,
}

impl PoseSet {
    /// The given cameras with their learned motions.
    pub fn new(learned: PerPhotograph, given: Vec<Camera>) -> Self {
        Self { learned, given }
    }

    /// The current cameras.
    pub fn cameras(&self) -> Vec<Camera> {
        let cameras = self.given.iter().zip(&self.learned.values);
        cameras.map(|(camera, values)| camera.moved(values.map(f64::from))).collect()
    }

    /// Takes one step of Adam for the photographs of a batch. `gradients [photographs, 6]` are with respect to a further small
    /// motion of each camera. Rotations move by `rate`, in radians, and shifts by `rate * extent`.
    pub fn step(
        &mut self,
        gradients: &[[f32; VALUES]],
        shown: impl Iterator<Item = usize>,
        config: &OptimizerConfig,
        rate: f64,
        extent: f64,
    ) -> Result<()> {
        let of = |photograph: usize| {
            let [w, v] = parts(self.learned.values[photograph]);
            let [turn, shift] = parts(gradients[photograph]);
            // t' = exp([w]x) t + v: w turns only t' - v, but the gradient is with respect to a turn of all of t'
            let turn = to_rotation_vector(w, turn - v.cross(shift));
            (photograph, joined(turn, shift))
        };
        let gradients: BTreeMap<_, _> = shown.map(of).collect();
        let turn = rate;
        let shift = rate * extent;
        self.learned.adam(&gradients, config, [turn, turn, turn, shift, shift, shift], "pose")?;
        self.center();
        Ok(())
    }

    /// Removes the motion that all cameras have in common: a rotation, a shift and a scale about the mean of the
    /// given centers. Afterwards the cameras' rotation vectors, about the world's axes, add up to 0. So do the
    /// displacements of their centers, and the components of these displacements along the directions from the mean
    /// center.
    ///
    /// To first order, this changes no image of a scene that moves along.
    fn center(&mut self) {
        let count = self.given.len() as f64;
        let mean =
            |of: &dyn Fn(usize) -> DVec3| (0..self.given.len()).map(of).sum::<DVec3>() / count;
        let motions: Vec<_> = self
            .given
            .iter()
            .zip(&self.learned.values)
            .map(|(camera, &values)| Motion::new(camera, values))
            .collect();
        let middle = mean(&|at| self.given[at].eye().into());
        let arms: Vec<_> =
            self.given.iter().map(|camera| DVec3::from(camera.eye()) - middle).collect();
        let turn = mean(&|at| motions[at].turn);
        let shift = mean(&|at| motions[at].shift);
        let spread: f64 = arms.iter().map(|arm| arm.length_squared()).sum();
        let along: f64 = arms.iter().zip(&motions).map(|(arm, motion)| arm.dot(motion.shift)).sum();
        // one camera, or all in one place, have no spread
        let scale = if spread > 0.0 { along / spread } else { 0.0 };
        for (at, motion) in motions.into_iter().enumerate() {
            let common = shift + turn.cross(arms[at]) + scale * arms[at];
            let own = Motion { turn: motion.turn - turn, shift: motion.shift - common };
            self.learned.values[at] = own.values(&self.given[at]);
        }
    }
}

/// The motion of a camera in the world.
#[derive(Clone, Copy, Debug)]
struct Motion {
    /// Rotation vector of the camera's axes.
    turn: DVec3,
    /// Displacement of the camera's center, in world units.
    shift: DVec3,
}

impl Motion {
    /// `W' = exp([w]x) W`, so the axes W^T turn by `exp([-W^T w]x)`; the center moves by `-W'^T v`.
    fn new(camera: &Camera, values: [f32; VALUES]) -> Self {
        let [w, v] = parts(values);
        let to_world = camera.to_world();
        Self { turn: to_world * -w, shift: to_world * turned(-w, -v) }
    }

    /// The values of a camera with this motion.
    fn values(self, camera: &Camera) -> [f32; VALUES] {
        let rows = camera.axes();
        let to_camera = |v: DVec3| DVec3::from(rows.map(|row| -row.dot(v)));
        let w = to_camera(self.turn);
        joined(w, turned(w, to_camera(self.shift))).map(|value| value as f32)
    }
}

/// The rotation and the shift of a photograph's values.
fn parts(values: [f32; VALUES]) -> [DVec3; 2] {
    let [wx, wy, wz, vx, vy, vz] = values.map(f64::from);
    [DVec3::new(wx, wy, wz), DVec3::new(vx, vy, vz)]
}

/// The values of these [`parts`].
fn joined(w: DVec3, v: DVec3) -> [f64; VALUES] {
    [w.x, w.y, w.z, v.x, v.y, v.z]
}

#[cfg(test)]
mod tests {
    use super::*;
    use organza_core::demo;

    fn poses() -> PoseSet {
        PoseSet::new(PerPhotograph::new(5), demo::turntable(5, 32))
    }

    /// The rotation and the displacement of a camera's center, in the world.
    fn motion(before: &Camera, after: &Camera) -> [DVec3; 2] {
        let [old, new] = [before, after].map(Camera::axes);
        // R = W'^T W; a small one is 1 + [turn]x
        let entry = |row: usize, column: usize| -> f64 {
            (0..3).map(|axis| new[axis][row] * old[axis][column]).sum()
        };
        let half = |a: [usize; 2], b: [usize; 2]| 0.5 * (entry(a[0], a[1]) - entry(b[0], b[1]));
        let turn = [half([2, 1], [1, 2]), half([0, 2], [2, 0]), half([1, 0], [0, 1])];
        [turn.into(), DVec3::from(after.eye()) - DVec3::from(before.eye())]
    }

    #[test]
    fn the_common_motion_of_all_cameras_is_removed() {
        let mut poses = poses();
        for (at, values) in poses.learned.values.iter_mut().enumerate() {
            for (place, value) in values.iter_mut().enumerate() {
                *value = 1e-3 * ((7 * at + 3 * place) as f32).sin();
            }
        }
        let before = poses.cameras();
        poses.center();
        let motions: Vec<_> =
            poses.given.iter().zip(poses.cameras()).map(|(a, b)| motion(a, &b)).collect();
        let mean = |of: &dyn Fn(usize) -> f64| (0..5).map(of).sum::<f64>() / 5.0;
        for (part, axis) in (0..6).map(|at| (at / 3, at % 3)) {
            let mean = mean(&|at| motions[at][part][axis]);
            assert!(mean.abs() < 1e-7, "{part}, {axis}: {mean}");
        }
        // only the common motion was removed, so each camera still moves relative to the others
        let common: Vec<_> =
            before.iter().zip(poses.cameras()).map(|(a, b)| motion(a, &b)[0]).collect();
        assert!(common.iter().all(|turn| turn.abs_diff_eq(common[0], 1e-5)), "{common:?}");
        assert!(common[0].abs().max_element() > 1e-5, "{common:?}");
        let again = poses.clone();
        poses.center();
        for (a, b) in again.learned.values.iter().flatten().zip(poses.learned.values.as_flattened())
        {
            assert!((a - b).abs() < 1e-9, "{a} and {b}");
        }
    }

    /// A similarity that all cameras share is removed entirely.
    #[test]
    fn a_motion_of_the_world_is_taken_out_whole() {
        let mut poses = poses();
        let turn = DVec3::new(1e-3, -2e-3, 5e-4);
        let shift = DVec3::new(3e-3, 1e-3, -2e-3);
        let scale = 1e-3;
        for (camera, values) in poses.given.iter().zip(&mut poses.learned.values) {
            let eye = DVec3::from(camera.eye());
            let shift = shift + turn.cross(eye) + scale * eye;
            *values = Motion { turn, shift }.values(camera);
        }
        poses.center();
        let largest =
            poses.learned.values.iter().flatten().fold(0.0_f32, |largest, v| largest.max(v.abs()));
        assert!(largest < 1e-5, "{largest}");
    }

    #[test]
    fn one_camera_stays() {
        let mut poses = PoseSet::new(PerPhotograph::new(1), demo::turntable(1, 32));
        let config = OptimizerConfig::default();
        poses.step(&[[1.0; VALUES]], [0].into_iter(), &config, 1e-3, 1.0).unwrap();
        let largest =
            poses.learned.values[0].iter().fold(0.0_f32, |largest, v| largest.max(v.abs()));
        assert!(largest < 1e-9, "{largest}");
    }

    /// Adam's first step has the size of its rate. For values that are not 0, the gradient must match the loss.
    #[test]
    fn gradients_match_differences() {
        let mut poses = poses();
        let mut values = [0.0; VALUES];
        for (at, value) in values.iter_mut().enumerate() {
            *value = 0.1 + 0.05 * at as f32;
        }
        poses.learned.values[2] = values;
        // the loss is linear in the place as the camera sees it
        let place = DVec3::new(0.3, -0.2, 0.5);
        let slope = DVec3::new(0.4, -1.0, 0.7);
        let seen = |values: [f64; VALUES]| {
            let camera = poses.given[2].moved(values);
            let offset = place - DVec3::from(camera.eye());
            DVec3::from(camera.axes().map(|axis| axis.dot(offset)))
        };
        let loss = |values: [f64; VALUES]| slope.dot(seen(values));
        let now = values.map(f64::from);
        let mut gradients = [[0.0; VALUES]; 5];
        gradients[2] = joined(seen(now).cross(slope), slope).map(|value| value as f32);
        let expected: Vec<_> = (0..VALUES)
            .map(|at| {
                let mut moved = [now; 2];
                moved[0][at] = now[at] - 1e-5;
                moved[1][at] = now[at] + 1e-5;
                (loss(moved[1]) - loss(moved[0])) / 2e-5
            })
            .collect();
        let config = OptimizerConfig { beta1: 0.0, ..OptimizerConfig::default() };
        poses.step(&gradients, [2].into_iter(), &config, 1e-3, 1.0).unwrap();
        for (at, (found, expected)) in poses.learned.moments[0][2].iter().zip(expected).enumerate()
        {
            assert!((f64::from(*found) - expected).abs() < 1e-5, "{at}: {found} and {expected}");
        }
    }
}
