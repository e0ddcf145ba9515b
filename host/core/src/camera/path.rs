//! Smooth paths through keyframes.

use glam::{DMat3, DQuat, DVec3};

use super::{Camera, Target};
use crate::error::{Result, argument};

/// Shortest time between two keys, as a fraction of the mean. With it, two equal keys make the camera stop and not
/// jump.
const SHORTEST: f64 = 0.01;
/// Direction in which a camera looks, in its own axes.
const FORWARD: DVec3 = DVec3::NEG_Z;

/// A smooth path through keys: cameras of one image size.
///
/// A Catmull-Rom spline interpolates the target, the distance to it, the rotation, the logarithm of the focal lengths
/// (so a zoom looks steady) and the principal point. Between two keys it is a cubic Bézier curve. At a key, it has the
/// tangent of the parabola through the key and its neighbors. Rotations use spherical interpolation in the curve's
/// construction (Shoemake, "Animating rotation with quaternion curves", 1985).
///
/// If all keys look at one place, a key's target is the point of its axis nearest to that place. The camera then
/// turns around the place and keeps it in view. Otherwise the distance is 0, and the spline interpolates the camera's
/// position.
///
/// The time between two keys is proportional to the camera's way, so the camera moves at an even pace. Position and
/// rotation have continuous velocities everywhere.
///
/// ```
/// use organza_core::Camera;
/// use organza_core::camera::CameraPath;
///
/// let camera = |x, angle| Camera::look_at([x, -4.0, 1.0], [0.0; 3], [0.0, 0.0, 1.0], angle, [64, 48]);
/// let keys = [camera(-1.0, 0.8)?, camera(0.0, 0.6)?, camera(1.0, 0.8)?];
/// let path = CameraPath::through(&keys, false)?;
/// assert_eq!(path.times()[0], 0.0);
/// assert!((path.at(0.5).eye()[0] - 0.0).abs() < 1e-9);
/// assert_eq!(path.cameras(120).len(), 120);
/// # Ok::<(), organza_core::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct CameraPath {
    size: [u32; 2],
    keys: Vec<PathState>,
    /// The motion in a unit of time at each key.
    tangents: Vec<Motion>,
    /// Time of each key, from 0. A closed path has one more: the time back at the first key.
    times: Vec<f64>,
}

impl CameraPath {
    /// A path through `keys`, which have images of one size ([`Camera::with_size`] gives them one). A closed path
    /// leads from the last key back to the first.
    ///
    /// # Errors
    /// [`Error::Argument`](crate::Error::Argument) for fewer than two keys, or if sizes differ;
    /// [`Error::Invalid`](crate::Error::Invalid) for the first key that is not valid.
    pub fn through(keys: &[Camera], is_closed: bool) -> Result<Self> {
        let size = |camera: &Camera| [camera.width, camera.height];
        let (first, others) = match keys {
            [first, others @ ..] if !others.is_empty() => (first, others),
            _ => {
                return argument(format!(
                    "a path needs two cameras at least; found {}",
                    keys.len()
                ));
            }
        };
        if let Some(other) = others.iter().find(|other| size(other) != size(first)) {
            let [(w, h), (v, g)] = [first, other].map(|camera| (camera.width, camera.height));
            return argument(format!(
                "the cameras of a path need images of one size; found {w} x {h} and {v} x {g}"
            ));
        }
        for (index, key) in keys.iter().enumerate() {
            key.validate(index)?;
        }
        let target = Target::from_cameras(keys);
        let center = target.is_met.then_some(target.center);
        let keys: Vec<_> = keys.iter().map(|key| PathState::from_camera(key, center)).collect();
        let spread = extent(&keys);
        let segments = if is_closed { keys.len() } else { keys.len() - 1 };
        let pairs = || (0..segments).map(|key| (&keys[key], &keys[(key + 1) % keys.len()]));
        let spans = spans(pairs().map(|(a, b)| a.way_to(b, spread)).collect());
        let rates: Vec<_> =
            pairs().zip(&spans).map(|((a, b), span)| a.motion_to(b).times(1.0 / span)).collect();
        let tangents = tangents(&rates, &spans, is_closed);
        let mut times = vec![0.0];
        times.extend(spans.iter().scan(0.0, |time, span| {
            *time += span;
            Some(*time)
        }));
        Ok(Self { size: size(first), keys, tangents, times })
    }

    /// Time of each key, from 0 to 1. On a closed path, 1 is the time back at the first key.
    pub fn times(&self) -> Vec<f64> {
        self.times.iter().map(|time| time / self.end()).collect()
    }

    /// The camera at a time from 0 to 1.
    #[must_use]
    pub fn at(&self, time: f64) -> Camera {
        let time = time.clamp(0.0, 1.0) * self.end();
        let last = self.times.len() - 2;
        let key = self.times[1..].partition_point(|end| *end <= time).min(last);
        let span = self.times[key + 1] - self.times[key];
        let part = (time - self.times[key]) / span;
        let next = (key + 1) % self.keys.len();
        let a = &self.keys[key];
        let b = &self.keys[next];
        // Bézier's control points, and de Casteljau's construction
        let mut points = vec![
            a.clone(),
            a.moved(&self.tangents[key].times(span / 3.0)),
            b.moved(&self.tangents[next].times(-span / 3.0)),
            b.clone(),
        ];
        while points.len() > 1 {
            points = points.windows(2).map(|pair| pair[0].toward(&pair[1], part)).collect();
        }
        points[0].camera(self.size)
    }

    /// `count` cameras at equal intervals: from the first key to the last, or once around a closed path. On a closed path,
    /// the first camera follows the last.
    #[must_use]
    pub fn cameras(&self, count: usize) -> Vec<Camera> {
        let is_closed = self.times.len() > self.keys.len();
        let intervals = if is_closed { count } else { count.saturating_sub(1) };
        (0..count).map(|index| self.at(index as f64 / intervals.max(1) as f64)).collect()
    }

    fn end(&self) -> f64 {
        self.times[self.times.len() - 1]
    }
}

/// The values that a path interpolates.
#[derive(Clone, Debug)]
struct PathState {
    /// The point that the camera looks at, in world units.
    target: DVec3,
    /// Distance to the target, in world units.
    distance: f64,
    /// From the camera's axes to the world's.
    rotation: DQuat,
    /// Logarithms of the focal lengths, and the principal point.
    lens: [f64; 4],
}

/// A change of a [`PathState`].
#[derive(Clone, Debug)]
struct Motion {
    shift: DVec3,
    distance: f64,
    /// Rotation vector in world space: along the axis, as long as the angle in radians.
    turn: DVec3,
    lens: [f64; 4],
}

impl PathState {
    /// `center` is the place that all keys look at, if there is one.
    fn from_camera(camera: &Camera, center: Option<DVec3>) -> Self {
        let eye = DVec3::from(camera.eye());
        let axis = camera.axes()[2];
        let distance = center.map_or(0.0, |center| (center - eye).dot(axis).max(0.0));
        let [x, y, z] = [0, 1, 2].map(|column| camera.column(column));
        let rotation = DQuat::from_mat3(&DMat3::from_cols(x, y, z)).normalize();
        Self {
            target: eye + rotation * (distance * FORWARD),
            distance,
            rotation,
            lens: [camera.fl_x.ln(), camera.fl_y.ln(), camera.cx, camera.cy],
        }
    }

    fn eye(&self) -> DVec3 {
        self.target - self.rotation * (self.distance * FORWARD)
    }

    fn camera(&self, size: [u32; 2]) -> Camera {
        let eye = self.eye();
        let axes = DMat3::from_quat(self.rotation.normalize());
        let row = |row: usize| {
            let [x, y, z] = axes.row(row).to_array();
            [x, y, z, eye[row]]
        };
        let [log_x, log_y, cx, cy] = self.lens;
        let pose = [row(0), row(1), row(2), [0.0, 0.0, 0.0, 1.0]];
        Camera::pinhole(pose, [log_x.exp(), log_y.exp()], [cx, cy], size)
    }

    fn motion_to(&self, other: &Self) -> Motion {
        let turn = other.rotation * self.rotation.inverse();
        // the shorter way around
        let turn = if turn.w < 0.0 { -turn } else { turn };
        Motion {
            shift: other.target - self.target,
            distance: other.distance - self.distance,
            turn: turn.to_scaled_axis(),
            lens: std::array::from_fn(|i| other.lens[i] - self.lens[i]),
        }
    }

    fn moved(&self, motion: &Motion) -> Self {
        Self {
            target: self.target + motion.shift,
            distance: self.distance + motion.distance,
            rotation: DQuat::from_scaled_axis(motion.turn) * self.rotation,
            lens: std::array::from_fn(|i| self.lens[i] + motion.lens[i]),
        }
    }

    /// Apparent length of the way: the angle in radians, and the shift divided by the keys' spread. On a circle around
    /// the target both are the same.
    fn way_to(&self, other: &Self, spread: f64) -> f64 {
        let Motion { turn, lens, .. } = self.motion_to(other);
        let shift = if spread > 0.0 { self.eye().distance(other.eye()) / spread } else { 0.0 };
        let zoom = lens[0].abs().max(lens[1].abs());
        DVec3::new(shift, turn.length(), zoom).length()
    }

    fn toward(&self, other: &Self, part: f64) -> Self {
        self.moved(&self.motion_to(other).times(part))
    }
}

impl Motion {
    fn times(&self, factor: f64) -> Self {
        let lens = self.lens.map(|value| value * factor);
        let shift = self.shift * factor;
        let turn = self.turn * factor;
        Self { shift, distance: self.distance * factor, turn, lens }
    }

    fn plus(&self, other: &Self) -> Self {
        Self {
            shift: self.shift + other.shift,
            distance: self.distance + other.distance,
            turn: self.turn + other.turn,
            lens: std::array::from_fn(|i| self.lens[i] + other.lens[i]),
        }
    }
}

/// Root mean square of the positions' distances from their center.
fn extent(keys: &[PathState]) -> f64 {
    let count = keys.len() as f64;
    let center = keys.iter().map(|key| key.eye()).sum::<DVec3>() / count;
    let squares = keys.iter().map(|key| key.eye().distance_squared(center));
    (squares.sum::<f64>() / count).sqrt()
}

/// The time of each segment, proportional to its length.
fn spans(lengths: Vec<f64>) -> Vec<f64> {
    let mean = lengths.iter().sum::<f64>() / lengths.len() as f64;
    // if the camera stands still, every segment gets the same time
    let mean = if mean > 0.0 { mean } else { 1.0 };
    lengths.into_iter().map(|length| length.max(SHORTEST * mean)).collect()
}

/// The tangent at each key, taken from the parabola through the key and its neighbors. `rates` are the mean velocities of
/// the segments.
fn tangents(rates: &[Motion], spans: &[f64], is_closed: bool) -> Vec<Motion> {
    let inner = |before: usize, after: usize| {
        let a = spans[before];
        let b = spans[after];
        rates[before].times(b / (a + b)).plus(&rates[after].times(a / (a + b)))
    };
    let last = rates.len() - 1;
    if is_closed {
        return (0..=last).map(|key| inner((key + last) % (last + 1), key)).collect();
    }
    if last == 0 {
        return vec![rates[0].clone(); 2];
    }
    // the parabolas through the first three keys and through the last three
    let end = |rate: &Motion, tangent: &Motion| rate.times(2.0).plus(&tangent.times(-1.0));
    let between: Vec<_> = (1..=last).map(|key| inner(key - 1, key)).collect();
    let first = end(&rates[0], &between[0]);
    let final_one = end(&rates[last], &between[last - 1]);
    std::iter::once(first).chain(between).chain([final_one]).collect()
}

#[cfg(test)]
mod tests;
