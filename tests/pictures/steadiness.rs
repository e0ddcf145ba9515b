//! Measures how steady images are while a camera moves slowly, compared with those of sorted Gaussians.
//!
//! The change from one frame to the next has two parts: the effect of the camera's motion, and jumps. With equal
//! small steps h of the camera, the first is nearly linear. So the second difference `|Y(t - h) - 2 Y(t) + Y(t + h)|`
//! of a pixel falls with h squared, or with h at an edge of the slope. A jump keeps its size.

use std::fs;
use std::path::PathBuf;

use organza::camera::Orbit;
use organza::{Camera, DeviceOptions, DeviceScene, Renderer, Scene, Tile, TileBatch, demo};
use organza_tests::cases::{self, Case};
use organza_tests::sorted::{self, Footprint, Splat};

type Pixels = Vec<[f32; 3]>;

/// The camera's steps on its circle, in degrees.
const STEPS: [f64; 4] = [0.4, 0.1, 0.025, 0.00625];
/// Frames of each step.
const FRAMES: usize = 10;
/// Side of the images, in pixels.
const SIDE: u32 = 128;
/// Names of the [`images`].
const KINDS: [&str; 4] = ["organza", "sorted", "organza-whole", "sorted-whole"];

fn renderer() -> Renderer {
    Renderer::new(organza::open_device(&DeviceOptions::cpu(None)).expect("a CPU"))
}

/// The image as organza renders it, and as sorted Gaussians give it; then both with footprints that do not end.
fn images(
    renderer: &Renderer,
    scene: &Scene,
    uploaded: &DeviceScene,
    camera: &Camera,
) -> [Pixels; 4] {
    let side = camera.width;
    let batch = TileBatch { side, tiles: vec![Tile { camera: 0, origin: [0, 0] }] };
    let tiles =
        renderer.render(uploaded, std::slice::from_ref(camera), &batch).expect("it renders");
    let side = side as usize;
    let own: Pixels = (0..side * side).map(|at| tiles.rgb(0, at % side, at / side)).collect();
    let background = scene.config.background.map(|channel| channel as f32);
    let splats = sorted::splats(renderer, scene, uploaded, camera);
    let [cut, whole] = [Footprint::Cut, Footprint::Whole].map(|footprint| {
        [sorted::sum, sorted::blend].map(|rule| rule(&splats, [side; 2], background, footprint))
    });
    let [sum, sorted] = cut;
    let off = own.as_flattened().iter().zip(sum.as_flattened()).map(|(a, b)| (a - b).abs());
    assert!(off.fold(0.0, f32::max) < 1e-4, "the sum is what organza renders");
    let [own_whole, sorted_whole] = whole;
    [own, sorted, own_whole, sorted_whole]
}

/// The second difference of every pixel, over its channels the largest, in 8-bit levels.
fn second_differences(frames: &[Pixels]) -> Vec<f32> {
    let [before, now, after] = frames else { panic!("three frames") };
    let pixel = |at: usize| {
        let channel = |c: usize| (before[at][c] - 2.0 * now[at][c] + after[at][c]).abs();
        255.0 * channel(0).max(channel(1)).max(channel(2))
    };
    (0..now.len()).map(pixel).collect()
}

fn largest(differences: &[f32]) -> f32 {
    differences.iter().copied().fold(0.0, f32::max)
}

#[test]
fn sorted_gaussians_are_blended_front_to_back() {
    let splat = |depth: f64, opacity: f32, color: [f32; 3]| Splat {
        depth,
        mean: [2.5, 1.5],
        conic: [0.5, 0.0, 0.5],
        radius: 5.0,
        opacity,
        color,
        transmittance: 1.0,
    };
    let red = [1.0, 0.0, 0.0];
    let blue = [0.0, 0.0, 1.0];
    let image = |splats: &[Splat]| sorted::blend(splats, [5, 4], [0.0, 1.0, 0.0], Footprint::Cut);
    let both = image(&[splat(2.0, 0.5, blue), splat(1.0, 0.25, red)]);
    // red in front: 0.25, then blue 0.75 * 0.5, then the background 0.75 * 0.5
    assert_eq!(both[5 + 2], [0.25, 0.375, 0.375]);
    // one pixel aside: falloff exp(-0.25)
    let fall = (-0.25_f32).exp();
    let r = 0.25 * fall;
    let b = 0.5 * fall;
    let expected = [r, (1.0 - r) * (1.0 - b), (1.0 - r) * b];
    let off = both[5 + 3].iter().zip(expected).map(|(a, b)| (a - b).abs());
    assert!(off.fold(0.0, f32::max) < 1e-6);
    assert!(both == image(&[splat(1.0, 0.25, red), splat(2.0, 0.5, blue)]));
    assert_eq!(image(&[]), vec![[0.0, 1.0, 0.0]; 20]);
}

/// Two transparent Gaussians, one behind the other. From the middle of the arc on, their order is reversed.
fn crossing() -> (Scene, Vec<Camera>) {
    let mut scene = Case::load(&cases::folder().join("basic")).scene;
    let [low, high] = scene.config.aabb;
    let center: [f64; 3] = std::array::from_fn(|axis| (low[axis] + high[axis]) / 2.0);
    let half = (high[0] - low[0]) as f32 / 2.0;
    let gaussians = &mut scene.gaussians;
    gaussians.opacity.fill(-30.0);
    for (gaussian, side) in [(0, -1.0), (1, 1.0)] {
        gaussians.position[gaussian] = center.map(|value| value as f32);
        gaussians.position[gaussian][0] += side * 0.1 * half;
        gaussians.log_scale[gaussian] = [(0.2 * half).ln(); 3];
        gaussians.opacity[gaussian] = 1.5;
    }
    let step = 0.05_f64.to_radians();
    let (sin, cos) = (3.5 * step).sin_cos();
    let orbit = Orbit {
        center,
        up: [0.0, 0.0, 1.0],
        toward: [sin, cos, 0.0],
        distance: 3.0 * f64::from(half),
        elevation: 0.2,
        angle: 0.6,
        size: [32, 32],
    };
    (scene, orbit.cameras(7200).unwrap()[..8].to_vec())
}

/// When two Gaussians change their order, a sorted image jumps. Organza's must not.
#[test]
fn what_is_not_sorted_does_not_jump() {
    let renderer = renderer();
    let (scene, cameras) = crossing();
    let uploaded = renderer.upload(&scene).expect("it fits");
    let frames: Vec<_> =
        cameras.iter().map(|camera| images(&renderer, &scene, &uploaded, camera)).collect();
    let [own, sorted, ..] = [0, 1, 2, 3].map(|kind| {
        let of_kind: Vec<_> = frames.iter().map(|images| images[kind].clone()).collect();
        let of_three = of_kind.windows(3).map(|three| largest(&second_differences(three)));
        of_three.fold(0.0, f32::max)
    });
    assert!(own < 0.5 && sorted > 4.0, "in 8-bit levels: own {own}, sorted {sorted}");
}

/// The numbers of docs/experiments.md, for `docs/experiments/steadiness.py`: the second differences along an orbit,
/// with a file of f32 for each step and each kind of image. `SCENE` and `CAMERAS` name another scene than the
/// built-in one.
#[test]
#[ignore = "it measures, for minutes"]
fn measure_steadiness() {
    let renderer = renderer();
    let path = |name: &str| std::env::var_os(name).map(PathBuf::from);
    let scene = path("SCENE").map_or_else(demo::scene, |path| Scene::load(path).expect("a scene"));
    let cameras = path("CAMERAS")
        .map_or_else(|| demo::turntable(24, SIDE), |path| Camera::load_all(path).expect("cameras"));
    let orbit = Orbit { size: [SIDE; 2], ..Orbit::around(&cameras).expect("cameras") };
    let uploaded = renderer.upload(&scene).expect("it fits");
    let out = path("OUT").expect("OUT names a folder");
    for step in STEPS {
        let cameras = orbit.cameras((360.0 / step).round() as usize).expect("a circle");
        let frames: Vec<_> = cameras[..FRAMES]
            .iter()
            .map(|camera| images(&renderer, &scene, &uploaded, camera))
            .collect();
        for (kind, name) in KINDS.iter().enumerate() {
            let of_kind: Vec<_> = frames.iter().map(|images| images[kind].clone()).collect();
            let values = of_kind.windows(3).flat_map(second_differences);
            let bytes: Vec<u8> = values.flat_map(f32::to_le_bytes).collect();
            fs::write(out.join(format!("{step}-{name}.raw")), bytes).expect("it is written");
        }
    }
}
