//! The views in which a scene is compared with Gaussians of other programs, the cameras between them, and the box of these.

use super::{Splat, SplatFile};
use glam::DVec3;
use organza_core::camera::{Camera, CameraPath, Orbit};
use organza_core::{Result, scene};
use organza_data::{Dataset, Frame};

/// Number of cameras on each circle around a box.
const AROUND: usize = 16;
const ELEVATIONS: [f64; 3] = [-15.0, 17.0, 45.0];
/// Width and height of their images, in pixels.
const SIZE: [u32; 2] = [640, 480];
/// Without photographs, every Nth camera is only measured.
const HOLD_OUT_EVERY: usize = 8;

/// The views of a fit.
#[derive(Clone, Debug, PartialEq)]
pub struct Views {
    /// Views that the fit sees.
    pub fitted: Vec<Camera>,
    /// Views in which its result is only measured.
    pub held_out: Vec<Camera>,
}

impl Views {
    /// Every eighth camera is only measured. With fewer than eight, none is.
    pub fn from_cameras(cameras: Vec<Camera>) -> Self {
        let mut fitted = Vec::new();
        let mut held_out = Vec::new();
        let is_enough = cameras.len() >= HOLD_OUT_EVERY;
        for (index, camera) in cameras.into_iter().enumerate() {
            let is_held_out = is_enough && index % HOLD_OUT_EVERY == HOLD_OUT_EVERY / 2;
            if is_held_out { held_out.push(camera) } else { fitted.push(camera) }
        }
        Self { fitted, held_out }
    }

    /// The frames of a data set. Those that training saw are fitted, and the held-out ones are only measured. If
    /// there are no frames of one kind, the others are fitted.
    pub fn from_data_set(data: &Dataset) -> Self {
        let cameras = |frames: &mut dyn Iterator<Item = &Frame>| -> Vec<_> {
            frames.map(|frame| frame.camera.clone()).collect()
        };
        let fitted = cameras(&mut data.train_frames());
        let held_out = cameras(&mut data.held_out_frames());
        let (fitted, held_out) =
            if fitted.is_empty() { (held_out, fitted) } else { (fitted, held_out) };
        Self { fitted, held_out }
    }

    /// Cameras on several circles that see a whole box from all sides. Every eighth is only measured.
    ///
    /// # Errors
    /// [`Error::Invalid`](organza_core::Error::Invalid) if the box has no outside.
    pub fn around(aabb: [[f64; 3]; 2]) -> Result<Self> {
        let orbit = Orbit::from_box(aabb, SIZE);
        let circle = |elevation: f64| {
            Orbit { elevation: elevation.to_radians(), ..orbit.clone() }.cameras(AROUND)
        };
        let circles = ELEVATIONS.into_iter().map(circle).collect::<Result<Vec<_>>>()?;
        // alternates between the circles, so that the measured cameras come from all of them
        let at = |at: usize| circles.iter().map(move |circle| circle[at].clone());
        Ok(Self::from_cameras((0..AROUND).flat_map(at).collect()))
    }
}

impl SplatFile {
    /// Cameras of the world around nearly all of the opacity, as [`Views::around`] has them.
    ///
    /// # Errors
    /// The same errors as [`Views::around`].
    pub fn views(&self) -> Result<Views> {
        let mut views = Views::around(bounds(&self.splats))?;
        for camera in views.fitted.iter_mut().chain(&mut views.held_out) {
            *camera = self.placement.world_camera(camera);
        }
        Ok(views)
    }
}

/// The box of nearly all of the opacity, as [`scene::bounds`] says.
pub fn bounds(splats: &[Splat]) -> [[f64; 3]; 2] {
    let position: Vec<_> = splats.iter().map(|splat| splat.position).collect();
    let log_scale: Vec<_> = splats.iter().map(|splat| splat.log_scale).collect();
    let opacity: Vec<_> = splats.iter().map(|splat| splat.opacity).collect();
    scene::bounds(&position, &log_scale, &opacity)
}

/// Number of nearest cameras to which a camera has a path.
const NEAREST: usize = 6;
/// The golden ratio's inverse, whose multiples spread evenly between 0 and 1.
const GOLDEN: f64 = 0.618_033_988_749_895;

/// `count` cameras, each on the path from one camera to a near one that looks in a similar direction, up to 90
/// degrees apart. Empty if there is no such path.
///
/// # Errors
/// [`Error::Invalid`](organza_core::Error::Invalid) for a camera that is not valid.
pub fn between(cameras: &[Camera], count: usize) -> Result<Vec<Camera>> {
    if count == 0 {
        return Ok(Vec::new());
    }
    let ways: Vec<Vec<usize>> = (0..cameras.len()).map(|from| nearest(cameras, from)).collect();
    let starts: Vec<_> = (0..cameras.len()).filter(|&from| !ways[from].is_empty()).collect();
    if starts.is_empty() {
        return Ok(Vec::new());
    }
    let camera = |index: usize| {
        let from = starts[index % starts.len()];
        let to = ways[from][index / starts.len() % ways[from].len()];
        let from = &cameras[from];
        let to = cameras[to].with_size([from.width, from.height]);
        let part = (index + 1) as f64 * GOLDEN % 1.0;
        Ok(CameraPath::through(&[from.clone(), to], false)?.at(part))
    };
    (0..count).map(camera).collect()
}

/// The nearest cameras that look in a similar direction.
fn nearest(cameras: &[Camera], from: usize) -> Vec<usize> {
    let distance = |to: &usize| eye(&cameras[*to]).distance_squared(eye(&cameras[from]));
    let is_way = |to: &usize| *to != from && axis(&cameras[*to]).dot(axis(&cameras[from])) > 0.0;
    let mut others: Vec<_> = (0..cameras.len()).filter(is_way).collect();
    others.sort_by(|a, b| distance(a).total_cmp(&distance(b)));
    others.truncate(NEAREST);
    others
}

fn eye(camera: &Camera) -> DVec3 {
    DVec3::from(camera.eye())
}

/// The direction in which a camera looks, a unit vector.
fn axis(camera: &Camera) -> DVec3 {
    camera.axes()[2]
}

#[cfg(test)]
mod tests {
    use super::*;
    use organza_core::camera::Orbit;

    #[test]
    fn cameras_on_a_circle_have_others_between_them() {
        let orbit = Orbit::from_box([[-1.0; 3], [1.0; 3]], [40, 30]);
        let cameras = orbit.cameras(12).unwrap();
        let radius = orbit.distance;
        let found = between(&cameras, 100).unwrap();
        assert_eq!(found.len(), 100);
        let angle = |camera: &Camera| {
            let [x, y, z] = camera.eye();
            // on the sphere, looking at its center
            let eye = DVec3::new(x, y, z) - DVec3::from(orbit.center);
            let axis = camera.axes()[2];
            assert!((eye.length() / radius - 1.0).abs() < 0.1, "{eye} {radius}");
            assert!(axis.dot(-eye.normalize()) > 0.999, "{eye} {axis}");
            eye.y.atan2(eye.x)
        };
        let mut angles: Vec<_> = found.iter().map(angle).collect();
        angles.sort_by(f64::total_cmp);
        let widest = angles.windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max);
        // the cameras themselves are 0.52 apart
        assert!(widest < 0.3, "{widest}");
    }

    #[test]
    fn cameras_without_neighbors_have_no_views_between() {
        let camera = |x: f64, to: f64| {
            Camera::look_at([x, 0.0, 0.0], [to, 0.0, 0.0], [0.0, 0.0, 1.0], 0.7, [8, 8]).unwrap()
        };
        assert!(between(&[], 3).unwrap().is_empty());
        assert!(between(&[camera(0.0, 1.0)], 3).unwrap().is_empty());
        // cameras that look in opposite directions
        assert!(between(&[camera(0.0, 1.0), camera(-1.0, -2.0)], 3).unwrap().is_empty());
        assert_eq!(between(&[camera(0.0, 1.0), camera(-1.0, 2.0)], 3).unwrap().len(), 3);
    }
}
