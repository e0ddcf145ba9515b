//! A part whose numbers stay on the device, beside one that the host knows all about.

mod distortion;
mod exposure;
mod recording;
mod smaller;

use crate::MODULES;
use crate::pass::part::{Part, TileGradient};
use crate::pass::renderer::Renderer;
use crate::scene::device_scene::DeviceScene;
use crate::stages::counts::Capacity;
use crate::stages::cut::{PART_BYTES, PartTiles};
use crate::stages::gradient::SceneGradient;
use muslin_check::devices;
use muslin_device::{Buffer, Device};
use organza_core::camera::Camera;
use organza_core::demo;
use organza_core::scene::Scene;
use organza_core::tile::{Tile, TileBatch};

/// The CPU with two threads, and the GPU where there is one.
fn all_devices() -> Vec<Device> {
    let gpus = devices::gpus(&MODULES).into_iter().map(|(_, device)| device);
    std::iter::once(devices::cpu(Some(2))).chain(gpus).collect()
}

fn tiles() -> TileBatch {
    let at = |camera, x, y| Tile { camera, origin: [x, y] };
    TileBatch { side: 16, tiles: vec![at(0, 20, 30), at(0, 40, 32), at(1, 24, 24), at(1, -8, -8)] }
}

/// Every nth Gaussian of the built-in scene, with longer steps: most of the time would go into samples.
fn every(nth: usize) -> Scene {
    let mut scene = demo::scene();
    scene.config.step *= 4.0;
    // few Gaussians, at their whole weight; `tests/cases/antialiased` has the others
    scene.config.antialiased = false;
    let indices: Vec<_> = (0..scene.gaussians.len()).step_by(nth).collect();
    scene.gaussians = scene.gaussians.select(&indices);
    scene
}

/// Some, with small hash grids: going back looks at every entry, for each part.
fn some() -> Scene {
    let mut scene = every(24);
    let config = &mut scene.config;
    let grids = [&mut config.color_grid, &mut config.transmittance_grid];
    for (grid, field) in grids.into_iter().zip([&mut scene.color, &mut scene.transmittance]) {
        grid.log2_table = 8;
        field.grid.truncate(grid.entries() * grid.features as usize);
    }
    scene
}

/// The values of a buffer as bits.
fn bits<T: bytemuck::Pod>(device: &Device, buffer: &Buffer<T>) -> Vec<u32> {
    device.read(&buffer.view()).expect("a buffer")
}

/// The image, and all gradients of its pixels taken as their own gradient.
fn evaluate(
    scene: &DeviceScene,
    cameras: &[Camera],
    plan: &PartTiles,
    capacity: Option<Capacity>,
) -> (Vec<Vec<u32>>, Option<Capacity>) {
    let device = scene.device();
    let part = Part::evaluate(scene, cameras, plan, true, capacity).expect("a part");
    let gradient = SceneGradient::new(scene.device(), scene).expect("memory");
    let image = &part.composite.image;
    let of_tiles = TileGradient { grad_tiles: image.view(), distortion: None };
    let of_pairs = part.pair_gradient(scene, plan.side, &of_tiles).expect("a gradient");
    part.backward(scene, &of_pairs, &gradient).expect("a gradient");
    let needed = part.read(device, Vec::new()).expect("counts").map(|(_, needed)| needed);
    let mut values = vec![bits(device, image), bits(device, &gradient.statistics)];
    for (_, tensor) in gradient.tensors().iter() {
        values.push(bits(device, &tensor.buffer));
        values.extend(tensor.touched.as_ref().map(|touched| bits(device, touched)));
    }
    (values, needed)
}

#[test]
fn predicted_capacities_keep_the_bits() {
    let scene = some();
    let cameras = demo::turntable(2, 64);
    for device in all_devices() {
        let renderer = Renderer::new(device);
        let device = renderer.device();
        let scene = renderer.upload(&scene).expect("a scene");
        let plans = PartTiles::split(&scene, &tiles(), PART_BYTES).expect("a plan");
        assert_eq!(plans.len(), 1);
        let (expected, needed) = evaluate(&scene, &cameras, &plans[0], None);
        let Some(capacity) = needed else { panic!("there is capacity for all") };
        let Capacity { pairs, members, samples } = capacity;
        assert!(pairs > 100 && members > pairs && samples > 2 * pairs, "{capacity:?}");

        // enough
        let more = Capacity { pairs: pairs * 2, members: members + 100, samples: samples * 3 };
        for capacity in [capacity, more] {
            let (found, told) = evaluate(&scene, &cameras, &plans[0], Some(capacity));
            assert_eq!(told, needed, "{}", device.choice());
            for (index, (found, expected)) in found.iter().zip(&expected).enumerate() {
                assert!(found == expected, "{}: value {index}, {capacity:?}", device.choice());
            }
        }
        // too little of one: background, and no gradient at all
        let background = scene.config.background.map(|channel| (channel as f32).to_bits());
        let pairs = pairs - 1;
        let members = members - 1;
        let samples = samples - 1;
        for capacity in
            [Capacity { pairs, ..more }, Capacity { members, ..more }, Capacity { samples, ..more }]
        {
            let (found, told) = evaluate(&scene, &cameras, &plans[0], Some(capacity));
            assert_eq!(told, None, "{}: {capacity:?}", device.choice());
            let planes = found[0].chunks(16 * 16).zip(background.into_iter().cycle());
            for (plane, value) in planes {
                // pixels beside the image are black
                assert!(plane.iter().all(|&bits| bits == value || bits == 0), "{capacity:?}");
            }
            for (index, values) in found.iter().enumerate().skip(1) {
                let is_zero = values.iter().all(|&bits| f32::from_bits(bits) == 0.0);
                assert!(is_zero, "{}: value {index}, {capacity:?}", device.choice());
            }
        }
    }
}

#[test]
fn a_refused_tile_is_tried_with_exact_capacities() {
    let scene = some();
    let cameras = demo::turntable(1, 64);
    let tiles = vec![Tile { camera: 0, origin: [20, 30] }];
    let batch = TileBatch { side: 16, tiles };
    for device in all_devices() {
        let renderer = Renderer::new(device);
        let device = renderer.device();
        let scene = renderer.upload(&scene).expect("a scene");
        let expected = renderer.render(&scene, &cameras, &batch).expect("a tile");
        device.refuse_one(12);
        let found = renderer.render(&scene, &cameras, &batch);
        assert!(!device.refuse_one(0), "{}: so few buffers", device.choice());
        match (device.backend(), found) {
            // a CPU predicts no capacity
            ("cpu", Err(error)) if error.is_out_of_memory() => {}
            ("gpu", Ok(found)) => assert_eq!(found, expected, "{}", device.choice()),
            (_, found) => panic!("{}: {found:?}", device.choice()),
        }
    }
}
