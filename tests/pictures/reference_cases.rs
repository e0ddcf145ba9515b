//! Every case of the float64 reference on every backend: the tiles, and each stage.

use organza::render::SceneGradient;
use organza::{DeviceScene, Renderer, UploadOptions};
use organza_tests::cases::{self, Case};
use organza_tests::compare::{assert_close, assert_close_relative, difference};

/// Absolute tolerance of the tiles.
const TILES: f64 = 2e-4;
/// Absolute tolerance of the tiles of scenes whose grids are 16-bit floats.
const HALF_TILES: f64 = 2e-4;
/// Relative tolerance of each stage.
const STAGE: f64 = 1e-4;

#[test]
fn tiles_match_the_reference() {
    cases::on_every_device(|backend, renderer, case, scene| {
        let tiles = renderer.render(scene, &case.cameras, &case.tiles).expect("it renders");
        let what = format!("{}, tiles on {backend}", case.name);
        assert_close(&what, &tiles.data, case.expected("tiles"), TILES);
    });
}

/// Features differ by 2^-11 of the entries around them. The effect on a pixel depends on the networks.
#[test]
fn tiles_of_half_grids_are_close() {
    cases::on_every_device(|backend, renderer, case, full| {
        let scene = renderer
            .upload_with(&case.scene, UploadOptions { half_grids: true })
            .expect("it is uploaded");
        assert!(scene.bytes() < full.bytes(), "{}: no smaller on {backend}", case.name);
        let tiles = renderer.render(&scene, &case.cameras, &case.tiles).expect("it renders");
        let what = format!("{}, tiles of half grids on {backend}", case.name);
        assert_close(&what, &tiles.data, case.expected("tiles"), HALF_TILES);
        assert!(SceneGradient::new(renderer.device(), &scene).is_err(), "halves have gradients");
    });
}

#[test]
fn stages_match_the_reference() {
    cases::on_every_device(|backend, renderer, case, scene| {
        for camera in 0..case.cameras.len() {
            compare_stages(renderer, backend, case, scene, camera);
        }
    });
}

fn compare_stages(
    renderer: &Renderer,
    backend: &str,
    case: &Case,
    scene: &DeviceScene,
    camera: usize,
) {
    let stages = renderer.stages(scene, &case.cameras[camera]).expect("the stages run");
    let expected = |stage: &str| case.expected(&format!("stage.{camera}.{stage}"));
    let compare = |stage: &str, actual: &[f32], expected: &[f32]| {
        assert_close_relative(
            &format!("{}, {stage} of camera {camera} on {backend}", case.name),
            actual,
            expected,
            STAGE,
        );
    };
    compare("color_encoding", &stages.color_encoding, case.expected("stage.color_encoding"));
    compare("sh", &stages.sh, expected("sh"));
    compare("color", &stages.color, expected("color"));
    compare("transmittance", &stages.transmittance, expected("transmittance"));
    let counts: Vec<f32> = stages.sample_count.iter().map(|&count| count as f32).collect();
    assert_eq!(counts, expected("sample_count"), "{}: sample counts on {backend}", case.name);

    // a Gaussian behind the camera has no projection to compare
    let visible: Vec<bool> = expected("visible").iter().map(|&v| v != 0.0).collect();
    let found: Vec<bool> = stages.radius.iter().map(|&radius| radius >= 0.0).collect();
    assert_eq!(found, visible, "{}: visibility on {backend}", case.name);
    let keep = |values: &[f32], width: usize| -> Vec<f32> {
        let rows = values.chunks_exact(width).zip(&visible);
        rows.filter(|(_, visible)| **visible).flat_map(|(row, _)| row.to_vec()).collect()
    };
    compare("mean2d", &keep(stages.mean2d.as_flattened(), 2), &keep(expected("mean2d"), 2));
    compare("radius", &keep(&stages.radius, 1), &keep(expected("radius"), 1));
    let conic: Vec<f32> = stages.conic.iter().flat_map(|&[xx, xy, yy]| [xx, xy, xy, yy]).collect();
    compare("conic", &keep(&conic, 4), &keep(expected("conic"), 4));
}

/// Tolerance relative to the norm of a tensor's gradient.
const GRADIENT: f64 = 1e-3;

#[test]
fn gradients_match_the_reference() {
    cases::on_every_device(|backend, renderer, case, scene| {
        let grad_tiles = case.expected("grad_tiles");
        let tape = renderer.record(scene, &case.cameras, &case.tiles).expect("it renders");
        let (gradient, poses) = tape.backward_with_poses(grad_tiles).expect("there is a gradient");
        let tensors = gradient.tensors().into_iter().map(|(tensor, found)| (tensor.name, found));
        for (name, found) in tensors.chain([("poses".to_owned(), poses.as_flattened())]) {
            let name = format!("grad.{name}");
            let expected = if found.is_empty() { &[] } else { case.expected(&name) };
            let what = format!("{}, {name} on {backend}", case.name);
            let relative = difference(found, expected).relative;
            assert!(relative <= GRADIENT, "{what}: {relative:.3e} relative");
            println!("{what}: {relative:.1e} relative");
        }
    });
}
