//! Eq. 4 to 8 and the projection.

use glam::{DMat2, DMat3, DVec2, DVec3};
use organza::parity::lens::ExactLens;
use organza::parity::project::Project;
use organza::parity::segment::Segment;

use super::hold::hold;

/// Rotation matrix of a quaternion w, x, y, z.
fn rotation(q: [f64; 4]) -> DMat3 {
    let length = q.map(|c| c * c).iter().sum::<f64>().sqrt();
    let [w, x, y, z] = q.map(|c| c / length);
    let rows = [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
        [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
        [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
    ];
    DMat3::from_cols_array_2d(&rows).transpose()
}

/// Mean and covariance in the image, as matrices; none behind the near plane.
fn projected(set: &Project, camera: usize, gaussian: usize) -> Option<(DVec2, DMat2)> {
    let camera = &set.cameras[camera];
    let view = DMat3::from_cols_array_2d(&camera.rotation.map(|r| r.as_dvec3().to_array()));
    let view = view.transpose();
    let t = view * (set.center(gaussian) - camera.eye.as_dvec3());
    if ExactLens::above_near(t) <= 0.0 {
        return None;
    }
    let lens = ExactLens::of(camera);
    let jacobian = lens.jacobian(t, t);
    let axes = DMat3::from_diagonal((set.log_axes(gaussian) * 2.0).exp());
    let turn = rotation(set.quaternion(gaussian).to_array());
    let sigma = view * turn * axes * turn.transpose() * view.transpose();
    let entry = |i: usize, j: usize| jacobian[i].dot(sigma * jacobian[j]);
    let blur = f64::from(set.blur);
    let covariance =
        DMat2::from_cols_array(&[entry(0, 0) + blur, entry(0, 1), entry(1, 0), entry(1, 1) + blur]);
    Some((lens.pixel(t), covariance))
}

#[test]
fn projections_are_inverted_covariances() {
    hold::<Project>(|set, output, index| {
        let width = match output {
            "mean2d" | "extent" => 2,
            "conic" => 3,
            "radius" | "class" => 1,
            _ => return None,
        };
        let gaussians = set.gaussians as usize;
        let (slot, part) = (index / width, index % width);
        if slot >= gaussians * set.cameras.len() {
            return None;
        }
        let Some((mean, covariance)) = projected(set, slot / gaussians, slot % gaussians) else {
            return Some(if output == "class" { 1.0 } else { 0.0 });
        };
        let [a, b, _, c] = covariance.to_cols_array();
        let determinant = a * c - b * b;
        // what overflows in f32 is culled; what cancels in f64 cannot be told from here
        let is_told = determinant > 1e-7 * a * c && a.max(c) < 1e15;
        if !is_told {
            return None;
        }
        let largest = (a + c) / 2.0 + ((a - c).powi(2) / 4.0 + b * b).sqrt();
        Some(match output {
            "class" => 0.0,
            "mean2d" => mean[part],
            "radius" => (2.0 * 255f64.ln() * largest).sqrt(),
            // half the bounding box of q <= 2 ln 255, and its margin
            "extent" => (2.0 * 255f64.ln() * [a, c][part]).sqrt() * 1.001 + 0.01,
            _ => [c, -b, a][part] / determinant,
        })
    });
}

/// Eq. 4 to 6: t0 and lambda.
fn clip(p: DVec3, v: DVec3) -> (f64, f64) {
    let (mut enter, mut exit) = (f64::NEG_INFINITY, f64::INFINITY);
    for axis in 0..3 {
        if v[axis] == 0.0 {
            if !(0.0..=1.0).contains(&p[axis]) {
                (enter, exit) = (f64::INFINITY, f64::NEG_INFINITY);
            }
            continue;
        }
        let (zero, one) = ((0.0 - p[axis]) / v[axis], (1.0 - p[axis]) / v[axis]);
        enter = enter.max(zero.min(one));
        exit = exit.min(zero.max(one));
    }
    let t0 = enter.clamp(0.0, 1.0);
    (t0, (exit.clamp(0.0, 1.0) - t0).max(0.0))
}

#[test]
fn segments_are_clipped_and_cut_into_steps() {
    hold::<Segment>(|set, output, index| {
        let width = if output == "count" { 1 } else { 8 };
        let slot = *set.pair.get(index / width)?;
        let unit = |x: DVec3| {
            let [low, high] = set.aabb.map(DVec3::from_array);
            0.05 + 0.9 * (x - low) / (high - low)
        };
        let gaussian = (slot % set.gaussians) as usize;
        let position = [0, 1, 2].map(|axis| f64::from(set.position[3 * gaussian + axis]));
        let p = unit(DVec3::from_array(position));
        let eye = unit(set.cameras[(slot / set.gaussians) as usize].eye.as_dvec3());
        let v = eye - p;
        let (t0, lambda) = clip(p, v);
        let (s, w, sigma) = (p + t0 * v, lambda * v, f64::from(set.step));
        let steps = (w.length() / sigma).ceil().min(16_384.0);
        Some(match index % width {
            0 if output == "count" => steps,
            part @ 0..3 => s[part],
            3 if steps > 0.0 => w.length() / steps / sigma,
            part @ 4..7 => w[part - 4],
            _ => 0.0,
        })
    });
}
