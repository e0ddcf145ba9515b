//! Parts whose counts stay on the device against parts whose counts the host reads; smaller images, as in training; exposures.

mod tape;

use crate::pass::batch::BatchPart;
use crate::pass::part::Part;
use crate::stages::counts::PartCounts;
use crate::stages::cut::PartTiles;
use crate::{
    Capacity, DeviceScene, LossTarget, MODULES, Renderer, SceneGradient, TileImages, TileLoss,
};
use muslin_check::devices;
use muslin_device::{Buffer, Device};
use organza_core::scene::{Scene, SceneConfig};
use organza_core::{Camera, Tile, TileBatch, demo};
use organza_shaders::exposure::STRIDE;

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
    // few Gaussians at full weight; `tests/cases/antialiased` tests compensated ones
    scene.config.antialiased = false;
    let indices: Vec<_> = (0..scene.gaussians.len()).step_by(nth).collect();
    scene.gaussians = scene.gaussians.select(&indices);
    scene
}

/// Some Gaussians, with small hash grids: the backward pass visits every entry, for each part.
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
    part_tiles: &PartTiles,
    capacity: Option<Capacity>,
) -> (Vec<Vec<u32>>, Option<Capacity>) {
    let device = scene.device();
    let counts = capacity.map(|capacity| PartCounts::new(device, vec![capacity]).expect("memory"));
    let part = Part::evaluate(scene, cameras, part_tiles, true, counts).expect("a part");
    let gradient = SceneGradient::new(scene.device(), scene).expect("memory");
    let image = &part.composite.image;
    let d_pairs = part.composite.backward(part.context(scene), image).expect("a gradient");
    part.raise_bounds(scene, &d_pairs.splat, &gradient).expect("bounds");
    let counts = [&part.bins.pairs.count, &part.transmittance.samples];
    gradient.set_scales(device, scene, counts).expect("scales");
    part.backward(scene, &d_pairs, &gradient, None, false).expect("a gradient");
    gradient.finish(device).expect("a gradient");
    let needed = match &part.bins.part_counts {
        None => Some(part.capacity),
        Some(counts) => Capacity::needed(&device.read(&counts.counts).expect("counts")),
    };
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
        let parts = renderer.pass(&scene, &cameras).cut(&tiles()).expect("parts").list;
        let [BatchPart { part_tiles, .. }] = &parts[..] else { panic!("{} parts", parts.len()) };
        let (expected, needed) = evaluate(&scene, &cameras, part_tiles, None);
        let Some(capacity) = needed else { panic!("there is capacity for all") };
        let Capacity { pairs, intersections, samples } = capacity;
        assert!(pairs > 100 && intersections > pairs && samples > 2 * pairs, "{capacity:?}");

        // enough
        let more =
            Capacity { pairs: pairs * 2, intersections: intersections + 100, samples: samples * 3 };
        for capacity in [capacity, more] {
            let (found, told) = evaluate(&scene, &cameras, part_tiles, Some(capacity));
            assert_eq!(told, needed, "{}", device.choice());
            for (index, (found, expected)) in found.iter().zip(&expected).enumerate() {
                assert!(found == expected, "{}: value {index}, {capacity:?}", device.choice());
            }
        }
        // too little of one: background, and no gradient at all
        let background = scene.config.background.map(|channel| (channel as f32).to_bits());
        let pairs = pairs - 1;
        let intersections = intersections - 1;
        let samples = samples - 1;
        for capacity in [
            Capacity { pairs, ..more },
            Capacity { intersections, ..more },
            Capacity { samples, ..more },
        ] {
            let (found, told) = evaluate(&scene, &cameras, part_tiles, Some(capacity));
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

/// Step of the central differences.
const STEP: f32 = 1e-2;
/// w
const WEIGHT: f32 = 0.5;

/// The logarithm of a gain, and an offset, for each channel of the photographs of [`tiles`]: no color is below 0.3.
fn exposures() -> Vec<f32> {
    let log_gain = |at: usize| (0.6 + 0.1 * (at % 9) as f32).ln();
    let offset = |at: usize| 0.3 + 0.01 * (at % 5) as f32;
    (0..6).flat_map(|at| [log_gain(at), offset(at)]).collect()
}

/// The loss of [`tiles`], its gradients with respect to the exposures `[2, 3, 2]`, and to one bias of the color network.
fn of_exposure(renderer: &Renderer, scene: &Scene, exposure: &[f32]) -> (f64, Vec<f64>, f64) {
    let pixels = 4 * 16 * 16;
    // darker than what is rendered, so that no difference changes its sign
    let image: Vec<_> = (0..3 * pixels).map(|at| 0.12 + 0.1 * (at as f32 * 0.7).sin()).collect();
    let valid: Vec<_> = (0..pixels).map(|at| f32::from(at % 11 > 0)).collect();
    let device = renderer.device();
    let padding = [0.0; STRIDE as usize - 6];
    let exposure: Vec<_> =
        exposure.chunks(6).flat_map(|values| [values, &padding].concat()).collect();
    let target = LossTarget {
        photographs: &TileImages { image: &image, valid: &valid, side: 16 },
        valid_pixels: valid.iter().copied().map(f64::from).sum(),
        ssim_weight: WEIGHT,
        exposure: Some(&device.upload("exposures", &exposure).expect("memory")),
    };
    let on_device = renderer.upload(scene).expect("a scene");
    let gradient = SceneGradient::new(device, &on_device).expect("memory");
    let gradient = gradient.with_exposures(device, 2).expect("memory");
    let cameras = demo::turntable(2, 64);
    let found = renderer
        .add_loss_gradient(&on_device, &cameras, &tiles(), &target, None, &gradient, None)
        .expect("a loss");
    let by_exposure = gradient.exposures.as_ref().expect("they are wanted");
    let by_exposure = device.read(&by_exposure.values).expect("numbers");
    let by_exposure = by_exposure.chunks(STRIDE as usize).flat_map(|values| &values[..6]);
    let by_exposure = by_exposure.copied().map(f64::from).collect();
    let tensors = gradient.download(device, &scene.config, scene.gaussians.len()).expect("numbers");
    let tensors = tensors.tensors();
    let (_, bias) = tensors.iter().find(|(spec, _)| spec.name == BIAS).expect("a bias");
    assert_eq!(found.loss, TileLoss::total(&found.tiles).value(WEIGHT));
    (found.loss, by_exposure, bias[0].into())
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
        let (_, found, by_bias) = of_exposure(&renderer, &scene, &exposure);
        let slope = |of: &dyn Fn(f32) -> f64| (of(STEP) - of(-STEP)) / f64::from(2.0 * STEP);
        let largest = found.iter().fold(0.0_f64, |largest, g| largest.max(g.abs()));
        for at in 0..exposure.len() {
            let expected = slope(&|step| {
                let mut exposure = exposure.clone();
                exposure[at] += step;
                of_exposure(&renderer, &scene, &exposure).0
            });
            let error = (found[at] - expected).abs();
            assert!(error < 2e-3 * largest, "{at}: {} and {expected}", found[at]);
        }
        let expected = slope(&|step| {
            let mut scene = scene.clone();
            scene.color.network.layers.last_mut().expect("a head").bias[0] += step;
            of_exposure(&renderer, &scene, &exposure).0
        });
        assert!((by_bias - expected).abs() < 2e-3 * expected.abs(), "{by_bias} and {expected}");
    }
}
