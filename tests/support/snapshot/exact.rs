//! What the equations say, in f64: a snapshot locks a value, these show that it was right when it was locked.

use glam::{DVec2, DVec3};
use organza::parity::lens::ExactLens;
use organza::scene::{GridConfig, Interpolation, Network};
use organza::{Camera, Scene, Stages, TileBatch};

/// `2 ln 255`, where the falloff ends.
fn cutoff() -> f64 {
    2.0 * 255f64.ln()
}

fn sigmoid(x: f64) -> f64 {
    1.0 / (1.0 + (-x).exp())
}

fn wide<const N: usize>(values: [f32; N]) -> [f64; N] {
    values.map(f64::from)
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The unit direction from the camera to a Gaussian.
pub fn direction(scene: &Scene, camera: &Camera, gaussian: usize) -> [f64; 3] {
    let (position, eye) = (wide(scene.gaussians.position[gaussian]), camera.eye());
    let v: [f64; 3] = std::array::from_fn(|axis| position[axis] - eye[axis]);
    v.map(|value| value / dot(v, v).sqrt())
}

/// The features of a point of the unit cube.
pub fn encode(config: &GridConfig, table: &[f32], point: [f64; 3]) -> Vec<f64> {
    let features = config.features as usize;
    let mut encoded = Vec::new();
    for level in config.levels_geometry() {
        let place = point.map(|x| x.clamp(0.0, 1.0) * level.scale + 0.5);
        let weight = place.map(|x| x - x.floor()).map(|t| match config.interpolation {
            Interpolation::Linear => t,
            Interpolation::Smoothstep => t * t * (3.0 - 2.0 * t),
        });
        let mut sums = vec![0.0; features];
        for corner in 0..8_usize {
            let upper = [0, 1, 2].map(|axis| corner >> axis & 1);
            let [x, y, z] = [0, 1, 2].map(|axis| place[axis] as u32 + upper[axis] as u32);
            let index = if level.hashed {
                x ^ y.wrapping_mul(2_654_435_761) ^ z.wrapping_mul(805_459_861)
            } else {
                x + y * level.resolution + z * level.resolution * level.resolution
            };
            let entry = (level.first + index % level.count) as usize;
            let share: f64 = (0..3)
                .map(|axis| if upper[axis] == 1 { weight[axis] } else { 1.0 - weight[axis] })
                .product();
            for (sum, &value) in sums.iter_mut().zip(&table[entry * features..]) {
                *sum += share * f64::from(value);
            }
        }
        encoded.extend(sums);
    }
    encoded
}

/// Eq. 2 and 10.
fn network(network: &Network, mut values: Vec<f64>) -> Vec<f64> {
    for (index, layer) in network.layers.iter().enumerate() {
        let rows = layer.weight.chunks_exact(layer.inputs).zip(&layer.bias);
        let linear = rows.map(|(row, &bias)| {
            f64::from(bias) + row.iter().zip(&values).map(|(&w, x)| f64::from(w) * x).sum::<f64>()
        });
        let hidden = index + 1 < network.layers.len();
        values = linear.map(|x| if hidden { x.max(0.0) } else { x }).collect();
    }
    values
}

/// Eq. 1-3, from the harmonics and features of the stages.
pub fn color(scene: &Scene, sh: &[f32], features: &[f32], gaussian: usize) -> Vec<f64> {
    let width = scene.config.material as usize;
    let material = &scene.gaussians.material[gaussian * width..][..width];
    let input = [sh, features, material].concat().into_iter().map(f64::from).collect();
    network(&scene.color.network, input).into_iter().map(sigmoid).collect()
}

/// Eq. 4-11: K and T.
pub fn transmittance(scene: &Scene, camera: &Camera, gaussian: usize) -> (u32, f64) {
    let config = &scene.config;
    let p = config.normalize(wide(scene.gaussians.position[gaussian]));
    let eye = config.normalize(camera.eye());
    let v: [f64; 3] = std::array::from_fn(|axis| eye[axis] - p[axis]);
    let (mut enter, mut exit) = (0.0_f64, 1.0_f64);
    for axis in 0..3 {
        if v[axis] == 0.0 {
            if !(0.0..=1.0).contains(&p[axis]) {
                return (0, 1.0);
            }
            continue;
        }
        let (a, b) = (-p[axis] / v[axis], (1.0 - p[axis]) / v[axis]);
        (enter, exit) = (enter.max(a.min(b)), exit.min(a.max(b)));
    }
    let lambda = exit - enter;
    let length = lambda * dot(v, v).sqrt();
    if lambda <= 0.0 || length == 0.0 {
        return (0, 1.0);
    }
    let steps = length / config.step;
    assert!((steps - steps.round()).abs() > 1e-4, "rounding would decide on K: {steps} steps");
    let count = steps.ceil().max(1.0);
    let width = config.extra as usize;
    let extra = &scene.gaussians.extra[gaussian * width..][..width];
    let sum: f64 = (0..count as u32)
        .map(|k| {
            let t = enter + lambda * (f64::from(k) + 0.5) / count;
            let x = std::array::from_fn(|axis| p[axis] + t * v[axis]);
            let mut input = encode(&config.transmittance_grid, &scene.transmittance.grid, x);
            input.extend(extra.iter().map(|&u| f64::from(u)));
            let a = network(&scene.transmittance.network, input)[0];
            -(-a).exp().ln_1p()
        })
        .sum();
    (count as u32, (sum * steps / count).exp())
}

/// A projected Gaussian.
#[derive(Clone, Copy, Debug)]
pub struct Projected {
    /// In pixels.
    pub mean: [f64; 2],
    /// xx, xy, yy of the inverse covariance.
    pub conic: [f64; 3],
    /// Of the support, in pixels.
    pub radius: f64,
}

/// EWA, as `conventions.md` has it; nothing where the Gaussian is culled.
pub fn project(scene: &Scene, camera: &Camera, gaussian: usize) -> Option<Projected> {
    let axes = camera.world_to_camera_opencv();
    let (position, eye) = (wide(scene.gaussians.position[gaussian]), camera.eye());
    let offset = std::array::from_fn(|axis| position[axis] - eye[axis]);
    let t = DVec3::from_array(axes.map(|axis| dot(axis, offset)));
    if ExactLens::above_near(t) <= 0.0 {
        return None;
    }
    let lens = ExactLens {
        focal: DVec2::new(camera.fl_x, camera.fl_y),
        center: DVec2::new(camera.cx, camera.cy),
        size: DVec2::new(camera.width.into(), camera.height.into()),
    };
    let scaled = scaled_axes(scene, gaussian);
    // a row of J W R S for each axis of the image
    let rows = lens.jacobian(t, t).map(|j| {
        let row = std::array::from_fn(|k| j.x * axes[0][k] + j.y * axes[1][k] + j.z * axes[2][k]);
        scaled.map(|axis| dot(row, axis))
    });
    let blur = scene.config.blur;
    let (xx, xy, yy) =
        (dot(rows[0], rows[0]) + blur, dot(rows[0], rows[1]), dot(rows[1], rows[1]) + blur);
    let determinant = xx * yy - xy * xy;
    let largest = 0.5 * (xx + yy) + (0.25 * (xx - yy).powi(2) + xy * xy).sqrt();
    Some(Projected {
        mean: lens.pixel(t).to_array(),
        conic: [yy, -xy, xx].map(|value| value / determinant),
        radius: (cutoff() * largest).sqrt(),
    })
}

/// A Gaussian's axes in the world, as long as its scales.
fn scaled_axes(scene: &Scene, gaussian: usize) -> [[f64; 3]; 3] {
    let q = wide(scene.gaussians.rotation[gaussian]);
    let norm = q.iter().map(|value| value * value).sum::<f64>().sqrt();
    let [w, x, y, z] = q.map(|value| value / norm);
    let columns = [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + w * z), 2.0 * (x * z - w * y)],
        [2.0 * (x * y - w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + w * x)],
        [2.0 * (x * z + w * y), 2.0 * (y * z - w * x), 1.0 - 2.0 * (x * x + y * y)],
    ];
    let scale = wide(scene.gaussians.log_scale[gaussian]).map(f64::exp);
    std::array::from_fn(|i| columns[i].map(|value| value * scale[i]))
}

/// Pixels of tiles by the branch of Eq. 13 that they took.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Branches {
    /// S > 1
    pub divided: usize,
    /// 0 < S <= 1
    pub mixed: usize,
    /// S = 0: background.
    pub empty: usize,
}

/// Eq. 12 and 13 for every pixel of every tile, from the stages of each camera: `[K, 3, S, S]`.
pub fn composite(scene: &Scene, stages: &[Stages], batch: &TileBatch) -> (Vec<f64>, Branches) {
    let side = batch.side as usize;
    let mut image = vec![0.0; batch.tiles.len() * 3 * side * side];
    let mut branches = Branches::default();
    for (index, tile) in batch.tiles.iter().enumerate() {
        for at in 0..side * side {
            let place = [at % side, at / side];
            let pixel =
                std::array::from_fn(|axis| f64::from(tile.origin[axis]) + place[axis] as f64 + 0.5);
            let (c, s) = weighted_sum(scene, &stages[tile.camera], pixel);
            let count = match s {
                0.0 => &mut branches.empty,
                ..=1.0 => &mut branches.mixed,
                _ => &mut branches.divided,
            };
            *count += 1;
            for (channel, c) in c.into_iter().enumerate() {
                let background = scene.config.background[channel];
                image[(index * 3 + channel) * side * side + at] =
                    if s > 1.0 { c / s } else { c + (1.0 - s) * background };
            }
        }
    }
    (image, branches)
}

/// Eq. 12: C and S of a pixel.
fn weighted_sum(scene: &Scene, stages: &Stages, pixel: [f64; 2]) -> ([f64; 3], f64) {
    let (mut c, mut s) = ([0.0; 3], 0.0);
    for gaussian in (0..stages.radius.len()).filter(|&i| stages.radius[i] >= 0.0) {
        let (mean, [xx, xy, yy]) = (wide(stages.mean2d[gaussian]), wide(stages.conic[gaussian]));
        let [dx, dy] = [pixel[0] - mean[0], pixel[1] - mean[1]];
        let q = xx * dx * dx + 2.0 * xy * dx * dy + yy * dy * dy;
        assert!(
            (q - cutoff()).abs() > 2e-5,
            "Gaussian {gaussian} ends at {pixel:?}: rounding shows"
        );
        if q <= cutoff() {
            let opacity = sigmoid(f64::from(scene.gaussians.opacity[gaussian]));
            let alpha = opacity * f64::from(stages.transmittance[gaussian]) * (-0.5 * q).exp();
            for (channel, c) in c.iter_mut().enumerate() {
                *c += alpha * f64::from(stages.color[3 * gaussian + channel]);
            }
            s += alpha;
        }
    }
    (c, s)
}
