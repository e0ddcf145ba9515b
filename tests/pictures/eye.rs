//! Values kept for one eye position, on every device: images must equal those rendered without them.

use organza::render::{EyeCache, EyeOptions};
use organza::{Camera, Channel, DeviceScene, RenderedTiles, Renderer, TileBatch, demo};
use organza_tests::compare::bits;
use organza_tests::{cases, devices};

/// The image of a camera in tiles of 16 pixels.
pub fn whole(camera: &Camera) -> TileBatch {
    TileBatch::cover(0, camera.width, camera.height, 16).expect("tiles")
}

pub const EXACT: EyeOptions<'_> = EyeOptions {
    channels: &Channel::ALL,
    steps: 1,
    renewed: None,
    background: None,
    is_cancelled: &|| false,
};

/// The image of a camera, with nothing kept from before.
pub fn render_anew(
    renderer: &Renderer,
    scene: &DeviceScene,
    camera: &Camera,
    options: &EyeOptions<'_>,
) -> RenderedTiles {
    let mut cache = EyeCache::default();
    let tiles = renderer.render_from_eye(scene, camera, &whole(camera), &mut cache, options);
    tiles.expect("an image").expect("it was not cancelled")
}

#[test]
fn a_cache_keeps_the_bits_of_images() {
    cases::on_every_device(|device, renderer, case, scene| {
        let mut cache = EyeCache::default();
        let mut render = |camera: &Camera, options: &EyeOptions<'_>| {
            let tiles =
                renderer.render_from_eye(scene, camera, &whole(camera), &mut cache, options);
            tiles.expect("an image").expect("it was not cancelled")
        };
        let first = &case.cameras[0];
        let [right, up, back] = [0, 1, 2].map(|at| first.camera_to_world.map(|row| row[at]));
        let mut turned = first.clone();
        for row in 0..3 {
            // a quarter turn around the camera's own axis, and closer
            turned.camera_to_world[row][0] = up[row];
            turned.camera_to_world[row][1] = -right[row];
            turned.camera_to_world[row][2] = back[row];
        }
        turned.fl_x = 1.5 * first.fl_x;
        turned.fl_y = 1.4 * first.fl_y;
        let larger = first.with_size([first.width * 2, first.height + 7]);
        let all = [first, &turned, &larger, &case.cameras[1], first];
        for (index, camera) in all.into_iter().enumerate() {
            // first coarsely, as during camera motion
            render(camera, &EyeOptions { steps: 7, ..EXACT });
            let found = render(camera, &EXACT);
            let cameras = std::slice::from_ref(camera);
            let batch = whole(camera);
            let expected: RenderedTiles = renderer
                .render_channels(scene, cameras, &batch, &Channel::ALL, &mut |_, _| {})
                .expect("an image");
            let what = format!("{device}, {}: camera {index}", case.name);
            assert!(bits(&found.data) == bits(&expected.data), "{what}");
            for (channel, values) in &expected.channels {
                assert!(bits(&found.channels[channel]) == bits(values), "{what}: {channel:?}");
            }
            assert_eq!(found.report.pairs, expected.report.pairs, "{what}");
            // samples that are known must not be computed again
            assert_eq!(render(camera, &EXACT).report.samples, 0, "{what}");
        }
    });
}

/// With longer steps, T has fewer samples: it must be close to the exact one, and equal in a constant field.
#[test]
fn long_steps_change_little() {
    cases::on_every_device(|device, renderer, case, scene| {
        let camera = &case.cameras[0];
        let render = |steps| {
            render_anew(renderer, scene, camera, &EyeOptions { channels: &[], steps, ..EXACT })
        };
        let exact = render(1);
        let coarse = render(4);
        let apart = exact.data.iter().zip(&coarse.data).map(|(a, b)| f64::from((a - b).abs()));
        let mean = apart.sum::<f64>() / exact.data.len() as f64;
        assert!(mean < 0.05, "{device}, {}: {mean}", case.name);
        let few = coarse.report.samples;
        let many = exact.report.samples;
        assert!(few < many || many < 8, "{device}, {}: {few} of {many} samples", case.name);
    });
}

/// The largest difference between the means of blocks of 8 x 8 pixels, in levels of 255. Tiles have 16 x 16 pixels.
fn levels_apart(found: &RenderedTiles, expected: &RenderedTiles) -> f64 {
    let block = |plane: &[f32], at: usize| {
        let corner = (at / 2) * 8 * 16 + (at % 2) * 8;
        let rows = (0..8).map(|row| &plane[corner + 16 * row..][..8]);
        rows.flatten().map(|value| f64::from(*value)).sum::<f64>() / 64.0
    };
    let planes = found.data.chunks_exact(256).zip(expected.data.chunks_exact(256));
    let differences =
        planes.flat_map(|(a, b)| (0..4).map(move |at| (block(a, at) - block(b, at)).abs()));
    255.0 * differences.fold(0.0, f64::max)
}

/// The viewer's steps while the camera moves: the built-in scene stays as opaque as it is.
#[test]
fn steps_of_two_sigma_keep_thin_surfaces() {
    let renderer = Renderer::new(devices::cpu(None));
    let scene = renderer.upload(&demo::scene()).expect("a scene");
    let camera = &demo::turntable(1, 128)[0];
    let render = |steps| {
        render_anew(&renderer, &scene, camera, &EyeOptions { channels: &[], steps, ..EXACT })
    };
    let exact = render(1);
    let apart = levels_apart(&render(2), &exact);
    assert!(apart < 10.0, "{apart} levels");
    // the measure can see it: longer steps make the pearl transparent
    assert!(levels_apart(&render(16), &exact) > 20.0);
}

/// Slow devices, while the camera goes once around in 20 seconds at ten images a second: the image stays within ten levels, and
/// when the camera rests, every bit is right again.
#[test]
fn values_of_the_last_images_stay_close() {
    let renderer = Renderer::new(devices::cpu(None));
    let scene = renderer.upload(&demo::scene()).expect("a scene");
    let cameras = &demo::turntable(200, 128)[..6];
    // The second has time for a quarter of the Gaussians and no more; the old values must not be in one place. The third has
    // time for few of them, but an image may come late.
    for (min, max, worst) in [(2, 2, 10.0), (4, 4, 15.0), (16, 1, 10.0)] {
        let mut cache = EyeCache::default();
        let mut render = |camera: &Camera, renewed| {
            let options = EyeOptions { channels: &[], steps: 2, renewed, ..EXACT };
            let batch = whole(camera);
            let tiles = renderer.render_from_eye(&scene, camera, &batch, &mut cache, &options);
            tiles.expect("an image").expect("it was not cancelled")
        };
        let renewed = Some([min, max].map(|part| scene.len() / part));
        let all = render(&cameras[0], None).report.samples;
        for camera in &cameras[1..5] {
            assert!(render(camera, renewed).report.samples < 2 * all / 3);
        }
        let last = &cameras[5];
        let moving = render(last, renewed);
        let expected = render_anew(&renderer, &scene, last, &EyeOptions { channels: &[], ..EXACT });
        let apart = levels_apart(&moving, &expected);
        assert!(apart < worst, "1/{min} to 1/{max}: {apart} levels");
        let rested = render(last, None);
        let options = EyeOptions { channels: &[], steps: 2, ..EXACT };
        assert!(bits(&rested.data) == bits(&render_anew(&renderer, &scene, last, &options).data));
    }
}

#[test]
fn a_full_cache_gives_an_image_after_cancelling() {
    cases::on_every_device(|device, renderer, case, scene| {
        let camera = &case.cameras[0];
        let mut cache = EyeCache::default();
        let batch = whole(camera);
        let cancelled = EyeOptions { is_cancelled: &|| true, ..EXACT };
        let tiles = renderer.render_from_eye(scene, camera, &batch, &mut cache, &cancelled);
        let what = format!("{device}, {}", case.name);
        assert!(tiles.expect("no error").is_none(), "{what}");
        let tiles = renderer.render_from_eye(scene, camera, &batch, &mut cache, &EXACT);
        assert!(tiles.expect("an image").is_some(), "{what}");
        // everything is known
        let tiles = renderer.render_from_eye(scene, camera, &batch, &mut cache, &cancelled);
        assert!(tiles.expect("an image").is_some(), "{what}");
    });
}

#[test]
fn another_background_is_where_weights_leave_room() {
    cases::on_every_device(|device, renderer, case, scene| {
        let camera = &case.cameras[0];
        let render = |background| {
            let options = EyeOptions { channels: &[Channel::Alpha], background, ..EXACT };
            render_anew(renderer, scene, camera, &options)
        };
        let own = case.scene.config.background;
        assert!(bits(&render(Some(own)).data) == bits(&render(None).data), "{device}");
        let black = render(Some([0.0; 3]));
        let white = render(Some([1.0; 3]));
        let area = 16 * 16;
        for (at, (black_at, white_at)) in black.data.iter().zip(&white.data).enumerate() {
            let tile = at / (3 * area);
            let pixel = at % area;
            let weight = black.channels[&Channel::Alpha][tile * area + pixel];
            let room = (1.0 - weight).max(0.0);
            let off = (white_at - black_at - room).abs();
            assert!(off < 1e-5, "{device}, {}: {off} at weight {weight}", case.name);
        }
    });
}

#[test]
fn a_pixels_gaussians_are_those_that_explain_lists() {
    cases::on_every_device(|device, renderer, case, scene| {
        for (index, camera) in case.cameras.iter().enumerate() {
            let count = renderer.count_gaussians(scene, camera).expect("a count");
            let width = camera.width as usize;
            let height = camera.height as usize;
            assert_eq!(count.len(), width * height);
            let max = (0..count.len()).max_by_key(|&at| count[at]).expect("pixels");
            assert!(count[max] > 0, "{device}, {}", case.name);
            for at in (0..count.len()).step_by(count.len() / 9 + 1).chain([max]) {
                let pixel = [(at % width) as i32, (at / width) as i32];
                let found = renderer.inspect(scene, &case.cameras, index, pixel).expect("a pixel");
                let gaussians = found.contributions.iter().filter(|one| one.falloff > 0.0).count();
                let what = format!("{device}, {}: pixel {pixel:?} of {index}", case.name);
                assert_eq!(count[at] as usize, gaussians, "{what}");
            }
        }
    });
}
