//! Gaussians in other axes.

use glam::{DMat3, DQuat, DVec3, Vec3};

use super::Splat;
use super::harmonics::{HARMONICS, harmonics, solve};

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
