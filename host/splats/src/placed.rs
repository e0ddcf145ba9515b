//! Gaussians in other coordinates: files have the world's, scenes their own.

use std::path::Path;

use glam::{DMat3, DQuat, DVec3, Vec3};
use organza_core::error::Result;
use organza_core::scene::Placement;

use super::harmonics::{HARMONICS, harmonics, solve};
use super::{Format, Splat, save};

/// Offsets beyond this many units of a scene leave too few digits of an f32 to positions. What is farther is not seen.
pub const FARTHEST: f64 = 1e4;

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
    let (in_file, stored) = in_file(placement);
    let mut file = splats.to_vec();
    if !in_file.is_identity() {
        turn(&mut file, in_file.rotation(), in_file.scale, |place| in_file.world(place));
    }
    let written = save(&file, path, format, placement.world_direction(up), &stored)?;
    Ok((written.into_own(placement)?, left_out(placement, &in_file)))
}

/// The offset of a scene that a file leaves out, in the file's unit.
pub(crate) fn left_out(placement: &Placement, in_file: &Placement) -> Option<[f64; 3]> {
    let offset = placement.in_meters().offset;
    (in_file.offset != offset).then_some(offset)
}

/// The place of a scene in the space of a file, and of the file in the world. The file's unit is the meter if it is known. The file
/// leaves out an offset that is many times as large as the scene: positions could not hold it.
pub(crate) fn in_file(placement: &Placement) -> (Placement, Placement) {
    let mut in_file = placement.in_meters();
    let scale = 1.0 / placement.meters.unwrap_or(1.0);
    let mut stored = Placement { scale, ..Placement::default() };
    if DVec3::from(placement.offset).length() > FARTHEST * placement.scale {
        in_file.offset = [0.0; 3];
        stored.offset = placement.offset;
    }
    (in_file, stored)
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
    use crate::files::tests::splats;
    use crate::harmonics::color_of;
    use crate::{SplatFile, Views, bounds, load, render};
    use glam::DMat3;

    /// The same in the world.
    fn moved(placement: &Placement) -> Vec<Splat> {
        let mut world = splats();
        turn(&mut world, placement.rotation(), placement.scale, |place| placement.world(place));
        world
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
        let world = moved(&placement);
        let back = SplatFile::new(Path::new(""), "", world.clone()).into_own(&placement).unwrap();
        let views = Views::around(bounds(&own)).unwrap();
        for camera in views.fitted.iter().step_by(9).map(|camera| camera.within(64)) {
            let expected = render(&own, &camera, [0.2; 3], false);
            for (splats, camera) in
                [(&world, placement.world_camera(&camera)), (&back, camera.clone())]
            {
                let found = render(splats, &camera, [0.2; 3], false);
                let pairs = found.as_flattened().iter().zip(expected.as_flattened());
                let largest = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
                assert!(largest < 2e-3, "{largest}");
            }
        }
    }

    /// A file says what it leaves out, and its unit.
    #[test]
    fn scenes_come_back_from_anywhere_in_any_unit() {
        let folder = tempfile::tempdir().unwrap();
        let far = Placement { offset: [5e5, 4.6e6, 300.0], scale: 2.0, ..Placement::default() };
        let turned = Placement { up: [0.0, -1.0, 0.0], right: [0.0, 0.0, 1.0], ..far };
        let small = Placement { meters: Some(0.02), offset: [3.0, -4.0, 5.0], ..turned };
        for placement in [far, turned, small, Placement { meters: Some(0.3), ..turned }] {
            let is_far = placement.offset[0] > 1e5;
            for (name, format) in [
                ("a.ply", Format::Ply),
                ("a.spz", Format::Spz),
                ("a.sog", Format::Sog),
                ("a.glb", Format::Glb),
            ] {
                let path = folder.path().join(name);
                let up = [0.0, 0.0, 1.0];
                let (written, offset) =
                    save_scene(&splats(), &path, format, up, &placement).unwrap();
                assert_eq!(offset, is_far.then(|| placement.in_meters().offset));
                let file = load(&path).unwrap();
                assert!(file.is_placed);
                if let ("a.ply", Some(offset)) = (name, offset) {
                    let first = file.splats[0].position.map(f64::from);
                    let world = placement.in_meters().world(splats()[0].position.map(f64::from));
                    let apart = DVec3::from(first) + DVec3::from(offset) - DVec3::from(world);
                    assert!(apart.length() < 1e-5, "{apart}");
                }
                let found = file.into_own(&placement).unwrap();
                assert_eq!(found, written);
                let near = |a: &Splat| {
                    let apart = |b: &Splat| {
                        let places = [a, b].map(|splat| Vec3::from(splat.position));
                        let scales = [a, b].map(|splat| Vec3::from(splat.log_scale));
                        places[0].distance(places[1]) + 0.01 * scales[0].distance(scales[1])
                    };
                    splats().iter().map(apart).fold(f32::INFINITY, f32::min)
                };
                let largest = found.iter().map(near).fold(0.0, f32::max);
                assert!(largest < 6e-3, "{name}: {largest}");
            }
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
