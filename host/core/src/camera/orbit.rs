//! Orbits: circles of cameras around a place.

use std::f64::consts::TAU;

use glam::{DMat3, DVec3};

use super::{Camera, Target, median};
use crate::error::{Result, argument};

/// Horizontal field of view of [`Orbit::from_box`], in radians.
const ANGLE: f64 = 0.7;
/// Elevation of [`Orbit::from_box`] above the horizon, in radians.
const ELEVATION: f64 = 0.3;
/// Part of an image's horizontal direction that may point upward. It is small: the horizon of photographs is nearly
/// always level.
const SLANT: f64 = 0.01;
/// Length of the mean of directions, from which on cameras look in one direction.
const PARALLEL: f64 = 0.9;
/// Length of the mean of the images' upward directions, up to which these contradict each other.
const ROLLED: f64 = 0.5;
/// Cosine of the largest angle to z at which cameras look straight down: 15 degrees.
const STRAIGHT: f64 = 0.966;
/// Largest elevation of an orbit that is most like some cameras, in radians. Right above the center there is no circle.
const HIGHEST: f64 = TAU * 75.0 / 360.0;
/// Cameras with no wider gap between them, in radians, stand all around.
const WIDEST_GAP: f64 = TAU / 6.0;
/// Cameras that stand this far apart around the center, in radians, have little to do with each other.
const NEAR: f64 = TAU / 24.0;

/// A circle of cameras that all look at its center.
#[derive(Clone, Debug, PartialEq)]
pub struct Orbit {
    /// Point that the cameras look at, in world units.
    pub center: [f64; 3],
    /// Axis of the circle; upward in the images.
    pub up: [f64; 3],
    /// Direction from the center to the first camera; the part along `up` is ignored.
    pub toward: [f64; 3],
    /// Distance from the center, in world units.
    pub distance: f64,
    /// Angle above the plane through the center, in radians.
    pub elevation: f64,
    /// Horizontal field of view, in radians.
    pub angle: f64,
    /// Width and height of the image, in pixels.
    pub size: [u32; 2],
}

impl Orbit {
    /// Width and height of images in pixels, where no camera has a size.
    pub const SIZE: [u32; 2] = [640, 480];

    /// The orbit most like some given cameras: around the place that they look at, at their median distance and
    /// elevation. It starts where the first camera stands, with its image size and field of view.
    ///
    /// # Errors
    /// [`Error::Argument`](crate::Error::Argument) without cameras.
    pub fn around(cameras: &[Camera]) -> Result<Self> {
        let Some(first) = cameras.first() else {
            return argument("an orbit needs a camera");
        };
        let center = Target::from_cameras(cameras).center;
        let up = upward(cameras.iter());
        let offsets: Vec<_> =
            cameras.iter().map(|camera| DVec3::from(camera.eye()) - center).collect();
        let elevations = offsets.iter().map(|offset| offset.normalize_or_zero().dot(up).asin());
        let toward = offsets[0].reject_from_normalized(up);
        // a camera right above the center is on no side of it
        let is_above = toward.length() <= 1e-6 * offsets[0].length();
        Ok(Self {
            center: center.to_array(),
            up: up.to_array(),
            toward: if is_above { up.any_orthogonal_vector() } else { toward }.to_array(),
            distance: median(offsets.iter().map(|offset| offset.length())),
            elevation: median(elevations).clamp(-HIGHEST, HIGHEST),
            angle: 2.0 * (0.5 * f64::from(first.width) / first.fl_x).atan(),
            size: [first.width, first.height],
        })
    }

    /// `count` cameras on a closed path through the space where the given cameras stood. If these stand all around, the path is
    /// a ring that starts at the first camera. Otherwise it swings along the arc that they cover, and starts in its middle.
    /// Distance and elevation follow the cameras on the same side.
    ///
    /// # Errors
    /// [`Error::Argument`](crate::Error::Argument) without cameras; [`Error::Invalid`](crate::Error::Invalid) as
    /// [`Camera::look_at`].
    pub fn among(cameras: &[Camera], count: usize) -> Result<Vec<Camera>> {
        let orbit = Self::around(cameras)?;
        let center = DVec3::from(orbit.center);
        let up = DVec3::from(orbit.up);
        let ahead = DVec3::from(orbit.toward).normalize();
        let aside = up.cross(ahead);
        let places: Vec<_> = cameras
            .iter()
            .map(|camera| {
                let offset = DVec3::from(camera.eye()) - center;
                let azimuth = offset.dot(aside).atan2(offset.dot(ahead));
                [azimuth, offset.normalize_or_zero().dot(up).asin(), offset.length()]
            })
            .collect();
        let (middle, half) = arc(places.iter().map(|[azimuth, ..]| *azimuth));
        let camera = |index: usize| {
            let turn = TAU * index as f64 / count as f64;
            let azimuth = half.map_or(turn, |half| middle + half * turn.sin());
            let weight = |place: &[f64; 3]| {
                let apart = (azimuth - place[0] + 0.5 * TAU).rem_euclid(TAU) - 0.5 * TAU;
                (-0.5 * (apart / NEAR).powi(2)).exp()
            };
            let all: f64 = places.iter().map(weight).sum();
            let mean =
                |of: usize| places.iter().map(|place| weight(place) * place[of]).sum::<f64>() / all;
            let here = Self { distance: mean(2), elevation: mean(1), ..orbit.clone() };
            here.camera(azimuth, [ahead, aside, up])
        };
        (0..count).map(camera).collect()
    }

    /// An orbit around a box (its lowest and highest corner) that sees all of it; z is up.
    pub fn from_box([low, high]: [[f64; 3]; 2], size: [u32; 2]) -> Self {
        let [low, high] = [low, high].map(DVec3::from);
        let [width, height] = size.map(f64::from);
        // half the field of view along the image's shorter side
        let half = (0.5 * ANGLE).tan() * (height / width).min(1.0);
        Self {
            center: (0.5 * (low + high)).to_array(),
            up: [0.0, 0.0, 1.0],
            toward: [0.0, -1.0, 0.0],
            distance: 0.5 * (high - low).length() / half.atan().sin(),
            elevation: ELEVATION,
            angle: ANGLE,
            size,
        }
    }

    /// `count` cameras at equal intervals, once around, counterclockwise as seen from above.
    ///
    /// # Errors
    /// [`Error::Argument`](crate::Error::Argument) if `up` is zero or `toward` lies along it;
    /// [`Error::Invalid`](crate::Error::Invalid) as [`Camera::look_at`].
    pub fn cameras(&self, count: usize) -> Result<Vec<Camera>> {
        let up = DVec3::from(self.up).normalize_or_zero();
        let ahead = DVec3::from(self.toward).reject_from(DVec3::from(self.up)).normalize_or_zero();
        if !(up.is_finite() && ahead.is_finite()) || up == DVec3::ZERO || ahead == DVec3::ZERO {
            let up = self.up;
            let toward = self.toward;
            return argument(format!(
                "no circle has the axis {up:?} and begins toward {toward:?} of its center"
            ));
        }
        let aside = up.cross(ahead);
        let camera = |index| self.camera(TAU * index as f64 / count as f64, [ahead, aside, up]);
        (0..count).map(camera).collect()
    }

    /// The camera at an azimuth. The axes are unit vectors: toward azimuth 0, toward a quarter turn, and upward.
    fn camera(&self, azimuth: f64, [ahead, aside, up]: [DVec3; 3]) -> Result<Camera> {
        let (height, reach) = self.elevation.sin_cos();
        let (sin, cos) = azimuth.sin_cos();
        let offset = reach * (cos * ahead + sin * aside) + height * up;
        let eye = DVec3::from(self.center) + self.distance * offset;
        Camera::look_at(eye.to_array(), self.center, up.to_array(), self.angle, self.size)
    }
}

/// The middle and half the length of the arc that some azimuths cover. The length is `None` if they are all around.
fn arc(azimuths: impl Iterator<Item = f64>) -> (f64, Option<f64>) {
    let mut sorted: Vec<_> = azimuths.collect();
    sorted.sort_by(f64::total_cmp);
    let next = sorted.iter().skip(1).copied().chain(sorted.first().map(|first| first + TAU));
    let gaps = sorted.iter().zip(next).map(|(&from, to)| (to - from, to));
    let (gap, begin) = gaps.max_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or((TAU, 0.0));
    let half = 0.5 * (TAU - gap);
    (begin + half, (gap > WIDEST_GAP).then_some(half))
}

/// The world's upward direction, a unit vector, from how cameras were held.
///
/// The mean of the images' upward directions is biased if cameras look down from one side. But photographers hold the
/// horizon level, so an image's direction to the right is horizontal, and directions along it get little weight.
///
/// Images of cameras that look straight down show no upward direction, so it is opposite to their line of sight. Cameras
/// look straight down if all look in one direction, and it is -z or their images are turned in all directions.
/// Without cameras the result is z, as in most data sets.
pub fn upward<'a>(cameras: impl ExactSizeIterator<Item = &'a Camera> + Clone) -> DVec3 {
    let count = cameras.len() as f64;
    let mean = cameras.clone().map(|camera| camera.column(1)).sum::<DVec3>() / count.max(1.0);
    let back = cameras.clone().map(|camera| camera.column(2)).sum::<DVec3>() / count.max(1.0);
    if back.length() > PARALLEL {
        let back = back.normalize();
        if back.z > STRAIGHT {
            return DVec3::Z;
        }
        if mean.length() < ROLLED {
            return back;
        }
    }
    let level = cameras.fold(DMat3::from_diagonal(DVec3::splat(SLANT)), |sum, camera| {
        let right = camera.column(0);
        sum + DMat3::from_cols(right * right.x, right * right.y, right * right.z) * (1.0 / count)
    });
    let up = (level.inverse() * mean).normalize_or_zero();
    if mean.length() < 1e-6 || up == DVec3::ZERO { DVec3::Z } else { up }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(a: [f64; 3], b: [f64; 3], tolerance: f64) -> bool {
        DVec3::from(a).distance(DVec3::from(b)) < tolerance
    }

    fn orbit() -> Orbit {
        Orbit {
            center: [1.0, 2.0, 3.0],
            up: [0.0, 0.6, 0.8],
            toward: [1.0, 0.0, 0.0],
            distance: 5.0,
            elevation: 0.5,
            angle: 0.7,
            size: [96, 80],
        }
    }

    #[test]
    fn cameras_stand_on_the_circle_and_look_at_its_center() {
        let orbit = orbit();
        let [center, up] = [orbit.center, orbit.up].map(DVec3::from);
        let cameras = orbit.cameras(12).unwrap();
        for (index, camera) in cameras.iter().enumerate() {
            let offset = DVec3::from(camera.eye()) - center;
            assert!((offset.length() - 5.0).abs() < 1e-12);
            assert!((offset.dot(up) - 5.0 * 0.5_f64.sin()).abs() < 1e-12);
            let forward = camera.axes()[2];
            assert!(forward.distance(-offset / 5.0) < 1e-12);
            // counterclockwise, by 30 degrees each
            let next = DVec3::from(cameras[(index + 1) % 12].eye()) - center;
            let [a, b] = [offset, next].map(|offset| offset.reject_from_normalized(up));
            let sin = a.cross(b).dot(up);
            let cos = a.dot(b);
            assert!((sin.atan2(cos) - TAU / 12.0).abs() < 1e-12);
        }
        let first = DVec3::from(cameras[0].eye()) - center;
        assert!(close(
            first.reject_from_normalized(up).normalize().to_array(),
            orbit.toward,
            1e-12
        ));
        let half_width = 48.0 / cameras[0].fl_x;
        assert!((half_width - 0.35_f64.tan()).abs() < 1e-12);
    }

    #[test]
    fn an_orbit_is_found_from_its_own_cameras() {
        let orbit = orbit();
        let found = Orbit::around(&orbit.cameras(24).unwrap()).unwrap();
        assert!(close(found.center, orbit.center, 0.005), "{found:?}");
        assert!(close(found.up, orbit.up, 1e-3), "{found:?}");
        assert!((found.distance - 5.0).abs() < 0.005 && (found.elevation - 0.5).abs() < 0.002);
        assert!((found.angle - 0.7).abs() < 1e-12 && found.size == [96, 80]);
        let toward = DVec3::from(found.toward).normalize().to_array();
        assert!(close(toward, orbit.toward, 0.005), "{found:?}");
    }

    /// All cameras are on one side and look down: the mean of their upward directions leans by 20 degrees.
    #[test]
    fn cameras_on_one_side_do_not_tilt_the_axis() {
        let orbit = Orbit { elevation: 0.4, ..orbit() };
        let all = orbit.cameras(36).unwrap();
        let found = Orbit::around(&[&all[33..], &all[..4]].concat()).unwrap();
        let tilt = DVec3::from(found.up).dot(DVec3::from(orbit.up)).acos().to_degrees();
        assert!(tilt < 5.0, "{tilt}");
    }

    #[test]
    fn cameras_from_above_have_an_orbit_all_the_same() {
        let down = |yaw: f64| {
            Camera::look_at([0.0, 0.0, 4.0], [0.0; 3], [yaw.cos(), yaw.sin(), 0.0], 0.7, [8, 8])
        };
        let cameras: Vec<_> = (0..8).map(|i| down(TAU * f64::from(i) / 8.0).unwrap()).collect();
        let found = Orbit::around(&cameras).unwrap();
        assert!(close(found.up, [0.0, 0.0, 1.0], 1e-6), "{found:?}");
        // there is no orbit right above the center, but a little lower there is
        assert!((found.elevation.to_degrees() - 75.0).abs() < 1e-3);
        assert!(found.cameras(3).is_ok());
    }

    /// Images like a drone's that flies to and fro over flat ground at z = 0.
    #[test]
    fn an_orbit_of_cameras_that_look_straight_down_stays_above_the_ground() {
        // with the image's top always to the north, or ahead of the drone, and in a world whose y points down
        for (turns, y_down) in [(false, false), (true, false), (true, true)] {
            let camera = |i: u32| {
                let [x, y] = [f64::from(i % 7) - 3.0, f64::from(i / 7) - 3.0];
                let north = if turns && (i / 7) % 2 == 1 { -1.0 } else { 1.0 };
                let place = |[x, y, z]: [f64; 3]| if y_down { [x, -z, y] } else { [x, y, z] };
                let ground = place([x + 0.05 * y, y - 0.1, 0.0]);
                Camera::look_at(place([x, y, 4.0]), ground, place([0.1, north, 0.0]), 0.8, [64, 48])
            };
            let cameras: Vec<_> = (0..49).map(|i| camera(i).unwrap()).collect();
            let up = if y_down { -DVec3::Y } else { DVec3::Z };
            let orbit = Orbit::around(&cameras).unwrap();
            assert!(DVec3::from(orbit.up).dot(up) > 0.99, "{orbit:?}");
            for camera in orbit.cameras(24).unwrap() {
                assert!(DVec3::from(camera.eye()).dot(up) > 1.0, "{camera:?}");
            }
        }
    }

    /// Azimuth, elevation and distance of a camera, as an orbit with z up sees them.
    fn place(camera: &Camera) -> [f64; 3] {
        let eye = DVec3::from(camera.eye());
        [eye.y.atan2(eye.x), (eye.z / eye.length()).asin(), eye.length()]
    }

    /// A camera that looks at the origin.
    fn at([azimuth, elevation, distance]: [f64; 3]) -> Camera {
        let (sin, cos) = azimuth.sin_cos();
        let (height, reach) = elevation.sin_cos();
        let eye = [reach * cos, reach * sin, height].map(|x| distance * x);
        Camera::look_at(eye, [0.0; 3], [0.0, 0.0, 1.0], 0.7, [64, 48]).unwrap()
    }

    #[test]
    fn a_way_among_cameras_stays_where_they_stood() {
        // on an arc of 100 degrees around azimuth 170, which has the jump from 180 to -180 in it; higher at one end
        let arc: Vec<_> = (0..30)
            .map(|i| {
                let part = f64::from(i) / 29.0;
                let azimuth = (120.0 + 100.0 * part).to_radians();
                at([azimuth, 0.2 + 0.5 * part, 3.0 + 0.4 * f64::from(i % 3)])
            })
            .collect();
        let way = Orbit::among(&arc, 90).unwrap();
        let mut before = way[89].eye();
        let mut lowest = [f64::MAX; 3];
        let mut highest = [f64::MIN; 3];
        for camera in &way {
            let mut place = place(camera);
            place[0] = place[0].rem_euclid(TAU);
            for axis in 0..3 {
                lowest[axis] = lowest[axis].min(place[axis]);
                highest[axis] = highest[axis].max(place[axis]);
            }
            let step = DVec3::from(camera.eye()).distance(DVec3::from(before));
            assert!(step < 0.35, "a step of {step}");
            before = camera.eye();
        }
        let degrees = [lowest[0], highest[0]].map(f64::to_degrees);
        assert!(degrees[0] > 118.0 && degrees[0] < 125.0, "{degrees:?}");
        assert!(degrees[1] < 222.0 && degrees[1] > 215.0, "{degrees:?}");
        assert!(lowest[1] > 0.19 && highest[1] < 0.71 && highest[1] - lowest[1] > 0.3);
        assert!(lowest[2] > 2.9 && highest[2] < 3.9);

        // all around: once around, evenly
        let ring: Vec<_> = (0..9).map(|i| at([TAU * f64::from(i) / 9.0, 0.3, 4.0])).collect();
        for (index, camera) in Orbit::among(&ring, 12).unwrap().iter().enumerate() {
            let apart = place(camera)[0] - TAU * index as f64 / 12.0;
            let apart = (apart + 0.5 * TAU).rem_euclid(TAU) - 0.5 * TAU;
            assert!(apart.abs() < 0.02, "{apart} at {index}");
        }
        assert!(Orbit::among(&[], 3).is_err());
        let [one] = &Orbit::among(&arc[..1], 1).unwrap()[..] else { panic!("one camera") };
        assert!(DVec3::from(one.eye()).distance(DVec3::from(arc[0].eye())) < 1e-6);
    }

    #[test]
    fn the_whole_box_is_seen() {
        let corners = [[-1.0, -2.0, 0.0], [3.0, 1.0, 2.0]];
        for size in [[96, 80], [40, 90], [300, 20]] {
            for camera in Orbit::from_box(corners, size).cameras(7).unwrap() {
                for corner in 0..8 {
                    let place = |axis: usize| corners[corner >> axis & 1][axis];
                    let offset =
                        DVec3::new(place(0), place(1), place(2)) - DVec3::from(camera.eye());
                    let [x, y, z] = camera.axes().map(|axis| axis.dot(offset));
                    let x = camera.fl_x * x / z + camera.cx;
                    let y = camera.fl_y * y / z + camera.cy;
                    let [width, height] = size.map(f64::from);
                    assert!(z > 0.0 && (0.0..width).contains(&x) && (0.0..height).contains(&y));
                }
            }
        }
    }

    #[test]
    fn invalid_orbits_are_refused() {
        assert!(Orbit::around(&[]).is_err());
        for orbit in [
            Orbit { up: [0.0; 3], ..orbit() },
            Orbit { toward: [0.0, 6.0, 8.0], ..orbit() },
            Orbit { toward: [f64::NAN; 3], ..orbit() },
            Orbit { distance: 0.0, ..orbit() },
            Orbit { distance: f64::INFINITY, ..orbit() },
            Orbit { angle: 4.0, ..orbit() },
        ] {
            assert!(orbit.cameras(4).is_err(), "{orbit:?}");
        }
    }
}
