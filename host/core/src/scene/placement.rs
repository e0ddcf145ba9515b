//! Where a scene lies in the world.

use std::path::Path;

use glam::{DMat3, DQuat, DVec3};
use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::camera::{Camera, Target, median, upward};
use crate::error::{Error, Result, bad_config, refuse};

/// Distance of the cameras from what they look at, in units of the scene. The near plane at 0.01 is then close to them.
const DISTANCE: f64 = 4.0;
/// The same for cameras that look at no common place: some may stand close to objects.
const SPREAD_DISTANCE: f64 = 100.0;
/// Cosine of 5 degrees. If the cameras' upward direction is this close to an axis of the world, the data set is aligned, and
/// the axis is taken.
const ALIGNED: f64 = 0.996_194_698_091_745_5;
/// Smallest distance between cameras, relative to their coordinates, that is not a rounding error.
const ROUNDING: f64 = 1e-12;
/// How many times larger or smaller a scene may become beside another. Squares of coordinates must be finite in f32.
const LARGEST: f64 = 1e9;
/// How far from another scene's origin a scene may lie, in units of that scene, for the same reason.
const FARTHEST: f64 = 1e12;
/// Largest difference of the axes from unit vectors at right angles.
const ORTHONORMAL: f64 = 1e-6;

/// Where a scene lies in the world, which is the data set's own space: `world = offset + scale R own`.
///
/// A scene has coordinates of its own, so that positions as f32 keep their digits, the near plane fits, and up is z. The default
/// leaves everything where it is.
///
/// ```
/// use organza_core::Camera;
/// use organza_core::scene::Placement;
///
/// // a ring of cameras 4 mm from an object, in meters, and far from the origin
/// let camera = |turn: f64| {
///     let eye = [5e5 + 0.004 * turn.cos(), 5e6 + 0.004 * turn.sin(), 300.0];
///     Camera::look_at(eye, [5e5, 5e6, 300.0], [0.0, 0.0, 1.0], 0.8, [640, 480])
/// };
/// let cameras: Vec<_> = (0..8).map(|i| camera(f64::from(i))).collect::<Result<_, _>>()?;
/// let placement = Placement::of(&cameras, &[]);
/// let own = placement.own_camera(&cameras[0]);
/// assert!(own.eye().iter().all(|x| x.abs() < 4.1));
/// # Ok::<(), organza_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Placement {
    /// The scene's origin, in world units.
    pub offset: [f64; 3],
    /// World units in one unit of the scene.
    pub scale: f64,
    /// The scene's z axis in the world, a unit vector.
    pub up: [f64; 3],
    /// The scene's x axis in the world, a unit vector.
    pub right: [f64; 3],
    /// Meters in one world unit, if they are known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub meters: Option<f64>,
}

/// Where a scene is put in the world of another: `offset + scale R world`. The default leaves it where its own world has it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Place {
    /// The origin of the scene's world.
    pub offset: [f64; 3],
    /// R: a turn around this axis, by its length in degrees.
    pub turn: [f64; 3],
    /// The length of one unit.
    pub scale: f64,
    /// Whether both scenes are parts of one world. Then nothing is turned upright, and units are the same.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub same_world: bool,
}

impl Default for Place {
    fn default() -> Self {
        Self { offset: [0.0; 3], turn: [0.0; 3], scale: 1.0, same_world: false }
    }
}

impl Place {
    fn check(&self) -> Result<()> {
        let Self { offset, turn, scale, .. } = *self;
        for (name, values) in [("offset", offset), ("turn", turn)] {
            if !values.iter().all(|value| value.is_finite()) {
                return refuse(format!("`{name}` is {values:?}, expected finite numbers"));
            }
        }
        match scale > 0.0 && scale.is_finite() {
            true => Ok(()),
            false => refuse(format!("`scale` is {scale:?}, expected a positive number")),
        }
    }
}

impl Default for Placement {
    fn default() -> Self {
        let up = [0.0, 0.0, 1.0];
        Self { offset: [0.0; 3], scale: 1.0, up, right: [1.0, 0.0, 0.0], meters: None }
    }
}

impl Placement {
    /// The placement in which cameras surround the origin at a standard distance, with z up. A similarity of the cameras
    /// changes it alike. `points` give a distance to cameras that stand still.
    pub fn of(cameras: &[Camera], points: &[[f64; 3]]) -> Self {
        let eye = |camera: &Camera| DVec3::from(camera.eye());
        // first the axes, so that nothing else depends on the world's axes
        let up = aligned(upward(cameras.iter()));
        let right = cameras.first().map_or(DVec3::X, |first| rightward(first, up));
        let axes = Self { up: up.to_array(), right: right.to_array(), ..Self::default() };
        let along = |axis: usize| median(cameras.iter().map(|camera| axes.own(camera.eye())[axis]));
        let middle = DVec3::from(axes.world([along(0), along(1), along(2)]));
        let spread = median(cameras.iter().map(|camera| eye(camera).distance(middle)));
        let is_still = spread <= ROUNDING * middle.abs().max_element();
        let unit = match is_still {
            false => spread,
            true => median(points.iter().map(|point| DVec3::from(*point).distance(middle))),
        };
        let unit = if unit > 0.0 && unit.is_finite() { unit } else { 1.0 };
        // from here on, numbers are near 1
        let near = Self { offset: middle.to_array(), scale: unit, ..axes };
        let cameras: Vec<_> = cameras.iter().map(|camera| near.own_camera(camera)).collect();
        let target = Target::from_cameras(&cameras);
        let distance = if target.is_met || is_still { DISTANCE } else { SPREAD_DISTANCE };
        let offset = near.world(target.center.to_array());
        Self { offset, scale: unit * target.distance / distance, ..axes }
    }

    /// Parses a placement from JSON of the file `origin`, which is not a scene.
    ///
    /// # Errors
    /// [`Error::Invalid`] for another structure; [`Error::BadConfig`] for a value that is out of range.
    pub fn from_json(json: &Value, origin: &Path) -> Result<Self> {
        let placement = Self::deserialize(json).map_err(|error| {
            let reason = format!("it does not say where it lies as organza writes it: {error}");
            Error::Invalid { origin: origin.to_owned(), reason }
        })?;
        placement.check().map_err(|error| error.in_file(origin))?;
        Ok(placement)
    }

    /// The same placement in a world with meters as units, if meters are known.
    #[must_use]
    pub fn in_meters(&self) -> Self {
        let meters = self.meters.unwrap_or(1.0);
        let offset = self.offset.map(|x| x * meters);
        Self { offset, scale: self.scale * meters, meters: None, ..*self }
    }

    /// Whether the scene's coordinates equal the world's.
    pub fn is_identity(&self) -> bool {
        *self == Self::default()
    }

    /// The rotation from the scene's axes to the world's.
    pub fn rotation(&self) -> DMat3 {
        let up = DVec3::from(self.up);
        let right = DVec3::from(self.right);
        DMat3::from_cols(right, up.cross(right), up)
    }

    /// A place of the world, in the scene.
    pub fn own(&self, place: [f64; 3]) -> [f64; 3] {
        let offset = DVec3::from(place) - DVec3::from(self.offset);
        (self.rotation().transpose() * offset / self.scale).to_array()
    }

    /// A place of the scene, in the world.
    pub fn world(&self, place: [f64; 3]) -> [f64; 3] {
        let offset = self.rotation() * DVec3::from(place) * self.scale;
        (DVec3::from(self.offset) + offset).to_array()
    }

    /// The box of the world around a box of the scene.
    pub fn world_box(&self, ends: [[f64; 3]; 2]) -> [[f64; 3]; 2] {
        around(ends, |place| self.world(place))
    }

    /// The box of the scene around a box of the world.
    pub fn own_box(&self, ends: [[f64; 3]; 2]) -> [[f64; 3]; 2] {
        around(ends, |place| self.own(place))
    }

    /// The upward direction of a scene with this placement, in its own coordinates: z, as was found when it was placed. A scene in
    /// the world's own coordinates does not know it, so `cameras`, all that it was made of, say how they were held.
    pub fn upward(&self, cameras: &[Camera]) -> [f64; 3] {
        match self.is_identity() {
            true => aligned(upward(cameras.iter())).to_array(),
            false => [0.0, 0.0, 1.0],
        }
    }

    /// A direction of the scene, in the world.
    pub fn world_direction(&self, direction: [f64; 3]) -> [f64; 3] {
        (self.rotation() * DVec3::from(direction)).to_array()
    }

    /// A camera of the world, in the scene. Its image stays as it is.
    #[must_use]
    pub fn own_camera(&self, camera: &Camera) -> Camera {
        if self.is_identity() {
            return camera.clone();
        }
        placed(camera, self.rotation().transpose(), self.own(camera.eye()))
    }

    /// Reads cameras of the world, as [`Camera::load_all`] does, into the scene.
    pub fn load_cameras(&self, path: impl AsRef<Path>) -> Result<Vec<Camera>> {
        Ok(Camera::load_all(path)?.iter().map(|camera| self.own_camera(camera)).collect())
    }

    /// A camera of the scene, in the world. Its image stays as it is.
    #[must_use]
    pub fn world_camera(&self, camera: &Camera) -> Camera {
        if self.is_identity() {
            return camera.clone();
        }
        placed(camera, self.rotation(), self.world(camera.eye()))
    }

    /// The place of another scene in this one: that scene's own coordinates are turned into this one's. `put` moves the
    /// world of `other` in this scene's world. Before that, upward directions become one, and so do units if both know meters,
    /// unless it is one world.
    ///
    /// # Errors
    /// [`Error::Invalid`] for a number that is not finite, a scale that is not positive, or a place that is much farther away, or
    /// makes the scene much larger or smaller, than f32 can hold.
    pub fn place(&self, other: &Self, put: &Place) -> Result<Self> {
        put.check()?;
        let meters = other.meters.zip(self.meters).map_or(1.0, |(other, own)| other / own);
        let scale = if put.same_world { put.scale } else { put.scale * meters };
        let turn = DQuat::from_scaled_axis(DVec3::from(put.turn.map(f64::to_radians)));
        let upright = match put.same_world {
            true => DQuat::IDENTITY,
            false => DQuat::from_rotation_arc(DVec3::from(other.up), DVec3::from(self.up)),
        };
        let turn = DMat3::from_quat(turn * upright);
        let origin = DVec3::from(put.offset) + turn * DVec3::from(other.offset) * scale;
        let axes = self.rotation().transpose() * turn * other.rotation();
        let place = Self {
            offset: self.own(origin.to_array()),
            scale: scale * other.scale / self.scale,
            up: axes.z_axis.to_array(),
            right: axes.x_axis.to_array(),
            meters: None,
        };
        let times = place.scale;
        if !(LARGEST.recip()..=LARGEST).contains(&times) {
            return refuse(format!(
                "`scale` is {:?}, which makes the scene {times:e} times as large, expected {:e} to {LARGEST:e}",
                put.scale,
                LARGEST.recip()
            ));
        }
        if !place.offset.iter().all(|x| x.abs() <= FARTHEST) {
            let reason =
                format!("`offset` is {:?}, which is too far from the first scene", put.offset);
            return refuse(reason);
        }
        place.check()?;
        Ok(place)
    }

    pub(super) fn check(&self) -> Result<()> {
        let Self { offset, scale, up, right, meters } = self;
        let bad = |reason| bad_config("placement", reason);
        if !offset.iter().all(|value| value.is_finite()) {
            return bad(format!("has the offset {offset:?}, expected finite numbers"));
        }
        let mut lengths = [Some(*scale), *meters].into_iter().flatten();
        if let Some(length) = lengths.find(|x| !(x.is_normal() && *x > 0.0)) {
            return bad(format!("has a scale of {length}, expected a positive number"));
        }
        let rotation = self.rotation();
        let off = rotation.transpose() * rotation - DMat3::IDENTITY;
        // false for NaN
        let is_small = |x: f64| x.abs() <= ORTHONORMAL;
        if !off.to_cols_array().into_iter().all(is_small) {
            return bad(format!(
                "has the axes {right:?} (right) and {up:?} (up), expected unit vectors at right angles"
            ));
        }
        Ok(())
    }
}

/// The box around the corners of another one, each at its new place.
fn around(ends: [[f64; 3]; 2], place: impl Fn([f64; 3]) -> [f64; 3]) -> [[f64; 3]; 2] {
    let corner = |at: usize| DVec3::from(place([0, 1, 2].map(|axis| ends[at >> axis & 1][axis])));
    let first = [DVec3::INFINITY, DVec3::NEG_INFINITY];
    let all = (0..8).map(corner).fold(first, |[low, high], at| [low.min(at), high.max(at)]);
    all.map(|end| end.to_array())
}

/// A horizontal axis, given the upward one. If `up` is an axis of the world, so is the result. Otherwise it points to the
/// first camera.
fn rightward(first: &Camera, up: DVec3) -> DVec3 {
    if up.abs().max_element() == 1.0 {
        return if up.x == 0.0 { DVec3::X } else { -up.x * DVec3::Z };
    }
    let axis = |column: usize| first.column(column).reject_from_normalized(up);
    // a camera that looks straight down has an upper edge
    let level = if axis(2).length() > 1e-3 { axis(2) } else { axis(1) };
    level.try_normalize().unwrap_or_else(|| up.any_orthonormal_vector())
}

/// The world's axis that is close to a direction; the direction itself if none is.
fn aligned(up: DVec3) -> DVec3 {
    let axis = up.round();
    if axis.length_squared() == 1.0 && axis.dot(up) >= ALIGNED { axis } else { up }
}

/// A camera with turned axes, at another place.
fn placed(camera: &Camera, turn: DMat3, eye: [f64; 3]) -> Camera {
    let mut placed = camera.clone();
    let rows = &mut placed.camera_to_world;
    for axis in 0..3 {
        let turned = (turn * camera.column(axis)).to_array();
        turned.into_iter().zip(rows.iter_mut()).for_each(|(value, row)| row[axis] = value);
    }
    eye.into_iter().zip(rows.iter_mut()).for_each(|(value, row)| row[3] = value);
    placed
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A ring of cameras around a place, in a world that a similarity has moved.
    fn ring(turn: DMat3, scale: f64, offset: DVec3) -> Vec<Camera> {
        let camera = |i: u32| {
            let (sin, cos) = (f64::from(i) * std::f64::consts::TAU / 12.0).sin_cos();
            let place = |place: [f64; 3]| (offset + scale * (turn * DVec3::from(place))).to_array();
            let eye = place([1.0 + 4.0 * cos, 2.0 + 4.0 * sin, 5.0]);
            let up = (turn * DVec3::Z).to_array();
            Camera::look_at(eye, place([1.0, 2.0, 3.0]), up, 0.8, [64, 48]).unwrap()
        };
        (0..12).map(camera).collect()
    }

    #[test]
    fn own_coordinates_do_not_depend_on_the_world() {
        let turned = DMat3::from_rotation_x(0.7) * DMat3::from_rotation_z(-2.0);
        let upside_down = DMat3::from_rotation_x(std::f64::consts::PI);
        let y_down = DMat3::from_rotation_x(std::f64::consts::FRAC_PI_2);
        let expected = ring(DMat3::IDENTITY, 1.0, DVec3::ZERO);
        let at_home = Placement::of(&expected, &[]);
        assert_eq!((at_home.up, at_home.right), ([0.0, 0.0, 1.0], [1.0, 0.0, 0.0]));
        let expected: Vec<_> = expected.iter().map(|camera| at_home.own_camera(camera)).collect();
        let utm = DVec3::new(512_345.25, 4_612_345.5, 312.0);
        let ecef = DVec3::new(3_782_000.0, 902_000.0, 5_038_000.0);
        for (turn, scale, offset) in [
            (DMat3::IDENTITY, 1e-4, DVec3::ZERO),
            (DMat3::IDENTITY, 1e4, DVec3::ZERO),
            (DMat3::IDENTITY, 1.0, utm),
            (turned, 1.0, ecef),
            (turned, 1e-4, DVec3::ONE),
            (y_down, 1.0, DVec3::ZERO),
            (upside_down, 1.0, DVec3::ZERO),
        ] {
            let world = ring(turn, scale, offset);
            let placement = Placement::of(&world, &[]);
            assert!(placement.check().is_ok(), "{placement:?}");
            for (camera, expected) in world.iter().zip(&expected) {
                let own = placement.own_camera(camera);
                let pairs = own.camera_to_world.as_flattened().iter();
                for (found, expected) in pairs.zip(expected.camera_to_world.as_flattened()) {
                    assert!((found - expected).abs() < 1e-7, "{scale}, {offset}: {own:?}");
                }
                let back = placement.world_camera(&own);
                let apart = DVec3::from(back.eye()).distance(DVec3::from(camera.eye()));
                assert!(apart <= 1e-9 * scale.max(offset.length()), "{apart}");
            }
        }
    }

    #[test]
    fn the_cameras_surround_the_origin_at_one_distance_and_stand_upright() {
        let world = ring(DMat3::from_rotation_y(0.4), 30.0, DVec3::ONE);
        let placement = Placement::of(&world, &[]);
        for camera in world.iter().map(|camera| placement.own_camera(camera)) {
            assert!((DVec3::from(camera.eye()).length() - DISTANCE).abs() < 1e-6);
            // level images: the direction to the right has no part along z
            assert!(camera.camera_to_world[2][0].abs() < 1e-6);
            assert!(camera.camera_to_world[2][1] > 0.0);
        }
    }

    /// Up is decided once: it is not of the cameras that a command sees. These hold theirs with some roll.
    #[test]
    fn a_placed_scene_keeps_its_upward_direction() {
        let held = |(at, camera): (usize, &Camera)| {
            camera.moved([0.0, 0.0, if at < 6 { 0.1 } else { -0.1 }, 0.0, 0.0, 0.0])
        };
        let ring = ring(DMat3::from_rotation_x(0.7), 3.0, DVec3::ONE);
        let world: Vec<_> = ring.iter().enumerate().map(held).collect();
        let placement = Placement::of(&world, &[]);
        let own: Vec<_> = world.iter().map(|camera| placement.own_camera(camera)).collect();
        for cameras in [&own[..], &own[..5], &own[7..]] {
            assert_eq!(placement.upward(cameras), [0.0, 0.0, 1.0]);
        }
        assert!(upward(own[..3].iter()).angle_between(DVec3::Z) > 0.03);
        // a scene in its world's coordinates
        let up = DVec3::from(Placement::default().upward(&world));
        assert!(up.distance(DVec3::from(placement.up)) < 1e-9, "{up}");
    }

    /// Parts of one world stay where it has them, whatever the parts' own up and units are.
    #[test]
    fn parts_of_one_world_lie_as_it_has_them() {
        let [first, other] = [0.7, 0.9].map(|angle| {
            let world = ring(DMat3::from_rotation_x(angle), 3.0, DVec3::splat(angle));
            Placement { meters: Some(angle), ..Placement::of(&world, &[]) }
        });
        let place = first.place(&other, &Place { same_world: true, ..Place::default() }).unwrap();
        for point in [[0.0; 3], [1.0, 0.0, 0.0], [0.3, -2.0, 5.0]] {
            let found = DVec3::from(first.world(place.world(point)));
            assert!(found.distance(DVec3::from(other.world(point))) < 1e-9, "{found:?}");
        }
    }

    #[test]
    fn a_scene_is_put_upright_and_in_meters() {
        let turned = DMat3::from_rotation_x(std::f64::consts::FRAC_PI_2);
        let world = ring(turned, 30.0, DVec3::ONE);
        let other = Placement { meters: Some(0.01), ..Placement::of(&world, &[]) };
        let room = Placement::of(&ring(DMat3::IDENTITY, 2.0, DVec3::new(5.0, 0.0, 0.0)), &[]);
        let room = Placement { meters: Some(0.5), ..room };
        let offset = [1.0, 2.0, 3.0];
        let put = Place { offset, turn: [0.0, 0.0, 90.0], scale: 2.0, ..Place::default() };
        let place = room.place(&other, &put).unwrap();
        for point in [[0.0; 3], [1.0, 0.0, 0.0], [0.3, -2.0, 5.0]] {
            let [x, y, z] = other.world(point);
            // upright, that world's place is (x, z, -y), and then it is turned
            let expected = [0, 1, 2].map(|axis| put.offset[axis] + 2.0 * 0.02 * [-z, x, -y][axis]);
            let found = room.world(place.world(point));
            let apart = DVec3::from(found).distance(DVec3::from(expected));
            assert!(apart < 1e-9, "{found:?}, {expected:?}");
        }
        for bad in [
            Place { scale: 0.0, ..put },
            Place { scale: -1.0, ..put },
            Place { turn: [f64::NAN, 0.0, 0.0], ..put },
            Place { offset: [0.0, f64::INFINITY, 0.0], ..put },
            Place { scale: 1e-300, ..put },
            Place { offset: [0.0, 1e300, 0.0], ..put },
        ] {
            assert!(room.place(&other, &bad).is_err(), "{bad:?}");
        }
    }

    #[test]
    fn points_are_the_measure_of_a_camera_that_stands_still() {
        let up = [0.0, 0.0, 1.0];
        for scale in [1e-4, 1.0, 1e4] {
            let look = [scale, 0.0, 0.0];
            let camera = Camera::look_at([0.0; 3], look, up, 0.8, [64, 48]).unwrap();
            let placement = Placement::of(&[camera], &[look, look, [0.0, scale, 0.0]]);
            let place = DVec3::from(placement.own(look)) - DVec3::from(placement.own([0.0; 3]));
            assert!((place.length() - DISTANCE).abs() < 1e-9, "{scale}: {placement:?}");
        }
    }
}
