//! Gaussians distributed over ranks: the same image and the same gradients for any number of ranks.

use organza::ranks::{Ranks, ThreadRanks};
use organza::render::shard_bytes;
use organza::scene::{GAUSSIANS_PER_BLOCK, Scene, SceneShard};
use organza::{Camera, Renderer, TileBatch, UploadOptions, demo};
use organza_tests::compare::bits;
use organza_tests::devices;

/// Copies of the built-in scene's Gaussians, slightly moved and more transparent: three blocks.
fn scene() -> Scene {
    let mut scene = demo::scene();
    let len = scene.gaussians.len();
    let indices: Vec<_> = (0..2 * GAUSSIANS_PER_BLOCK + 100).map(|index| index % len).collect();
    scene.gaussians = scene.gaussians.select(&indices);
    for (index, position) in scene.gaussians.position.iter_mut().enumerate() {
        position[index % 3] += 1e-3 * (index / len) as f32;
    }
    scene.gaussians.opacity.iter_mut().for_each(|logit| *logit -= 3.0);
    // Most of the time would go into samples.
    scene.config.step *= 8.0;
    scene
}

fn batch(cameras: &[Camera]) -> TileBatch {
    TileBatch::cover(0, cameras[0].width, cameras[0].height, 8).expect("tiles")
}

/// The results of ranks.
#[derive(PartialEq)]
struct Found {
    /// Bits of the image, `[K, 3, S, S]`.
    image: Vec<u32>,
    /// Bits of each tensor's gradient. That of the Gaussians is in the order of the ranks.
    gradient: Vec<(String, Vec<u32>)>,
    /// Number of Gaussians of each rank.
    held: Vec<usize>,
}

/// The loss is half the sum of squares, so dL/dY is Y.
fn found(scene: &Scene, cameras: &[Camera], size: usize) -> Found {
    let all = ThreadRanks::run(size, |ranks| {
        let renderer = Renderer::new(devices::cpu(Some(1)));
        let shard = SceneShard::new(scene, ranks.rank(), ranks.size());
        let shard = renderer.upload_shard(&shard, UploadOptions::default()).expect("a shard");
        let recording = renderer.record_shard(&shard, cameras, &batch(cameras), &ranks);
        let recording = recording.expect("a recording");
        let tiles = recording.tiles().clone();
        assert_eq!(ranks.sent(), shard_bytes(tiles.count, tiles.side), "of {size}");
        let gradient = recording.backward(&tiles.data).expect("a gradient");
        let again = renderer.render_shard(&shard, cameras, &batch(cameras), &ranks).unwrap();
        assert!(bits(&again.data) == bits(&tiles.data), "of {size}");
        (tiles, gradient, shard.len())
    });
    let (tiles, ..) = &all[0];
    assert!(tiles.report.pairs > 1000, "{:?}", tiles.report);
    let mut gradient: Vec<(String, Vec<u32>)> = Vec::new();
    for (tiles, of_rank, _) in &all {
        assert!(bits(&tiles.data) == bits(&all[0].0.data), "ranks of {size} have other images");
        for (index, (spec, values)) in of_rank.tensors().into_iter().enumerate() {
            let values = bits(values);
            match gradient.get_mut(index) {
                None => gradient.push((spec.name, values)),
                Some((name, all)) if name.starts_with("gaussians.") => all.extend(values),
                Some((name, all)) => assert!(*all == values, "{name}: ranks of {size} differ"),
            }
        }
    }
    let held = all.iter().map(|(.., held)| *held).collect();
    Found { image: bits(&tiles.data), gradient, held }
}

#[test]
fn any_number_of_ranks_gives_the_same_image_and_gradient() {
    let scene = scene();
    let cameras = demo::turntable(1, 16);
    let one = found(&scene, &cameras, 1);
    assert_eq!(one.held, [scene.gaussians.len()]);
    for size in [2, 3, 4] {
        let of_many = found(&scene, &cameras, size);
        assert!(of_many.image == one.image, "the image of {size} ranks");
        for ((name, found), (_, expected)) in of_many.gradient.iter().zip(&one.gradient) {
            assert!(found == expected, "`{name}` of {size} ranks");
        }
        assert_eq!(of_many.held.contains(&0), size == 4, "{:?}", of_many.held);
    }
    let renderer = Renderer::new(devices::cpu(None));
    let uploaded = renderer.upload(&scene).expect("a scene");
    let whole = renderer.record(&uploaded, &cameras, &batch(&cameras)).expect("a recording");
    let image = &whole.tiles().data;
    for (found, expected) in one.image.iter().zip(image) {
        let found = f32::from_bits(*found);
        assert!((found - expected).abs() < 1e-5, "{found} {expected}");
    }
    let gradient = whole.backward(image).expect("a gradient");
    for ((name, found), (_, expected)) in one.gradient.iter().zip(gradient.tensors()) {
        let norm = |values: &mut dyn Iterator<Item = f32>| {
            values.map(|value| f64::from(value).powi(2)).sum::<f64>().sqrt()
        };
        let all = norm(&mut expected.iter().copied());
        let pairs = found.iter().zip(expected);
        let difference = norm(&mut pairs.map(|(found, value)| f32::from_bits(*found) - value));
        assert!(all > 0.0 && difference < 1e-4 * all, "`{name}`: {difference} of {all}");
    }
}
