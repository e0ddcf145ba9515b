//! A and B alone, and the projection of C: every stage for every Gaussian.

use organza::{Camera, Renderer, Scene, Stages};

use crate::snapshots::generator::{Recipe, camera, camera_to};
use crate::snapshots::{RENDERERS, SNAPSHOTS};
use muslin_check::snapshot::compare::Tolerance;
use muslin_check::snapshot::tensors::Tensors;

/// For values of about 1. Measured: features 8e-7 if naga lets a driver fuse, 1e-7 otherwise.
const COLOR: Tolerance = Tolerance { absolute: 5e-6, relative: 5e-6 };
/// For T with up to 20 samples. Measured: 1e-7.
const TRANSMITTANCE: Tolerance = Tolerance { absolute: 1e-6, relative: 2e-6 };
/// For pixels and inverse square pixels. Measured: 5e-7 relative.
const PROJECTION: Tolerance = Tolerance { absolute: 1e-6, relative: 1e-5 };

fn stages(renderer: &Renderer, scene: &Scene, camera: &Camera) -> Stages {
    let scene = renderer.upload(scene).expect("the scene fits");
    renderer.stages(&scene, camera).expect("the stages run")
}

/// Compares harmonics, features and colors with their snapshot.
fn assert_color(names: [&str; 2], scene: &Scene, camera: &Camera) {
    let count = scene.gaussians.len();
    for (backend, renderer) in RENDERERS.iter() {
        let stages = stages(renderer, scene, camera);
        let mut tensors = Tensors::default();
        tensors.push("sh", &[count, scene.config.sh_width()], &stages.sh);
        let features = [count, scene.config.color_grid.width()];
        tensors.push("features", &features, &stages.color_encoding);
        tensors.push("color", &[count, 3], &stages.color);
        SNAPSHOTS.assert_tensors(names, backend, &tensors, COLOR);
    }
}

#[test]
fn color_of_every_degree() {
    for degree in 0..=7 {
        let recipe = Recipe { seed: 10 + degree, gaussians: 6, degree, ..Recipe::default() };
        let camera = camera([1.3, 0.9, -2.6], [64, 48]);
        let name = format!("color_degree_{degree}");
        let text = format!("A alone: harmonics to degree {degree}");
        assert_color([&name, &text], &recipe.scene(), &camera);
    }
}

#[test]
fn color_without_material() {
    let recipe = Recipe { seed: 31, gaussians: 6, material: 0, ..Recipe::default() };
    let camera = camera([-1.0, 0.2, -3.0], [64, 48]);
    let text = "A alone: material of width 0";
    assert_color(["color_without_material", text], &recipe.scene(), &camera);
}

/// Gaussians in places for which the clip of a ray has a separate branch.
fn clip_scene(extra: u32) -> Scene {
    let recipe = Recipe { seed: 41, gaussians: 9, extra, clearness: 1.5, ..Recipe::default() };
    let mut scene = recipe.scene();
    // The camera of these tests is at (0.1, 0.3, -4) or inside. The box is [-1.5, 1.5] x [-1.2, 1.2] x [-1, 1.4], and
    // the cube is a ninth larger on each side.
    scene.gaussians.position = vec![
        [0.2, -0.4, 0.5],   // inside
        [0.1, 0.3, 0.9],    // axis-parallel: straight ahead
        [0.1, 0.3, 3.7],    // axis-parallel, outside, seen through the whole cube
        [0.1, -7.0, -4.0],  // axis-parallel, outside, seen past the cube
        [9.0, 5.0, 8.0],    // outside, seen past the cube
        [-0.2, -0.6, 2.5],  // outside, seen through the cube
        [0.3, 0.8, -9.0],   // behind the camera
        [1.49, 1.19, 1.39], // in the box's corner
        [0.7, -1.1, -0.9],
    ];
    scene
}

/// Records K and T of Eq. 8 and 11.
fn record_transmittance(stages: &Stages) -> Tensors {
    let count = stages.transmittance.len();
    let mut tensors = Tensors::default();
    tensors.push_counts("sample_count", &[count], &stages.sample_count);
    tensors.push("transmittance", &[count], &stages.transmittance);
    tensors
}

#[test]
fn transmittance_from_outside() {
    let camera = camera_to([0.1, 0.3, -4.0], [0.1, 0.3, 0.0], [64, 48]);
    for (extra, name) in [(2, "transmittance_from_outside"), (0, "transmittance_without_extra")] {
        let scene = clip_scene(extra);
        for (backend, renderer) in RENDERERS.iter() {
            let stages = stages(renderer, &scene, &camera);
            let tensors = record_transmittance(&stages);
            let missed: Vec<usize> = (0..9).filter(|&i| stages.sample_count[i] == 0).collect();
            assert_eq!(missed, [3, 4, 6], "rays that miss the cube");
            let text =
                "B alone: K and T; axis-parallel rays, and rays that miss the cube (3, 4, 6)";
            SNAPSHOTS.assert_tensors([name, text], backend, &tensors, TRANSMITTANCE);
        }
    }
}

#[test]
fn transmittance_from_inside() {
    let scene = clip_scene(2);
    let camera = camera_to([0.1, 0.3, 0.0], [0.1, 0.3, 1.0], [64, 48]);
    for (backend, renderer) in RENDERERS.iter() {
        let stages = stages(renderer, &scene, &camera);
        let tensors = record_transmittance(&stages);
        assert!(stages.sample_count.iter().all(|&k| k > 0), "every ray ends in the cube");
        let text = "B alone: K and T of a camera inside the cube";
        SNAPSHOTS.assert_tensors(
            ["transmittance_from_inside", text],
            backend,
            &tensors,
            TRANSMITTANCE,
        );
    }
}

#[test]
fn projection() {
    let recipe = Recipe { seed: 51, gaussians: 24, log_scale: [-4.0, 0.3], ..Recipe::default() };
    let scene = recipe.scene();
    // among the Gaussians: some are behind, and some so far to the side that J is clamped
    let camera = camera_to([0.1, 0.1, 0.1], [0.3, 0.0, 1.4], [64, 48]);
    for (backend, renderer) in RENDERERS.iter() {
        let stages = stages(renderer, &scene, &camera);
        let mut mean2d = Vec::new();
        let mut conic = Vec::new();
        let mut visible = Vec::new();
        for gaussian in 0..24 {
            let is_visible = stages.radius[gaussian] >= 0.0;
            visible.push(u32::from(is_visible));
            mean2d.extend(if is_visible { stages.mean2d[gaussian] } else { [0.0; 2] });
            conic.extend(if is_visible { stages.conic[gaussian] } else { [0.0; 3] });
        }
        let behind = visible.iter().filter(|&&visible| visible == 0).count();
        assert!((3..20).contains(&behind), "{behind} are behind");
        let mut tensors = Tensors::default();
        tensors.push_counts("visible", &[24], &visible);
        tensors.push("mean2d", &[24, 2], &mean2d);
        tensors.push("conic", &[24, 3], &conic);
        tensors.push("radius", &[24], &stages.radius);
        let text = "C alone: projection; zeros where the Gaussian is behind the camera";
        SNAPSHOTS.assert_tensors(["projection", text], backend, &tensors, PROJECTION);
    }
}
