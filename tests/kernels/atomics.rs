//! Atomics count exactly, for any number of invocations and threads.

use glam::{Vec2, Vec3};
use organza_shaders::camera::Camera;
use organza_shaders::project::{EVERYWHERE, ProjectKernel, ProjectParams};
use organza_tests::devices;

#[test]
fn every_invocation_counts_once() {
    const GAUSSIANS: u32 = 10_007;
    const CAMERAS: u32 = 3;
    let camera = Camera {
        rotation: [Vec3::X, Vec3::Y, Vec3::Z],
        eye: Vec3::new(0.0, 0.0, -5.0),
        focal: Vec2::splat(100.0),
        center: Vec2::splat(50.0),
        size: Vec2::splat(100.0),
    };
    // too large for f32: only one of three can be projected
    let log_scale: Vec<_> =
        (0..GAUSSIANS).flat_map(|i| [if i % 3 == 0 { -2.0 } else { 200.0 }; 3]).collect();
    let degenerate = CAMERAS * (0..GAUSSIANS).filter(|i| i % 3 != 0).count() as u32;
    let rotation = [1.0, 0.0, 0.0, 0.0].repeat(GAUSSIANS as usize);
    for (name, device) in devices::all() {
        let cameras = [camera.pack(); CAMERAS as usize].concat();
        let slots = (GAUSSIANS * CAMERAS) as usize;
        let counter = device.upload("degenerate", &[5_u32]).unwrap();
        let kernel = ProjectKernel {
            params: ProjectParams { gaussians: GAUSSIANS, blur: 0.3 },
            camera: &device.upload("camera", &cameras).unwrap(),
            window: &device.upload("window", &EVERYWHERE.repeat(CAMERAS as usize)).unwrap(),
            position: &device.zeros("position", 3 * GAUSSIANS as usize).unwrap(),
            rotation: &device.upload("rotation", &rotation).unwrap(),
            log_scale: &device.upload("log_scale", &log_scale).unwrap(),
            projection: &device.zeros("projection", 2 * slots).unwrap(),
            degenerate: &counter,
        };
        for round in 1..=4 {
            device.run(&kernel, GAUSSIANS, CAMERAS).unwrap();
            assert_eq!(device.read(&counter).unwrap(), [5 + round * degenerate], "{name}");
        }
    }
}
