//! Smaller images, as training sees them, held to the footprint of a Gaussian in closed form.

use crate::Renderer;
use muslin_check::devices;
use organza_core::camera::Camera;
use organza_core::demo;
use organza_core::scene::{Scene, SceneConfig};
use organza_core::tile::TileBatch;

/// The side of the whole image, and how many pixels a unit at the Gaussian's distance has in it.
const SIDE: u32 = 128;
const PIXELS_PER_UNIT: f64 = 32.0;

/// The variance of a lone Gaussian's image along x, in square pixels.
fn variance(standard_deviation: f64, factor: u32) -> f64 {
    let config = SceneConfig { background: [0.0; 3], ..demo::config() };
    let mut scene = Scene::zeros(config, 1).expect("a scene");
    // gray, in empty space
    scene.transmittance.network.layers.last_mut().expect("a layer").bias[0] = 30.0;
    scene.gaussians.log_scale[0] = [(standard_deviation / PIXELS_PER_UNIT).ln() as f32; 3];
    scene.gaussians.rotation[0] = [1.0, 0.0, 0.0, 0.0];
    let renderer = Renderer::new(devices::cpu(Some(1)));
    let scene = renderer.upload(&scene).expect("a scene").coarser(factor, 1);
    // two units away, an angle that shows SIDE / PIXELS_PER_UNIT units
    let angle = 2.0 * (f64::from(SIDE) / PIXELS_PER_UNIT / 4.0).atan();
    let whole = Camera::look_at([0.0, -2.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0], angle, [SIDE; 2]);
    let camera = whole.expect("a camera").smaller(factor);
    let side = camera.width;
    let batch = TileBatch::cover(0, side, side, side).expect("a tile");
    let tiles = renderer.render(&scene, &[camera], &batch).expect("a tile");
    let sum = |weight: &dyn Fn(f64) -> f64| -> f64 {
        let red = tiles.data[..(side * side) as usize].iter().enumerate();
        let from_center = |at: usize| (at as u32 % side) as f64 + 0.5 - f64::from(side) / 2.0;
        red.map(|(at, &red)| f64::from(red) * weight(from_center(at))).sum()
    };
    assert!(sum(&|_| 1.0) > 0.1, "{}", sum(&|_| 1.0));
    sum(&|x| x * x) / sum(&|_| 1.0)
}

#[test]
fn a_smaller_image_has_the_blur_of_its_pixels() {
    // a footprint ends where its falloff is 1/255, with this part of the variance of the normal distribution
    let cut = 1.0 - 255f64.ln() / 254.0;
    let blur = demo::config().blur;
    for standard_deviation in [1.0, 1.5, 3.0] {
        let whole = standard_deviation * standard_deviation + blur;
        for (factor, expected) in [(1, whole), (2, (whole + 0.25) / 4.0)] {
            let found = variance(standard_deviation, factor);
            let error = (found / (cut * expected) - 1.0).abs();
            assert!(error < 0.03, "{standard_deviation}, {factor}: {found} {expected}");
        }
    }
}
