//! A recorded batch against one that is rendered again for its gradient, and scenes that change after a tape was made.

use super::{all_devices, some, tiles};
use crate::{DeviceScene, Renderer, SceneGradient, Tape, UploadOptions};
use organza_core::{Channel, Gradient, Scene, demo};

/// One part for all tiles, and one part per tile, which are more parts than a tape keeps.
const PART_BYTES: [u64; 2] = [512 << 20, 1];

/// Any dL/dY.
fn slopes(values: usize) -> Vec<f32> {
    (0..values).map(|at| (at as f32 * 0.37).sin()).collect()
}

/// The bits of every value.
fn bits(gradient: &Gradient) -> Vec<Vec<u32>> {
    let values = gradient.tensors().into_iter();
    values.map(|(_, values)| values.iter().map(|value| value.to_bits()).collect()).collect()
}

/// The gradient of a batch without a tape: each part is dropped after its backward pass.
fn rendered_again(renderer: &Renderer, scene: &DeviceScene, slopes: &[f32]) -> Gradient {
    let device = renderer.device();
    let gradient = SceneGradient::new(scene.device(), scene).expect("memory");
    let cameras = demo::turntable(2, 64);
    let batch = batch();
    renderer.add_gradient(scene, &cameras, &batch, slopes, &gradient).expect("a gradient");
    gradient.download(device, scene.config(), scene.len()).expect("a gradient")
}

fn batch() -> organza_core::TileBatch {
    let mut batch = tiles();
    batch.tiles.push(organza_core::Tile { camera: 0, origin: [30, 9] });
    batch
}

fn record(renderer: &Renderer, scene: &DeviceScene) -> organza_core::Result<Tape> {
    renderer.record(scene, &demo::turntable(2, 64), &batch())
}

#[test]
fn a_tape_has_the_bits_of_rendering_and_of_rendering_again() {
    for device in all_devices().into_iter().take(2) {
        let renderer = Renderer::new(device);
        for bytes in PART_BYTES {
            let renderer = renderer.clone().with_part_bytes(bytes);
            let what = format!("{}, parts of {bytes} bytes", renderer.device().choice());
            let scene = renderer.upload(&some()).expect("a scene");
            let tape = record(&renderer, &scene).expect("a tape");
            let cameras = demo::turntable(2, 64);
            let expected = renderer.render(&scene, &cameras, &batch()).expect("tiles");
            assert!(*tape.tiles() == expected, "{what}");
            assert_eq!(expected.report.parts, if bytes == 1 { 5 } else { 1 });

            let channels = [Channel::Alpha, Channel::Depth];
            let beside = renderer.record_channels(&scene, &cameras, &batch(), &channels);
            let ignore = &mut |_, _| {};
            let all = renderer.render_channels(&scene, &cameras, &batch(), &channels, ignore);
            assert!(*beside.expect("a tape").tiles() == all.expect("tiles"), "{what}");

            let slopes = slopes(expected.data.len());
            let expected = bits(&rendered_again(&renderer, &scene, &slopes));
            let kept = SceneGradient::new(scene.device(), &scene).expect("memory");
            let mut tape = tape;
            let found = tape.backward(&slopes).expect("a gradient");
            assert!(bits(&found) == expected, "{what}");
            for round in 0..2 {
                tape.backward_into(&kept, &slopes).expect("a gradient");
                let found = kept.download(renderer.device(), scene.config(), scene.len());
                assert!(bits(&found.expect("values")) == expected, "{what}: kept, round {round}");
                // the second round renders again
                tape.release();
            }
            let position = kept.tensors().gaussians.position.read(renderer.device());
            let found: Vec<u32> = position.expect("values").iter().map(|v| v.to_bits()).collect();
            assert!(found == expected[0] && found.iter().any(|&bits| bits != 0), "{what}");
        }
    }
}

/// The derivative by the last bias of T's network, for any length of T's steps.
#[test]
fn longer_steps_have_gradients_of_their_own() {
    const STEP: f32 = 0.02;
    let renderer = Renderer::new(all_devices().remove(0));
    let mut scene = some();
    scene.config.step /= 4.0;
    let loss = |shift: f32, ray_steps| {
        let mut moved = scene.clone();
        moved.transmittance.network.layers.last_mut().expect("a layer").bias[0] += shift;
        let moved = renderer.upload(&moved).expect("a scene").with_ray_steps(ray_steps);
        let tiles = record(&renderer, &moved).expect("a tape").tiles().data.clone();
        let slopes = slopes(tiles.len());
        tiles.iter().zip(slopes).map(|(&y, slope)| f64::from(y) * f64::from(slope)).sum::<f64>()
    };
    let mut found = Vec::new();
    for ray_steps in [1, 2, 4] {
        let uploaded = renderer.upload(&scene).expect("a scene").with_ray_steps(ray_steps);
        let tape = record(&renderer, &uploaded).expect("a tape");
        let slopes = slopes(tape.tiles().data.len());
        let gradient = tape.backward(&slopes).expect("a gradient");
        let slope = gradient.transmittance.network.layers.last().expect("a layer").bias[0];
        let difference = (loss(STEP, ray_steps) - loss(-STEP, ray_steps)) / f64::from(2.0 * STEP);
        let error = (f64::from(slope) - difference).abs();
        assert!(error < 2e-3 * difference.abs(), "{ray_steps}: {slope} {difference}");
        found.push(slope);
    }
    assert!(found[0] != found[1] && found[1] != found[2], "{found:?}");
}

#[test]
fn parts_are_given_up_where_memory_ends() {
    // one that counts on the host, and one that counts on the device
    for device in all_devices().into_iter().take(2) {
        let renderer = Renderer::new(device).with_part_bytes(1);
        let device = renderer.device();
        let scene = renderer.upload(&some()).expect("a scene");
        let tape = record(&renderer, &scene).expect("a tape");
        let slopes = slopes(tape.tiles().data.len());
        let expected = bits(&tape.backward(&slopes).expect("a gradient"));
        let mut survived = 0;
        for number in [20, 60, 90, 130, 300] {
            device.refuse_one(number);
            let found = record(&renderer, &scene);
            let was_refused = !device.refuse_one(0);
            match found {
                Ok(found) => {
                    assert!(found.tiles() == tape.tiles(), "buffer {number}");
                    let found = found.backward(&slopes).expect("a gradient");
                    assert!(bits(&found) == expected, "buffer {number}");
                    survived += u32::from(was_refused);
                }
                Err(error) => assert!(error.is_out_of_memory(), "{error}"),
            }
            device.refuse_one(number);
            let found = tape.backward(&slopes);
            let was_refused = !device.refuse_one(0);
            match found {
                Ok(found) => {
                    assert!(bits(&found) == expected, "buffer {number}, backward");
                    survived += u32::from(was_refused);
                }
                Err(error) => assert!(error.is_out_of_memory(), "{error}"),
            }
        }
        assert!(survived >= 2, "{}: {survived}", device.choice());
    }
}

/// A scene of the same shapes with other values.
fn other(scene: &Scene) -> Scene {
    let mut other = scene.clone();
    for (index, (_, values)) in other.tensors_mut().into_iter().enumerate() {
        for (at, value) in values.iter_mut().enumerate() {
            *value = 0.9 * *value + 0.01 * ((at + index) as f32).sin();
        }
    }
    other
}

#[test]
fn a_scene_that_is_written_to_is_the_scene_that_was_written() {
    let scene = some();
    let other = other(&scene);
    for device in all_devices() {
        let renderer = Renderer::new(device);
        let device = renderer.device();
        let written = renderer.upload(&scene).expect("a scene");
        let tape = record(&renderer, &written).expect("a tape");
        for (spec, values) in other.tensors() {
            written.write(device, &spec.name, values).expect("a tensor");
        }
        assert!(written.download(device).expect("a scene") == other, "{}", device.choice());
        let expected = renderer.upload(&other).expect("a scene");
        let [found, expected] =
            [&written, &expected].map(|scene| record(&renderer, scene).expect("a tape"));
        assert!(found.tiles() == expected.tiles(), "{}", device.choice());
        assert!(found.tiles() != tape.tiles(), "{}", device.choice());

        let slopes = slopes(found.tiles().data.len());
        let [found, expected] = [&found, &expected].map(|r| r.backward(&slopes).expect("values"));
        assert!(bits(&found) == bits(&expected), "{}", device.choice());
        let text = tape.backward(&slopes).unwrap_err().to_string();
        assert!(text.contains("written to since") && text.contains("record it again"), "{text}");
    }
}

#[test]
fn bad_tensors_and_half_grids_are_refused() {
    let host = some();
    let renderer = Renderer::new(super::devices::cpu(Some(2)));
    let device = renderer.device();
    let scene = renderer.upload(&host).expect("a scene");
    let refused = |name: &str, values: &[f32], expected: &str| {
        let text = scene.write(device, name, values).unwrap_err().to_string();
        assert!(text.contains(expected), "{text}");
    };
    refused("color.mlp", &[], "no tensor `color.mlp`, only gaussians.position");
    refused("gaussians.position", &[1.0], "has shape [1], expected");
    refused("color.mlp.0.bias", &[1.0], "has shape [1], expected");
    refused("gaussians.opacity", &vec![f32::NAN; scene.len()], "NaN at flat index 0");
    assert!(scene.download(device).expect("a scene") == host);

    let tape = record(&renderer, &scene).expect("a tape");
    let text = tape.backward(&[1.0]).unwrap_err().to_string();
    assert!(text.contains("has 1 values, but the batch is [5, 3, 16, 16]"), "{text}");
    let options = UploadOptions { half_grids: true };
    let halves = renderer.upload_with(&host, options).expect("a scene");
    for error in [
        record(&renderer, &halves).map(drop).unwrap_err(),
        halves.write(device, "color.grid", &host.color.grid).unwrap_err(),
    ] {
        assert!(error.to_string().contains("halves"), "{error}");
    }
}
