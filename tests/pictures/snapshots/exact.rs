//! The equations in f64. A snapshot locks a value, and these show that it was right when it was locked.

use organza::scene::Network;
use organza::{Camera, Scene, Stages, TileBatch};
use organza_parity::exact::composite::{self, Splat};
use organza_parity::exact::dense::{affine, relu};
use organza_parity::exact::hash_grid::encode;
use organza_parity::exact::numeric::{Number, dot};
use organza_parity::exact::project::{self, Gaussian, Projected, View};
use organza_parity::exact::transmittance::{log_rho, midpoint, transmittance as product};
use organza_parity::exact::unit_cube::unit;
use organza_parity::exact::{resolve, segment, spherical_harmonics};

fn wide<const N: usize>(values: [f32; N]) -> [f64; N] {
    values.map(f64::from)
}

/// The harmonics of the direction in which a camera sees a Gaussian.
pub fn harmonics(scene: &Scene, camera: &Camera, gaussian: usize) -> Vec<f64> {
    let position = wide(scene.gaussians.position[gaussian]);
    let direction = spherical_harmonics::direction(camera.eye(), position);
    let count = (scene.config.sh_degree as usize + 1).pow(2);
    (0..count).map(|at| spherical_harmonics::harmonic(at, direction)).collect()
}

/// A Gaussian's features in the color grid.
pub fn color_features(scene: &Scene, gaussian: usize) -> Vec<f64> {
    let point = unit(wide(scene.gaussians.position[gaussian]), scene.config.aabb, false);
    encode(&scene.config.color_grid, &scene.color.grid, point)
}

/// A whole network: ReLU after every layer but the last.
fn network(network: &Network, mut values: Vec<f64>) -> Vec<f64> {
    let wide = |row: &[f32]| row.iter().copied().map(f64::from).collect::<Vec<_>>();
    for (index, layer) in network.layers.iter().enumerate() {
        let rows = layer.weight.chunks_exact(layer.inputs).zip(&layer.bias);
        let is_hidden = index + 1 < network.layers.len();
        values = rows
            .map(|(row, &bias)| affine(&wide(row), f64::from(bias), &values))
            .map(|x| if is_hidden { relu(x) } else { x })
            .collect();
    }
    values
}

/// Eq. 1-3, from the harmonics and features of the stages.
pub fn color(scene: &Scene, sh: &[f32], features: &[f32], gaussian: usize) -> Vec<f64> {
    let width = scene.config.material as usize;
    let material = &scene.gaussians.material[gaussian * width..][..width];
    let input = [sh, features, material].concat().into_iter().map(f64::from).collect();
    network(&scene.color.network, input).into_iter().map(Number::sigmoid).collect()
}

/// Eq. 4-11: K and T.
pub fn transmittance(scene: &Scene, camera: &Camera, gaussian: usize) -> (u32, f64) {
    let config = &scene.config;
    let p = wide(scene.gaussians.position[gaussian]);
    let eye = camera.eye();
    let [p, eye] = [p, eye].map(|point| unit(point, config.aabb, false));
    let segment = segment::segment(p, eye, config.step);
    let steps = dot(segment.way, segment.way).sqrt() / config.step;
    if steps == 0.0 {
        return (0, 1.0);
    }
    assert!((steps - steps.round()).abs() > 1e-4, "rounding would decide on K: {steps} steps");
    let width = config.extra as usize;
    let extra = &scene.gaussians.extra[gaussian * width..][..width];
    let count = segment.count as u32;
    let log_rho = (0..count).map(|k| {
        let x = midpoint(segment.start, segment.way, k, count);
        let mut input = encode(&config.transmittance_grid, &scene.transmittance.grid, x);
        input.extend(extra.iter().map(|&u| f64::from(u)));
        log_rho(network(&scene.transmittance.network, input)[0], segment.factor)
    });
    (count, product(log_rho.sum::<f64>()))
}

/// A camera, for the equations.
pub fn view(camera: &Camera) -> View<f64> {
    View {
        axes: camera.axes().map(|axis| axis.to_array()),
        eye: camera.eye(),
        focal: [camera.fl_x, camera.fl_y],
        center: [camera.cx, camera.cy],
        size: [camera.width, camera.height].map(f64::from),
    }
}

/// A Gaussian, for the equations.
pub fn gaussian(scene: &Scene, gaussian: usize) -> Gaussian<f64> {
    Gaussian {
        position: wide(scene.gaussians.position[gaussian]),
        rotation: wide(scene.gaussians.rotation[gaussian]),
        log_scale: wide(scene.gaussians.log_scale[gaussian]),
    }
}

/// Projects a Gaussian with EWA; `None` if it is culled.
pub fn project(scene: &Scene, camera: &Camera, index: usize) -> Option<Projected<f64>> {
    project::project(&view(camera), scene.config.blur, &gaussian(scene, index))
}

/// Numbers of pixels by their branch of Eq. 13.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Branches {
    /// Pixels with S > 1.
    pub divided: usize,
    /// Pixels with 0 < S <= 1.
    pub mixed: usize,
    /// Pixels with S = 0, which show the background.
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
