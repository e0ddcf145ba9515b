//! Gradients of exposures, and through them, beside differences of the loss.

use super::{some, tiles};
use crate::{LossTarget, Renderer, SceneGradient, TileLoss};
use muslin_check::devices;
use organza_core::demo;
use organza_core::scene::Scene;

/// Half the distance of two losses whose difference is taken.
const STEP: f32 = 1e-2;
/// w
const WEIGHT: f32 = 0.5;

/// A gain and an offset for each channel of the four tiles: no color is below 0.3.
fn exposures() -> Vec<f32> {
    let gain = |at: usize| 0.6 + 0.1 * (at % 9) as f32;
    let offset = |at: usize| 0.3 + 0.01 * (at % 5) as f32;
    (0..12).flat_map(|at| [gain(at), offset(at)]).collect()
}

/// The loss of [`tiles`], its gradients with respect to the exposures `[4, 3, 2]`, and to one bias of the color network.
fn evaluate(renderer: &Renderer, scene: &Scene, exposure: &[f32]) -> (f64, Vec<f64>, f64) {
    let pixels = 4 * 16 * 16;
    // darker than what is rendered, so that no difference changes its sign
    let image: Vec<_> = (0..3 * pixels).map(|at| 0.12 + 0.1 * (at as f32 * 0.7).sin()).collect();
    let valid: Vec<_> = (0..pixels).map(|at| f32::from(at % 11 > 0)).collect();
    let target = LossTarget {
        image: &image,
        valid: &valid,
        valid_pixels: valid.iter().copied().map(f64::from).sum(),
        ssim_weight: WEIGHT,
        distortion_weight: 0.0,
        exposure: Some(exposure),
    };
    let device = renderer.device();
    let on_device = renderer.upload(scene).expect("a scene");
    let gradient = SceneGradient::new(device, &on_device).expect("memory");
    let cameras = demo::turntable(2, 64);
    let (losses, exposures) = renderer
        .add_loss_gradient(&on_device, &cameras, &tiles(), &mut None, &target, &gradient, None)
        .expect("a loss");
    let cameras: Vec<_> = exposures.iter().map(|tile| (tile.place, tile.camera)).collect();
    assert_eq!(cameras, [(0, 0), (1, 0), (2, 1), (3, 1)]);
    let found = gradient.download(device, &scene.config, scene.gaussians.len()).expect("numbers");
    let tensors = found.tensors();
    let (_, bias) = tensors.iter().find(|(spec, _)| spec.name == BIAS).expect("a bias");
    let by_exposure = exposures.iter().flat_map(|tile| tile.gradient).flatten().collect();
    (TileLoss::total(&losses).value(WEIGHT), by_exposure, bias[0].into())
}

/// The last bias of the color network's first value.
const BIAS: &str = "color.mlp.2.bias";

/// In one part, and in one for each tile.
#[test]
fn gradients_match_differences() {
    let scene = some();
    let exposure = exposures();
    for bytes in [512 << 20, 1] {
        let renderer = Renderer::new(devices::cpu(Some(2))).with_part_bytes(bytes);
        let (_, found, by_bias) = evaluate(&renderer, &scene, &exposure);
        let slope = |of: &dyn Fn(f32) -> f64| (of(STEP) - of(-STEP)) / f64::from(2.0 * STEP);
        let largest = found.iter().fold(0.0_f64, |most, g| most.max(g.abs()));
        // those of a tile of each camera
        for at in (0..6).chain(12..18) {
            let expected = slope(&|step| {
                let mut exposure = exposure.clone();
                exposure[at] += step;
                evaluate(&renderer, &scene, &exposure).0
            });
            let error = (found[at] - expected).abs();
            assert!(error < 2e-3 * largest, "{at}: {} and {expected}", found[at]);
        }
        let expected = slope(&|step| {
            let mut scene = scene.clone();
            scene.color.network.layers.last_mut().expect("a head").bias[0] += step;
            evaluate(&renderer, &scene, &exposure).0
        });
        assert!((by_bias - expected).abs() < 2e-3 * expected.abs(), "{by_bias} and {expected}");
    }
}
