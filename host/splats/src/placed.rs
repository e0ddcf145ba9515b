//! Gaussians in other coordinates: files have those of the world, scenes their own.

use std::path::Path;

use glam::DVec3;
use organza_core::error::Result;
use organza_core::scene::Placement;

use super::turned::turn;
use super::{Format, Splat, save};

/// Offsets beyond this many units of a scene leave too few digits of an f32 to positions.
const FARTHEST: f64 = 1e4;

/// Moves Gaussians from the world into a scene.
pub fn to_own(splats: &mut [Splat], placement: &Placement) {
    if !placement.is_identity() {
        let place = |place| placement.own(place);
        turn(splats, placement.rotation().transpose(), 1.0 / placement.scale, place);
    }
}

/// Writes the Gaussians of a scene with [`save`]: in the world, and in meters if these are known. `up` is a direction of the
/// scene. Returns the Gaussians as they are in the file, in the scene's coordinates, and the offset that the file leaves out, because its
/// positions could not hold it.
///
/// # Errors
/// The same errors as [`save`].
pub fn save_scene(
    splats: &[Splat],
    path: impl AsRef<Path>,
    format: Format,
    up: [f64; 3],
    placement: &Placement,
) -> Result<(Vec<Splat>, Option<[f64; 3]>)> {
    let placement = placement.in_meters();
    let mut world = splats.to_vec();
    let offset = to_world(&mut world, &placement);
    let mut written = save(&world, path, format, placement.world_direction(up))?;
    to_own(&mut written, &in_file(&placement));
    Ok((written, offset))
}

/// Moves Gaussians from a scene into the world of a file. Returns the offset that is left out.
fn to_world(splats: &mut [Splat], placement: &Placement) -> Option<[f64; 3]> {
    let in_file = in_file(placement);
    if !in_file.is_identity() {
        turn(splats, in_file.rotation(), in_file.scale, |place| in_file.world(place));
    }
    (in_file != *placement).then_some(placement.offset)
}

/// A placement without an offset that is many times as large as the scene: the positions of files could not hold it.
fn in_file(placement: &Placement) -> Placement {
    let is_far = DVec3::from(placement.offset).length() > FARTHEST * placement.scale;
    Placement { offset: if is_far { [0.0; 3] } else { placement.offset }, ..*placement }
}

#[cfg(test)]
mod tests {
    use glam::DMat3;

    use super::*;
    use crate::{Views, bounds, render};

    /// Gaussians of many shapes and colors, whose color depends on the direction.
    fn splats() -> Vec<Splat> {
        let value = |i: usize, k: usize| ((i * 37 + k * 61) % 97) as f32 / 97.0 - 0.5;
        let splat = |i: usize| Splat {
            position: std::array::from_fn(|k| 3.0 * value(i, k)),
            rotation: std::array::from_fn(|k| value(i, 3 + k) + 0.01),
            log_scale: std::array::from_fn(|k| 2.0 * value(i, 7 + k) - 1.5),
            opacity: 4.0 * value(i, 10),
            color: std::array::from_fn(|h| std::array::from_fn(|c| value(i, 11 + 3 * h + c))),
        };
        (0..30).map(splat).collect()
    }

    /// The same cameras, moved alike, show the same image.
    #[test]
    fn gaussians_look_the_same_from_cameras_that_move_along() {
        let axes = DMat3::from_rotation_x(0.7) * DMat3::from_rotation_z(-2.0);
        let placement = Placement {
            offset: [3.0, -20.0, 7.0],
            scale: 12.5,
            up: axes.z_axis.to_array(),
            right: axes.x_axis.to_array(),
            meters: None,
        };
        let own = splats();
        let mut world = own.clone();
        assert_eq!(to_world(&mut world, &placement), None);
        let mut back = world.clone();
        to_own(&mut back, &placement);
        let views = Views::around(bounds(&own)).unwrap();
        for camera in views.fitted.iter().step_by(9).map(|camera| camera.within(64)) {
            let expected = render(&own, &camera, [0.2; 3]);
            for (splats, camera) in
                [(&world, placement.world_camera(&camera)), (&back, camera.clone())]
            {
                let found = render(splats, &camera, [0.2; 3]);
                let pairs = found.as_flattened().iter().zip(expected.as_flattened());
                let most = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
                assert!(most < 2e-3, "{most}");
            }
        }
    }

    #[test]
    fn an_offset_that_positions_cannot_hold_is_left_out() {
        let placement =
            Placement { offset: [5e5, 4.6e6, 300.0], scale: 2.0, ..Placement::default() };
        let mut world = splats();
        assert_eq!(to_world(&mut world, &placement), Some(placement.offset));
        for (found, own) in world.iter().zip(splats()) {
            assert_eq!(found.position, own.position.map(|x| 2.0 * x));
        }
    }
}
