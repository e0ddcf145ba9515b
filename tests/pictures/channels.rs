//! Depth, alpha, visibility and normal in the cases of the float64 reference, on every device. They are compared with
//! the equations in f64, using the reference's transmittances.

use organza::render::Contributions;
use organza::{Camera, Channel, Renderer, Scene, Tile, TileBatch, demo};
use organza_parity::exact::channels::{depth, normal};
use organza_parity::exact::composite::{self, Splat};
use organza_parity::exact::numeric::dot;
use organza_parity::exact::project;
use organza_tests::cases::{self, Case};
use organza_tests::devices;

use crate::snapshots::{RENDERERS, exact};

/// Relative to the largest value of a channel. `reference_cases` allows an error of 1e-4 in the transmittances, and
/// so in the weights.
const TOLERANCE: f64 = 2e-4;

/// A Gaussian's contribution to each pixel of a camera.
pub struct VisibleSplat {
    pub gaussian: usize,
    pub splat: Splat<f64>,
    depth: f64,
    transmittance: f64,
    normal: [f64; 3],
}

impl VisibleSplat {
    /// Whether it ends so close to a place that rounding decides whether it counts.
    pub fn is_at_its_end(&self, place: [f64; 2]) -> bool {
        (self.splat.q(place) - project::cutoff()).abs() < 1e-3
    }
}

pub fn visible_splats(case: &Case, camera: usize) -> Vec<VisibleSplat> {
    let scene = &case.scene;
    let view = exact::view(&case.cameras[camera]);
    let transmittance = case.expected(&format!("stage.{camera}.transmittance"));
    let visible = |index: usize| {
        let projected = exact::project(scene, &case.cameras[camera], index)?;
        let gaussian = exact::gaussian(scene, index);
        let transmittance = f64::from(transmittance[index]);
        let normal = normal(&view, &gaussian);
        let to_camera = [0, 1, 2].map(|axis| view.eye[axis] - gaussian.position[axis]);
        assert!(dot(normal, to_camera) > 1e-5, "rounding decides on the side of Gaussian {index}");
        let logit = f64::from(scene.gaussians.opacity[index]);
        let conic = projected.conic();
        let compensation = match scene.config.antialiased {
            true => composite::compensation(conic, scene.config.blur),
            false => 1.0,
        };
        let shape = scene.gaussians.shape.get(index);
        let flatness = shape.map(|&shape| composite::flatness(shape.into()));
        Some(VisibleSplat {
            gaussian: index,
            splat: Splat {
                mean: projected.mean,
                weight: composite::weight(logit, transmittance) * compensation,
                conic,
                color: [0.0; 3],
                growth: None,
                flatness,
            },
            depth: depth(&view, &gaussian),
            transmittance,
            normal,
        })
    };
    (0..scene.gaussians.len()).filter_map(visible).collect()
}

/// The channels of a pixel: depth, alpha, visibility and the normal's components. `None` if a Gaussian ends so close
/// that rounding decides whether it counts.
fn pixel(visible_splats: &[VisibleSplat], place: [f64; 2]) -> Option<[f64; 6]> {
    let mut sum = [0.0; 6];
    for visible in visible_splats {
        if visible.is_at_its_end(place) {
            return None;
        }
        let [.., alpha] = visible.splat.term(place);
        let [x, y, z] = visible.normal;
        let values = [visible.depth, 1.0, visible.transmittance, x, y, z];
        sum.iter_mut().zip(values).for_each(|(sum, value)| *sum += alpha * value);
    }
    let [depth, alpha, visibility, x, y, z] = sum;
    if alpha == 0.0 {
        return Some([0.0; 6]);
    }
    let length = (x * x + y * y + z * z).sqrt();
    Some([depth / alpha, alpha, visibility / alpha, x / length, y / length, z / length])
}

#[test]
fn channels_match_the_equations() {
    // over all cases: pixels without a Gaussian, with S up to 1, and above
    let mut kinds = [0; 3];
    let cases: Vec<_> = cases::all();
    let expected: Vec<Vec<_>> = cases
        .iter()
        .map(|case| {
            let cameras: Vec<_> =
                (0..case.cameras.len()).map(|camera| visible_splats(case, camera)).collect();
            let side = case.tiles.side as usize;
            let pixels = case.tiles.tiles.iter().flat_map(|tile| {
                let visible_splats = &cameras[tile.camera];
                let [left, top] = tile.origin.map(|origin| f64::from(origin) + 0.5);
                (0..side * side).map(move |at| {
                    pixel(visible_splats, [left + (at % side) as f64, top + (at / side) as f64])
                })
            });
            pixels.collect()
        })
        .collect();
    for pixel in expected.iter().flatten().flatten() {
        kinds[if pixel[1] == 0.0 { 0 } else { 1 + usize::from(pixel[1] > 1.0) }] += 1;
    }
    let all: usize = expected.iter().map(Vec::len).sum();
    let compared: usize = kinds.iter().sum();
    assert!(kinds.iter().all(|&pixels| pixels > 20), "{kinds:?}");
    assert!(10 * compared > 9 * all, "{compared} of {all} pixels are compared");

    cases::on_every_device(|backend, renderer, case, scene| {
        let of = cases.iter().position(|other| other.name == case.name).unwrap();
        let cameras = &case.cameras;
        let batch = &case.tiles;
        let tiles = renderer
            .render_channels(scene, cameras, batch, &Channel::ALL, &mut |_, _| {})
            .expect("it renders");
        let plain = renderer.render(scene, cameras, batch).expect("it renders");
        assert_eq!(tiles.data, plain.data, "{}: colors on {backend}", case.name);
        let area = (batch.side * batch.side) as usize;
        let mut first = 0;
        for channel in Channel::ALL {
            let found = &tiles.channels[&channel];
            let planes = channel.planes();
            assert_eq!(found.len(), batch.tiles.len() * planes * area);
            let pixels = expected[of].iter().enumerate();
            let known = pixels.filter_map(|(at, pixel)| pixel.as_ref().map(|pixel| (at, pixel)));
            let values = known.flat_map(|(at, pixel)| {
                let place = move |plane: usize| ((at / area) * planes + plane) * area + at % area;
                (0..planes).map(move |plane| (place(plane), pixel[first + plane]))
            });
            let values: Vec<_> = values.collect();
            let largest = values.iter().map(|(_, exact)| exact.abs()).fold(0.0, f64::max);
            let name = format!("{} of {} on {backend}", channel.name(), case.name);
            let mut worst = 0.0_f64;
            for (at, exact) in values {
                let apart = (f64::from(found[at]) - exact).abs() / largest;
                assert!(apart <= TOLERANCE, "{name}: {} for {exact} at {at}", found[at]);
                worst = worst.max(apart);
            }
            println!("{name}: {worst:.1e} of {largest:.3}");
            first += planes;
        }
    });
}

/// Channels depend neither on the cut of an image into tiles, nor on the other channels of the request.
#[test]
fn channels_are_the_same_bits_however_they_are_cut() {
    cases::on_every_device(|backend, renderer, case, scene| {
        if case.name != "basic" {
            return;
        }
        let Camera { width, height, .. } = case.cameras[0];
        let mut images = Vec::new();
        for (side, renderer) in [(16, renderer.clone()), (13, renderer.clone().with_part_bytes(1))]
        {
            let batch = TileBatch::cover(0, width, height, side).unwrap();
            for channels in [&Channel::ALL[..], &[Channel::Normal]] {
                let tiles = renderer
                    .render_channels(scene, &case.cameras, &batch, channels, &mut |_, _| {})
                    .unwrap();
                let mut image =
                    organza::image::ChannelImage::new(Channel::Normal, width, height).unwrap();
                image.paste(&batch, &tiles).unwrap();
                images.push(image);
            }
        }
        assert!(images[0].values().iter().any(|&value| value != 0.0));
        assert!(images.iter().all(|image| *image == images[0]), "on {backend}");
    });
}

/// If there is only background, all channels are 0, without a division by 0.
#[test]
fn pixels_without_a_gaussian_are_zero() {
    cases::on_every_device(|backend, renderer, case, scene| {
        let tiles = vec![Tile { camera: 0, origin: [900_000, 900_000] }];
        let batch = TileBatch { side: 8, tiles };
        let rendered = renderer
            .render_channels(scene, &case.cameras, &batch, &Channel::ALL, &mut |_, _| {})
            .unwrap();
        for (channel, values) in rendered.channels {
            assert!(values.iter().all(|&value| value == 0.0), "{} on {backend}", channel.name());
        }
    });
}

/// A GPU may take numbers below 1.2e-38 for 0. Pixels with such weights are empty on every device.
#[test]
fn pixels_of_nearly_no_weight_are_empty_on_every_device() {
    let mut case = Case::load(&cases::folder().join("basic"));
    // sigmoid(-92) = 1e-40, and exp(-60) = 1e-26 is far above every limit
    for (index, opacity) in case.scene.gaussians.opacity.iter_mut().enumerate() {
        *opacity = [-92.0, -60.0][index % 2];
    }
    let visible_splats = visible_splats(&case, 0);
    let Camera { width, height, .. } = case.cameras[0];
    let side = 16;
    let batch = TileBatch::cover(0, width, height, side).unwrap();
    let area = (side * side) as usize;
    let mut kinds = [0; 2];
    for (device, renderer) in devices::all().into_iter().chain(devices::cpus()) {
        let renderer = Renderer::new(renderer);
        let scene = renderer.upload(&case.scene).unwrap();
        let channels = Channel::ALL;
        let tiles = renderer
            .render_channels(&scene, &case.cameras, &batch, &channels, &mut |_, _| {})
            .unwrap();
        for (tile, at) in
            (0..batch.tiles.len()).flat_map(|tile| (0..area).map(move |at| (tile, at)))
        {
            let [left, top] = batch.tiles[tile].origin.map(|origin| f64::from(origin) + 0.5);
            let place = [left + (at % 16) as f64, top + (at / 16) as f64];
            let Some([depth, alpha, ..]) = pixel(&visible_splats, place) else { continue };
            let found = |channel: Channel, plane: usize| {
                tiles.channels[&channel][(tile * channel.planes() + plane) * area + at]
            };
            if alpha < 1e-31 {
                for channel in channels {
                    let is_empty = (0..channel.planes()).all(|plane| found(channel, plane) == 0.0);
                    assert!(is_empty, "{channel:?} at an alpha of {alpha:e} on {device}");
                }
                kinds[0] += usize::from(alpha > 0.0);
            } else if alpha > 1e-29 {
                let apart = (f64::from(found(Channel::Depth, 0)) - depth).abs();
                assert!(apart <= TOLERANCE * depth, "an alpha of {alpha:e} on {device}");
                kinds[1] += 1;
            }
        }
    }
    assert!(kinds.iter().all(|&pixels| pixels > 20), "{kinds:?}");
}

// Contributions of Gaussians to whole views: compared with the equations in f64, and with a scene whose weights are known.

/// The sum of `alpha / max(S, 1)` over a camera's pixels, for each splat; and how far it may be off, because of pixels at
/// which rounding decides whether the splat counts.
fn by_equations(visible_splats: &[VisibleSplat], camera: &Camera) -> Vec<[f64; 2]> {
    let mut sums = vec![[0.0; 2]; visible_splats.len()];
    for at in 0..camera.width * camera.height {
        let place = [at % camera.width, at / camera.width].map(|x| f64::from(x) + 0.5);
        let alphas: Vec<_> =
            visible_splats.iter().map(|visible| visible.splat.term(place)[3]).collect();
        let max = alphas.iter().sum::<f64>().max(1.0);
        let is_near = |visible: &VisibleSplat| visible.is_at_its_end(place);
        let unsure = visible_splats.iter().filter(|visible| is_near(visible));
        let unsure: f64 = unsure.map(|visible| visible.splat.weight / 255.0).sum();
        for ((sum, visible), alpha) in sums.iter_mut().zip(visible_splats).zip(alphas) {
            sum[0] += alpha / max;
            // another splat that counts or not changes S
            sum[1] += alpha / max * unsure;
            sum[1] += if is_near(visible) { visible.splat.weight / 255.0 } else { 0.0 };
        }
    }
    sums
}

/// A Gaussian's contribution to a camera's pixels, and how far it may be off: see [`by_equations`].
fn expected(case: &Case, camera: usize) -> Vec<[f64; 2]> {
    let visible_splats = visible_splats(case, camera);
    let mut expected = vec![[0.0; 2]; case.scene.gaussians.len()];
    for (visible, sum) in
        visible_splats.iter().zip(by_equations(&visible_splats, &case.cameras[camera]))
    {
        expected[visible.gaussian] = sum;
    }
    expected
}

#[test]
fn contributions_match_the_equations() {
    // The equations take longer than the devices, so each case has its values once.
    let cases = cases::all();
    let expected: Vec<Vec<_>> = cases
        .iter()
        .map(|case| (0..case.cameras.len()).map(|camera| expected(case, camera)).collect())
        .collect();
    for (backend, renderer) in RENDERERS.iter() {
        for (case, expected) in cases.iter().zip(&expected) {
            let scene = renderer.upload(&case.scene).expect("the scene fits");
            for (view, expected) in case.cameras.iter().zip(expected) {
                let mut found = Contributions::new(scene.len());
                renderer.add_contributions(&scene, view, None, &mut found).expect("it renders");
                check(&format!("{} on {backend}", case.name), &found, expected);
            }
        }
    }
}

fn check(what: &str, found: &Contributions, expected: &[[f64; 2]]) {
    for (gaussian, [sum, unsure]) in expected.iter().enumerate() {
        let pixels = found.pixels(gaussian);
        assert!(
            (pixels - sum).abs() <= TOLERANCE * sum + unsure,
            "{what}: Gaussian {gaussian} contributes {pixels}, not {sum}"
        );
    }
}

/// Two cameras look at a wall from both ends of a corridor. Haze hangs before the eye of the first.
fn corridor() -> (Scene, [Camera; 2]) {
    let mut scene = Scene::zeros(demo::config(), 3).unwrap();
    // all light passes
    scene.transmittance.network.layers.last_mut().unwrap().bias[0] = 50.0;
    let gaussians = &mut scene.gaussians;
    // the wall, haze near the first camera, and what lies behind the wall for the first
    gaussians.position = vec![[0.0, 0.0, 4.0], [0.0, 0.0, 1.0], [0.0, 0.0, 5.0]];
    gaussians.rotation.fill([1.0, 0.0, 0.0, 0.0]);
    // so large that falloff is 1 in the middle
    gaussians.log_scale = vec![[9.0, 9.0, -9.0]; 3];
    let weights: [f32; 3] = [0.9, 0.5, 0.2];
    gaussians.opacity = weights.map(|weight| (weight / (1.0 - weight)).ln()).to_vec();
    let up = [0.0, 1.0, 0.0];
    let camera = |z, to| Camera::look_at([0.0, 0.0, z], [0.0, 0.0, to], up, 0.5, [20, 12]).unwrap();
    (scene, [camera(0.0, 4.0), camera(4.5, 5.0)])
}

#[test]
fn floaters_are_in_front_of_surfaces_and_not_needed() {
    for (backend, renderer) in RENDERERS.iter() {
        let (scene, [first, second]) = corridor();
        let background = scene.config.background;
        let scene = renderer.upload(&scene).unwrap();
        let mut found = Contributions::new(3);
        renderer.add_contributions(&scene, &first, Some(&|_| None), &mut found).unwrap();
        let close = |found: f64, expected: f64| {
            assert!((found - expected).abs() < 1e-4 * expected.max(1.0), "{backend}: {found}");
        };
        // S is 1.6 everywhere, and the view has 240 pixels
        close(found.pixels(0), 240.0 * 0.9 / 1.6);
        close(found.pixels(1), 240.0 * 0.5 / 1.6);
        close(found.pixels(2), 240.0 * 0.2 / 1.6);
        // the views that could see the wall, the haze, and what is behind the wall; and those that see through it
        let views = |found: &Contributions| [0, 1, 2].map(|i| found.views(i));
        assert_eq!(views(&found), [[1.0, 0.0], [1.0, 1.0], [0.0, 0.0]], "{backend}");
        // without the haze, nothing is open; without the wall, too, a part of 0.8; then the rest
        let [wall, behind] = [0.9, 0.2].map(|weight| weight / 1.6);
        assert_eq!(found.need(1), 0.0, "{backend}");
        close(found.need(0), (0.5_f64 * 0.8).powi(2) / wall);
        close(found.need(2), (0.5_f64 * 0.2).powi(2) / behind);
        // a wall that one view sees is no floater
        assert_eq!(found.floaters(0.9), [false, true, false], "{backend}");
        // only the last Gaussian is before the second camera, which sees more background
        renderer.add_contributions(&scene, &second, Some(&|_| None), &mut found).unwrap();
        close(found.pixels(0), 240.0 * 0.9 / 1.6);
        close(found.pixels(2), 240.0 * (0.2 / 1.6 + 0.2));
        assert_eq!(views(&found), [[1.0, 0.0], [1.0, 1.0], [1.0, 1.0]], "{backend}");
        // all are gray; without the wall, the background shows
        let photograph = [0.2, 0.5, 0.9];
        let mut found = Contributions::new(3);
        renderer
            .add_contributions(&scene, &first, Some(&|_| Some(photograph)), &mut found)
            .unwrap();
        let rise = |channel: usize| {
            let error = |color: f64| (color - photograph[channel]).powi(2);
            error(0.2 * 0.5 + 0.8 * background[channel]) - error(0.5)
        };
        close(found.need(0), (0..3).map(rise).sum::<f64>() / 3.0 / wall);
        close(found.need(1), 0.0);
        // without looking for floaters, nothing is known of them
        let mut found = Contributions::new(3);
        renderer.add_contributions(&scene, &first, None, &mut found).unwrap();
        assert_eq!(found.views(1), [0.0; 2]);
        close(found.pixels(1), 240.0 * 0.5 / 1.6);
    }
}

/// A floater in front makes another one the surface: the second look is without the first. And the trial is of what photographs are
/// closer without: the more suspicious floater leaves first, which acquits the other.
#[test]
fn floaters_hide_and_accuse_others() {
    // depths, weights, grays; what each look is at, and what is found
    let hidden: &[[f64; 3]] = &[[4.0, 0.9, 0.5], [1.0, 0.9, 0.5], [2.0, 0.5, 0.5]];
    let accused: &[[f64; 3]] =
        &[[4.0, 0.6, 0.5], [0.5, 0.3, 0.5], [1.0, 0.24, 0.9], [2.0, 0.05, 0.6]];
    let cases: [(_, &[&[usize]], &[usize]); 2] =
        [(hidden, &[&[0, 2]], &[1, 2]), (accused, &[&[0, 1, 2, 3], &[0, 1, 3]], &[2])];
    for (backend, renderer) in RENDERERS.iter() {
        for (gaussians, looks, floaters) in cases {
            let (scene, camera) = grays(gaussians);
            let mut found = Contributions::new(gaussians.len());
            let look = |chosen: &[usize], found: &mut Contributions| {
                let scene = Scene { gaussians: scene.gaussians.select(chosen), ..scene.clone() };
                let scene = renderer.upload(&scene).unwrap();
                let gray = |_| Some([0.5; 3]);
                renderer.add_contributions(&scene, &camera, Some(&gray), found).unwrap();
            };
            let all: Vec<_> = (0..gaussians.len()).collect();
            look(&all, &mut found);
            for expected in looks {
                assert_eq!(found.next_look().as_deref(), Some(*expected), "{backend}");
                look(expected, &mut found);
            }
            assert_eq!(found.next_look(), None, "{backend}");
            let found = found.floaters(0.3);
            let found: Vec<_> = all.into_iter().filter(|&i| found[i]).collect();
            assert_eq!(found, floaters, "{backend}");
        }
    }
}

/// Gaussians that fill the view of the first camera of [`corridor`], before white: depths, weights and grays.
fn grays(gaussians: &[[f64; 3]]) -> (Scene, Camera) {
    let (corridor, [camera, _]) = corridor();
    let mut scene =
        Scene { gaussians: corridor.gaussians.select(&vec![0; gaussians.len()]), ..corridor };
    scene.config.background = [1.0; 3];
    // the first unit of each layer passes on a logit from the material, behind four harmonics and four features
    let [first, second, last] = &mut scene.color.network.layers[..] else {
        panic!("two hidden layers")
    };
    first.weight[8] = 1.0;
    first.bias[0] = 8.0;
    second.weight[0] = 1.0;
    (0..3).for_each(|channel| last.weight[channel * last.inputs] = 1.0);
    last.bias.fill(-8.0);
    let material = scene.config.material as usize;
    let logit = |x: f64| (x / (1.0 - x)).ln() as f32;
    for (i, &[depth, weight, gray]) in gaussians.iter().enumerate() {
        scene.gaussians.position[i] = [0.0, 0.0, depth as f32];
        scene.gaussians.opacity[i] = logit(weight);
        scene.gaussians.material[i * material] = logit(gray);
    }
    (scene, camera)
}
