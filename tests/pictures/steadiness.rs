//! When two Gaussians change their order, an image of sorted Gaussians jumps. Organza's must not.
//!
//! The change from one frame to the next has two parts: the effect of the camera's motion, and jumps. With equal
//! small steps of the camera, the first is nearly linear. So the second difference of a pixel,
//! `|Y(t - h) - 2 Y(t) + Y(t + h)|`, is small unless there is a jump.

use organza::camera::Orbit;
use organza::splats::{self, Splat};
use organza::{Camera, Renderer, Scene, TileBatch};
use organza_tests::cases::{self, Case};
use organza_tests::devices;

type Pixels = Vec<[f32; 3]>;

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

/// The largest second difference of a pixel, in 8-bit levels.
fn jump(frames: &[Pixels]) -> f32 {
    let of_three = frames.windows(3).flat_map(|three| {
        let [before, now, after] = [0, 1, 2].map(|frame| three[frame].as_flattened());
        before.iter().zip(now).zip(after).map(|((before, now), after)| before - 2.0 * now + after)
    });
    255.0 * of_three.fold(0.0, |largest: f32, value| largest.max(value.abs()))
}

/// The same Gaussians, for a renderer that sorts. All cameras see the colors of the first one.
fn sorted(renderer: &Renderer, scene: &Scene, camera: &Camera) -> Vec<Splat> {
    let uploaded = renderer.upload(scene).expect("it fits");
    let colors = renderer.stages(&uploaded, camera).expect("the stages run").color;
    let splat = |(gaussian, color): (usize, &[f32; 3])| Splat {
        position: scene.gaussians.position[gaussian],
        rotation: scene.gaussians.rotation[gaussian],
        log_scale: scene.gaussians.log_scale[gaussian],
        opacity: scene.gaussians.opacity[gaussian],
        // the harmonic of band 0
        color: std::array::from_fn(|band| match band {
            0 => color.map(|channel| (channel - 0.5) / 0.282_094_8),
            _ => [0.0; 3],
        }),
    };
    colors.as_chunks::<3>().0.iter().enumerate().map(splat).collect()
}

#[test]
fn images_without_sorting_do_not_jump() {
    let renderer = Renderer::new(devices::cpu(None));
    let (scene, cameras) = crossing();
    let background = scene.config.background.map(|channel| channel as f32);
    let gaussians = sorted(&renderer, &scene, &cameras[0]);
    let sorted: Vec<_> = cameras
        .iter()
        .map(|camera| splats::render(&gaussians, camera, background, false))
        .collect();
    let uploaded = renderer.upload(&scene).expect("it fits");
    let own = cameras.iter().map(|camera| -> Pixels {
        let batch = TileBatch::cover(0, 32, 32, 32).expect("one tile");
        let cameras = std::slice::from_ref(camera);
        let tiles = renderer.render(&uploaded, cameras, &batch).expect("it renders");
        (0..32 * 32).map(|at| tiles.rgb(0, at % 32, at / 32)).collect()
    });
    let [own, sorted] = [own.collect(), sorted].map(|frames: Vec<Pixels>| jump(&frames));
    assert!(own < 0.5 && sorted > 4.0, "in 8-bit levels: own {own}, sorted {sorted}");
}
