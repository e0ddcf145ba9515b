//! The gradient of the distortion beside differences of it.

use super::{all_devices, every, tiles};
use crate::loss::terms::powers;
use crate::pass::part::Part;
use crate::stages::composite::weighted_sum;
use crate::stages::cut::{PART_BYTES, PartTiles};
use crate::{CompositedTerm, LossTarget, Renderer, SceneGradient, TileImages};
use organza_core::{Scene, demo};

/// Step of the central differences.
const STEP: f32 = 1e-2;
/// The weight of the distortion in the loss.
const WEIGHT: f32 = 3.0;
const AREA: usize = 16 * 16;

/// Of four tiles.
fn valid() -> Vec<f32> {
    (0..4 * AREA).map(|at| f32::from(at % 11 > 0)).collect()
}

/// `min(S, 1)^2 (S M_2 / M_1^2 - 1)` of all valid pixels, as a mean times the weight.
fn distortion(renderer: &Renderer, scene: &Scene) -> f64 {
    let device = renderer.device();
    let scene = renderer.upload(scene).expect("a scene");
    let parts = PartTiles::split(&scene, &tiles(), PART_BYTES).expect("parts");
    let [part_tiles] = &parts[..] else { panic!("one part") };
    let cameras = demo::turntable(2, 64);
    let part = Part::evaluate(&scene, &cameras, part_tiles, false, None).expect("a part");
    let context = part.context(&scene);
    let powers = powers(context).expect("values of pairs");
    let (sum, _) = weighted_sum(context, &powers).expect("sums");
    let sum: Vec<f32> = device.read(&sum).expect("numbers");
    let valid = valid();
    let mut total = 0.0;
    for (tile, part_tile) in sum.chunks(4 * AREA).zip(&part_tiles.tiles) {
        for at in 0..AREA {
            let [m1, m2, s] = [0, 1, 3].map(|plane| f64::from(tile[plane * AREA + at]));
            if m1 > 0.0 {
                let spread = s * m2 / (m1 * m1) - 1.0;
                total +=
                    f64::from(valid[part_tile.place * AREA + at]) * s.min(1.0).powi(2) * spread;
            }
        }
    }
    f64::from(WEIGHT) * total / valid.iter().copied().map(f64::from).sum::<f64>()
}

/// The gradients of opacities `[N]`, of log scales `[N, 3]` and of the transmittance network's last bias.
fn gradients(renderer: &Renderer, scene: &Scene, weight: f32) -> [Vec<f32>; 3] {
    let image = vec![0.3; 3 * 4 * AREA];
    let valid = valid();
    let target = LossTarget {
        photographs: &TileImages { image: &image, valid: &valid, side: 16 },
        valid_pixels: valid.iter().copied().map(f64::from).sum(),
        ssim_weight: 0.0,
        terms: &[CompositedTerm::distortion(weight)],
        exposure: None,
    };
    let device = renderer.device();
    let on_device = renderer.upload(scene).expect("a scene");
    let gradient = SceneGradient::new(device, &on_device).expect("memory");
    let cameras = demo::turntable(2, 64);
    renderer
        .add_loss_gradient(&on_device, &cameras, &tiles(), &target, None, &gradient, None)
        .expect("a loss");
    let found = gradient.download(device, &scene.config, scene.gaussians.len()).expect("numbers");
    let tensors = found.tensors();
    let layers = scene.transmittance.network.layers.len();
    let bias = format!("transmittance.mlp.{}.bias", layers - 1);
    let of = |name: &str| {
        let (_, values) = tensors.iter().find(|(spec, _)| spec.name == name).expect("a tensor");
        values.to_vec()
    };
    ["gaussians.opacity", "gaussians.log_scale", &bias].map(of)
}

/// The terms that the distortion adds to the gradients.
fn added(renderer: &Renderer, scene: &Scene) -> [Vec<f64>; 3] {
    let with = gradients(renderer, scene, WEIGHT);
    let without = gradients(renderer, scene, 0.0);
    let differences = |[with, without]: [Vec<f32>; 2]| {
        with.iter().zip(&without).map(|(a, b)| f64::from(a - b)).collect()
    };
    let [[a, b, c], [d, e, f]] = [with, without];
    [[a, d], [b, e], [c, f]].map(differences)
}

/// The places of the largest values.
fn largest(values: &[f64], count: usize) -> Vec<usize> {
    let mut places: Vec<_> = (0..values.len()).collect();
    places.sort_by(|&a, &b| values[b].abs().total_cmp(&values[a].abs()));
    places.truncate(count);
    places
}

#[test]
fn the_gradient_follows_differences_with_distances_held_constant() {
    let scene = every(24);
    for device in all_devices() {
        let renderer = Renderer::new(device);
        let [opacity, log_scale, bias] = added(&renderer, &scene);
        let slope = |change: &dyn Fn(&mut Scene, f32)| {
            let at = |step: f32| {
                let mut scene = scene.clone();
                change(&mut scene, step);
                distortion(&renderer, &scene)
            };
            (at(STEP) - at(-STEP)) / f64::from(2.0 * STEP)
        };
        let close = |found: f64, expected: f64, largest: f64, what: &str| {
            let error = (found - expected).abs();
            assert!(error < 1e-2 * largest.abs(), "{what}: {found} and {expected}");
        };
        let largest = largest(&opacity, 4);
        for &at in &largest {
            let expected = slope(&|scene, step| scene.gaussians.opacity[at] += step);
            close(opacity[at], expected, opacity[largest[0]], &format!("opacity {at}"));
        }
        // one of them hardly changes anything: all at once, each in its own direction
        let expected = slope(&|scene, step| {
            let values = scene.gaussians.log_scale.iter_mut().flatten();
            values.zip(&log_scale).for_each(|(value, g)| *value += step * g.signum() as f32);
        });
        let found: f64 = log_scale.iter().map(|g| g.abs()).sum();
        // falloffs end with a jump of 1/255, which no derivative has
        assert!((found / expected - 1.0).abs() < 0.06, "log scales: {found} and {expected}");
        let expected = slope(&|scene, step| {
            scene.transmittance.network.layers.last_mut().expect("a head").bias[0] += step;
        });
        close(bias[0], expected, expected, "bias");
        assert!(opacity.iter().any(|g| *g > 0.0) && opacity.iter().any(|g| *g < 0.0));
    }
}

#[test]
fn the_gradient_is_the_same_in_one_part_for_each_tile() {
    let scene = every(24);
    let of = |bytes| {
        let renderer = Renderer::new(muslin_check::devices::cpu(Some(2)));
        gradients(&renderer.with_part_bytes(bytes), &scene, WEIGHT)
    };
    for (whole, parts) in of(512 << 20).iter().zip(of(1)) {
        let largest = whole.iter().fold(0.0_f32, |largest, g| largest.max(g.abs()));
        for (at, (a, b)) in whole.iter().zip(parts).enumerate() {
            assert!((a - b).abs() < 1e-5 * largest, "{at}: {a} and {b}");
        }
    }
}
