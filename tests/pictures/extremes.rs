//! Scenes at the limits of number formats: the same image on every device, for every cut into tiles.

use std::collections::BTreeMap;

use glam::{Vec3, Vec4};
use organza::scene::{Contraction, Field};
use organza::{Camera, Device, Renderer, Scene};
use organza_shaders::composite_backward::{CompositeBackwardKernel, CompositeBackwardParams};
use organza_shaders::project::{FALLOFF_CUTOFF, mahalanobis};
use organza_shaders::tile::Tile;
use organza_tests::{cases, devices};

use super::reproducible::image;

/// Sides of the tiles that an image is cut into. The last two extend beyond the image.
const SIDES: [u32; 4] = [16, 32, 50, 64];

/// Largest difference between two devices: the same as for the tiles of every device (`reference_cases.rs`).
const TOLERANCE: f32 = 2e-4;

/// Limits of supports, minus and plus a margin in which rounding decides.
const CUTOFFS: [f32; 2] = [FALLOFF_CUTOFF - 1e-3, FALLOFF_CUTOFF + 1e-3];

/// A scene, with its extreme property.
struct Extreme {
    name: &'static str,
    scene: Scene,
    camera: Camera,
}

impl Extreme {
    /// The reference's basic case, with a change.
    fn new(name: &'static str, change: impl FnOnce(&mut Scene, &mut Camera)) -> Self {
        let mut case = cases::Case::load(&cases::folder().join("basic"));
        let mut camera = case.cameras.swap_remove(0);
        change(&mut case.scene, &mut camera);
        Self { name, scene: case.scene, camera }
    }

    fn with_focal(name: &'static str, focal: f64) -> Self {
        Self::new(name, |_, camera| (camera.fl_x, camera.fl_y) = (focal, focal))
    }

    /// The image from tiles with a given side.
    fn image(&self, renderer: &Renderer, side: u32) -> Vec<f32> {
        let scene = renderer.upload(&self.scene).expect("the scene fits");
        image(renderer, &scene, std::slice::from_ref(&self.camera), 0, side)
    }

    /// The image, which must not depend on the tiles.
    fn image_of_all_sides(&self, device: &str, renderer: &Renderer) -> Vec<f32> {
        let first = self.image(renderer, SIDES[0]);
        for side in &SIDES[1..] {
            let other = self.image(renderer, *side);
            let differ = first.iter().zip(&other).filter(|(a, b)| bits(**a) != bits(**b)).count();
            let name = self.name;
            assert_eq!(differ, 0, "{name} on {device}: values of tiles of {side} that differ");
        }
        first
    }

    /// The pixels inside a Gaussian's support that ends at `cutoff`.
    fn supports(&self, cutoff: f32) -> Vec<bool> {
        let renderer = Renderer::new(devices::cpu(None));
        let scene = renderer.upload(&self.scene).expect("the scene fits");
        let stages = renderer.stages(&scene, &self.camera).expect("the stages run");
        let width = self.camera.width as usize;
        let height = self.camera.height as usize;
        let is_reached = |pixel: usize| {
            let [x, y] = [pixel % width, pixel / width].map(|at| at as f64 + 0.5);
            (0..stages.radius.len()).any(|i| {
                let [mean_x, mean_y] = stages.mean2d[i].map(f64::from);
                let [xx, xy, yy] = stages.conic[i].map(f64::from);
                let dx = x - mean_x;
                let dy = y - mean_y;
                let q = xx * dx * dx + 2.0 * xy * dx * dy + yy * dy * dy;
                stages.radius[i] > 0.0 && q <= f64::from(cutoff)
            })
        };
        (0..width * height).map(is_reached).collect()
    }

    /// Asserts that pixels outside of all supports show the background.
    fn assert_background(&self, device: &str, image: &[f32], is_reached: &[bool]) {
        let name = self.name;
        let area = is_reached.len();
        let outside: Vec<_> = (0..area).filter(|&pixel| !is_reached[pixel]).collect();
        assert!(outside.len() > 100, "{} pixels lie outside of all supports", outside.len());
        for pixel in outside {
            for channel in 0..3 {
                let background = self.scene.config.background[channel] as f32;
                let value = image[channel * area + pixel];
                assert_eq!(value, background, "{name} on {device}: pixel {pixel}");
            }
        }
    }
}

/// The bits of a value. All NaNs count as equal.
fn bits(value: f32) -> u32 {
    if value.is_nan() { f32::NAN.to_bits() } else { value.to_bits() }
}

/// A size between 1e-30 and 1e30, for one of `count` Gaussians.
fn any_size(index: usize, count: usize) -> f32 {
    10f32.powf(60.0 * index as f32 / (count - 1) as f32 - 30.0)
}

/// Scenes whose images are finite.
fn finite() -> Vec<Extreme> {
    vec![
        Extreme::new("quaternions of 1e-30 to 1e30", |scene, _| {
            let count = scene.gaussians.len();
            for (index, rotation) in scene.gaussians.rotation.iter_mut().enumerate() {
                *rotation = rotation.map(|value| value * any_size(index, count));
            }
        }),
        Extreme::new("scales of 1e-30 to 1e30", |scene, _| {
            let count = scene.gaussians.len();
            for (index, log_scale) in scene.gaussians.log_scale.iter_mut().enumerate() {
                *log_scale = [any_size(index, count).ln(); 3];
            }
        }),
        Extreme::new("needles", |scene, _| {
            for (index, log_scale) in scene.gaussians.log_scale.iter_mut().enumerate() {
                let long = 10f32.powi(index as i32 % 5 - 1);
                *log_scale = [1e-30, 1e-4, long].map(f32::ln);
            }
        }),
        Extreme::new("discs", |scene, _| {
            for (index, log_scale) in scene.gaussians.log_scale.iter_mut().enumerate() {
                let wide = 10f32.powi(index as i32 % 5 - 3);
                *log_scale = [1e-30, wide, wide].map(f32::ln);
            }
        }),
        Extreme::new("an eye inside Gaussians", |scene, camera| {
            let eye = camera.eye();
            let forward = camera.axes()[2];
            let count = scene.gaussians.len();
            for index in 0..count / 2 {
                // in front of the near plane, on it, and behind
                let depth = 0.002 * (index as f64 - 3.0);
                let position: [f64; 3] = std::array::from_fn(|i| eye[i] + depth * forward[i]);
                scene.gaussians.position[index] = position.map(|x| x as f32);
                scene.gaussians.log_scale[index] = [10f32.powi(index as i32 % 7 - 3).ln(); 3];
            }
        }),
        Extreme::new("contracted, from the eye to 1e12 away", |scene, camera| {
            scene.config.contraction = Contraction::Cube;
            let gaussians = &mut scene.gaussians;
            let count = gaussians.position.len() as f32;
            for (index, position) in gaussians.position.iter_mut().enumerate() {
                let far = 10f32.powf(12.0 * index as f32 / count);
                *position = position.map(|x| far * x);
                gaussians.log_scale[index] = gaussians.log_scale[index].map(|x| x + far.ln());
            }
            gaussians.position[0] = camera.eye().map(|x| x as f32);
        }),
        Extreme::with_focal("a focal length of 1e-3", 1e-3),
        Extreme::with_focal("a focal length of 1", 1.0),
        Extreme::with_focal("a focal length of 1e4", 1e4),
        Extreme::with_focal("a focal length of 1e30", 1e30),
    ]
}

/// Networks whose layers overflow: colors and transmittances are NaN, infinite, 0 or 1.
fn overflowing() -> Vec<Extreme> {
    let overflow = |field: &mut Field| {
        let layers = field.network.layers.iter_mut();
        layers.flat_map(|layer| &mut layer.weight).for_each(|weight| *weight *= 1e13);
    };
    vec![
        Extreme::new("colors of weights times 1e13", |scene, _| overflow(&mut scene.color)),
        Extreme::new("networks of weights times 1e13", |scene, _| {
            overflow(&mut scene.color);
            overflow(&mut scene.transmittance);
        }),
    ]
}

/// Every instruction set and every device, and GPUs with variants.
fn every_device() -> Vec<(&'static str, Renderer)> {
    let variants = devices::variants().into_iter().map(|(_, [_, device])| ("gpu variants", device));
    let devices = devices::cpus().into_iter().chain(devices::all()).chain(variants);
    devices.map(|(name, device)| (name, Renderer::new(device))).collect()
}

#[test]
fn images_at_the_ends_of_numbers_agree() {
    let renderers = every_device();
    for extreme in finite() {
        let mut first: Option<Vec<f32>> = None;
        for (device, renderer) in &renderers {
            let found = extreme.image_of_all_sides(device, renderer);
            let name = extreme.name;
            assert!(found.iter().all(|value| value.is_finite()), "{name} on {device}");
            let area = found.len() / 3;
            let is_background = |(index, &value): (usize, &f32)| {
                value == extreme.scene.config.background[index / area] as f32
            };
            let is_blank = found.iter().enumerate().all(is_background);
            assert_eq!(is_blank, extreme.camera.fl_x == 1e30, "{name} on {device}");
            let first = first.get_or_insert_with(|| found.clone());
            let largest = first.iter().zip(&found).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
            assert!(largest <= TOLERANCE, "{name} on {device}: off by {largest}");
        }
    }
}

#[test]
fn overflow_stays_in_its_supports() {
    let renderers = every_device();
    for extreme in overflowing() {
        let name = extreme.name;
        let is_reached = extreme.supports(CUTOFFS[1]);
        let mut images = BTreeMap::new();
        for (device, renderer) in &renderers {
            let found = extreme.image_of_all_sides(device, renderer);
            let lost = found.iter().filter(|value| !value.is_finite()).count();
            assert!(lost > 100, "{name} on {device}: {lost} values are not finite");
            extreme.assert_background(device, &found, &is_reached);
            images.insert(*device, found.into_iter().map(bits).collect::<Vec<_>>());
        }
        // with one rounding for a multiply-add, and with two
        for [narrow, wide] in [["scalar", "plain"], ["avx2", "avx512"]] {
            if let (Some(narrow), Some(wide)) = (images.get(narrow), images.get(wide)) {
                assert!(narrow == wide, "{name}: the instruction set shows");
            }
        }
    }
}

#[test]
fn colors_that_are_nan_fill_their_supports() {
    // infinity minus infinity is NaN with any rounding
    let extreme = Extreme::new("colors that are NaN", |scene, _| {
        let [.., hidden, last] = &mut scene.color.network.layers[..] else { panic!("two layers") };
        hidden.bias.fill(1e30);
        for (index, weight) in last.weight.iter_mut().enumerate() {
            *weight = [1e38, -1e38][index % 2];
        }
    });
    let [inner, outer] = CUTOFFS.map(|cutoff| extreme.supports(cutoff));
    let inside: Vec<_> = (0..inner.len()).filter(|&pixel| inner[pixel]).collect();
    assert!(inside.len() > 100, "{} pixels lie in a support", inside.len());
    for (device, renderer) in every_device() {
        let found = extreme.image_of_all_sides(device, &renderer);
        extreme.assert_background(device, &found, &outer);
        let is_nan = |pixel: &usize| (0..3).all(|c| found[c * inner.len() + pixel].is_nan());
        assert!(inside.iter().all(is_nan), "a support on {device} holds numbers");
    }
}

/// The gradient of one intersection in one tile, for `gradient [4, S, S]`, of a splat that varies or not.
fn composite_backward(
    device: &Device,
    (splat, varies): ([Vec4; 3], u32),
    side: u32,
    gradient: &[f32],
) -> Vec<Vec4> {
    let tile = Tile { camera: 0, origin: [0, 0], output: 0 };
    let intersection_gradient = device.zeros("intersection gradient", 3).expect("memory");
    let intersection_slope = device.zeros("gradient of the slope", 2).expect("memory");
    let kernel = CompositeBackwardKernel {
        params: CompositeBackwardParams {
            intersections: 1,
            tiles: 1,
            side,
            first_row: 0,
            rows: side,
            compensated_blur: 0.0,
            sloped: varies,
            shaped: varies,
        },
        tile: &device.upload("tile", &tile.pack()).expect("memory"),
        tile_first: &device.upload("first", &[0, 1]).expect("memory"),
        intersection: &device.upload("intersection", &[0]).expect("memory"),
        splat: &device.upload("splat", &splat).expect("memory"),
        slope: &device.upload("slope", &[Vec4::splat(0.01); 4]).expect("memory"),
        sum_gradient: &device.upload("gradient", gradient).expect("memory"),
        intersection_gradient: &intersection_gradient,
        intersection_slope: &intersection_slope,
    };
    device.run(&kernel, 1, 1).expect("it runs");
    let read = |buffer| device.read(buffer).expect("it ran");
    [read(&intersection_gradient), read(&intersection_slope)].concat()
}

#[test]
fn a_gradient_outside_a_support_does_not_matter() {
    for side in SIDES {
        let conic = Vec3::new(0.5, 0.2, 0.3);
        // the extent exceeds the support: all lanes of its rows are summed
        let splat = [Vec4::new(9.3, 7.1, 0.7, 30.0), conic.extend(30.0), Vec4::splat(0.4)];
        let pixels = side * side;
        let gradient: Vec<_> = (0..4 * pixels).map(|at| (at as f32 * 0.37).sin()).collect();
        let spoiled = gradient.iter().enumerate().map(|(at, &value)| {
            let pixel = at as u32 % pixels;
            let [dx, dy] = [(pixel % side, splat[0].x), (pixel / side, splat[0].y)]
                .map(|(at, center)| at as f32 + 0.5 - center);
            let is_outside = mahalanobis(conic, dx, dy) > 1.001 * FALLOFF_CUTOFF;
            if is_outside { [f32::NAN, f32::INFINITY][at % 2] } else { value }
        });
        let spoiled: Vec<_> = spoiled.collect();
        let lost = spoiled.iter().filter(|value| !value.is_finite()).count();
        assert!(lost > 100 && lost < gradient.len() - 100, "{lost} values are spoiled");
        let devices = every_device();
        for ((name, renderer), varies) in devices.iter().flat_map(|on| [(on, 0), (on, 1)]) {
            let device = renderer.device();
            let [clean, other] = [&gradient, &spoiled]
                .map(|gradient| composite_backward(device, (splat, varies), side, gradient));
            assert!(clean.iter().all(|value| value.is_finite()) && clean[0] != Vec4::ZERO);
            assert_eq!(clean, other, "side {side} on {name}");
        }
    }
}
