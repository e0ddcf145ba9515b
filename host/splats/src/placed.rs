//! Gaussians in other coordinates: files have those of the world, scenes their own.

use std::path::Path;

use glam::{DMat3, DQuat, DVec3, Vec3};
use organza_core::error::Result;
use organza_core::scene::Placement;

use super::harmonics::{HARMONICS, harmonics, solve};
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

/// Number of directions that determine how harmonics turn: a few for each of them.
const DIRECTIONS: usize = 64;

/// Turns Gaussians, and makes them larger. `turn` is orthogonal, and may mirror. `place` moves their centers.
pub fn turn(splats: &mut [Splat], turn: DMat3, scale: f64, place: impl Fn([f64; 3]) -> [f64; 3]) {
    // a Gaussian is symmetric, so a mirror and its opposite, which is a rotation, leave the same shape
    let by = DQuat::from_mat3(&(turn * turn.determinant().signum()));
    let larger = scale.ln() as f32;
    let harmonics = (turn != DMat3::IDENTITY).then(|| turned_harmonics(turn));
    for splat in splats {
        splat.position = place(splat.position.map(f64::from)).map(|x| x as f32);
        splat.log_scale = splat.log_scale.map(|log| log + larger);
        let Some(harmonics) = &harmonics else { continue };
        let [w, x, y, z] = splat.rotation.map(f64::from);
        let [x, y, z, w] = (by * DQuat::from_xyzw(x, y, z, w)).to_array();
        splat.rotation = [w, x, y, z].map(|part| part as f32);
        let color = splat.color;
        splat.color = std::array::from_fn(|row| {
            std::array::from_fn(|channel| {
                let terms = harmonics[row].iter().zip(&color);
                terms.map(|(part, color)| part * f64::from(color[channel])).sum::<f64>() as f32
            })
        });
    }
}

/// The matrix that turns coefficients of harmonics. Turned harmonics are sums of harmonics, so least squares find them
/// exactly.
fn turned_harmonics(turn: DMat3) -> [[f64; HARMONICS]; HARMONICS] {
    let back = turn.transpose();
    let mut matrix = [[0.0; HARMONICS]; HARMONICS];
    let mut right = [[0.0; HARMONICS]; HARMONICS];
    for index in 0..DIRECTIONS {
        // even over the sphere: a golden spiral
        let z = 1.0 - (2 * index + 1) as f64 / DIRECTIONS as f64;
        let (sin, cos) = (2.399_963_2 * index as f64).sin_cos();
        let across = (1.0 - z * z).sqrt();
        let direction = DVec3::new(across * cos, across * sin, z);
        let of =
            |direction: DVec3| harmonics(Vec3::ZERO, direction.as_vec3().to_array()).map(f64::from);
        let after = of(direction);
        let before = of(back * direction);
        for i in 0..HARMONICS {
            for j in 0..HARMONICS {
                matrix[i][j] += after[i] * after[j];
                right[i][j] += after[i] * before[j];
            }
        }
    }
    solve(matrix, right)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::harmonics::color_of;
    use crate::{Views, bounds, render};
    use glam::DMat3;

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

    /// The covariance, and the color in a direction, as the definitions say.
    fn shape(splat: &Splat) -> DMat3 {
        let [w, x, y, z] = splat.rotation.map(f64::from);
        let rotation = DMat3::from_quat(DQuat::from_xyzw(x, y, z, w).normalize());
        let scale = DVec3::from(splat.log_scale.map(|log| f64::from(log).exp()));
        rotation * DMat3::from_diagonal(scale * scale) * rotation.transpose()
    }

    #[test]
    fn shapes_and_colors_turn_with_the_space_and_in_a_mirror() {
        let value = |k: usize| ((k * 61) % 97) as f32 / 97.0 - 0.5;
        let splat = Splat {
            position: [1.0, -2.0, 0.5],
            rotation: [0.3, -0.7, 0.2, 0.5],
            log_scale: [-1.0, 0.2, -2.5],
            opacity: 0.3,
            color: std::array::from_fn(|h| std::array::from_fn(|channel| value(3 * h + channel))),
        };
        let mirror = DMat3::from_diagonal(DVec3::new(1.0, -1.0, 1.0));
        let rotation = DMat3::from_rotation_x(0.8) * DMat3::from_rotation_z(-1.9);
        for by in [mirror, rotation, mirror * rotation] {
            let mut turned = [splat];
            turn(&mut turned, by, 2.0, |place| (2.0 * (by * DVec3::from(place))).to_array());
            let [turned] = turned;
            let expected = by * shape(&splat) * by.transpose() * 4.0;
            assert!(
                shape(&turned).abs_diff_eq(expected, 1e-5),
                "{:?} {expected:?}",
                shape(&turned)
            );
            for direction in [[0.0, 0.0, 1.0], [0.6, 0.0, -0.8], [-0.48, 0.64, 0.6]] {
                let color = |splat: &Splat, direction: DVec3| {
                    let basis = harmonics(Vec3::ZERO, direction.as_vec3().to_array());
                    Vec3::from(color_of(&splat.color, &basis))
                };
                let direction = DVec3::from(direction);
                let seen = color(&turned, by * direction);
                assert!(seen.distance(color(&splat, direction)) < 1e-5, "{seen} {direction}");
            }
        }
    }
}
