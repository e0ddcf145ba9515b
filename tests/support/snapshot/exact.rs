//! What the equations say, in f64: a snapshot locks a value, these show that it was right when it was locked.

use organza::parity::exact::composite::{self, Splat};
use organza::parity::exact::project::{self, Gaussian, Projected, View};
use organza::parity::exact::{resolve, segment};
use organza::scene::{GridConfig, Interpolation, Network};
use organza::{Camera, Scene, Stages, TileBatch};

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
    let segment = segment::segment(p, eye, config.step);
    let (s, w) = (segment.start, segment.way);
    let steps = dot(w, w).sqrt() / config.step;
    if steps == 0.0 {
        return (0, 1.0);
    }
    assert!((steps - steps.round()).abs() > 1e-4, "rounding would decide on K: {steps} steps");
    let width = config.extra as usize;
    let extra = &scene.gaussians.extra[gaussian * width..][..width];
    let sum: f64 = (0..segment.count as u32)
        .map(|k| {
            let t = (f64::from(k) + 0.5) / segment.count;
            let x = std::array::from_fn(|axis| s[axis] + t * w[axis]);
            let mut input = encode(&config.transmittance_grid, &scene.transmittance.grid, x);
            input.extend(extra.iter().map(|&u| f64::from(u)));
            let a = network(&scene.transmittance.network, input)[0];
            -(-a).exp().ln_1p()
        })
        .sum();
    (segment.count as u32, (sum * segment.factor).exp())
}

/// EWA; nothing where the Gaussian is culled.
pub fn project(scene: &Scene, camera: &Camera, gaussian: usize) -> Option<Projected<f64>> {
    let view = View {
        axes: camera.world_to_camera_opencv(),
        eye: camera.eye(),
        focal: [camera.fl_x, camera.fl_y],
        center: [camera.cx, camera.cy],
        size: [camera.width, camera.height].map(f64::from),
    };
    let gaussian = Gaussian {
        position: wide(scene.gaussians.position[gaussian]),
        rotation: wide(scene.gaussians.rotation[gaussian]),
        log_scale: wide(scene.gaussians.log_scale[gaussian]),
    };
    project::project(&view, scene.config.blur, &gaussian)
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
pub fn tiles(scene: &Scene, stages: &[Stages], batch: &TileBatch) -> (Vec<f64>, Branches) {
    let side = batch.side as usize;
    let mut image = vec![0.0; batch.tiles.len() * 3 * side * side];
    let mut branches = Branches::default();
    for (index, tile) in batch.tiles.iter().enumerate() {
        for at in 0..side * side {
            let place = [at % side, at / side];
            let pixel =
                std::array::from_fn(|axis| f64::from(tile.origin[axis]) + place[axis] as f64 + 0.5);
            let sum = weighted_sum(scene, &stages[tile.camera], pixel);
            let count = match sum[3] {
                0.0 => &mut branches.empty,
                ..=1.0 => &mut branches.mixed,
                _ => &mut branches.divided,
            };
            *count += 1;
            for channel in 0..3 {
                let background = scene.config.background[channel];
                image[(index * 3 + channel) * side * side + at] =
                    resolve::pixel(sum[channel], sum[3], background);
            }
        }
    }
    (image, branches)
}

/// Eq. 12: C and S of a pixel.
fn weighted_sum(scene: &Scene, stages: &Stages, pixel: [f64; 2]) -> [f64; 4] {
    let mut sum = [0.0; 4];
    for gaussian in (0..stages.radius.len()).filter(|&i| stages.radius[i] >= 0.0) {
        let logit = f64::from(scene.gaussians.opacity[gaussian]);
        let splat = Splat {
            mean: wide(stages.mean2d[gaussian]),
            weight: composite::weight(logit, f64::from(stages.transmittance[gaussian])),
            conic: wide(stages.conic[gaussian]),
            color: std::array::from_fn(|channel| f64::from(stages.color[3 * gaussian + channel])),
        };
        assert!(
            (splat.q(pixel) - project::cutoff()).abs() > 2e-5,
            "Gaussian {gaussian} ends at {pixel:?}: rounding shows"
        );
        let term = splat.term(pixel);
        sum.iter_mut().zip(term).for_each(|(sum, term)| *sum += term);
    }
    sum
}
