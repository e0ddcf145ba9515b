//! The built-in scene.

use muslin_check::snapshot::picture::Montage;
use organza::demo::{scene, turntable};
use organza::{Image, TileBatch, metrics};

use crate::snapshots::{RENDERERS, SNAPSHOTS};

#[test]
fn scene_is_valid_and_without_warnings() {
    let scene = scene();
    scene.validate().expect("a valid scene");
    assert_eq!(scene.warnings(), Vec::<String>::new());
    assert!((15_000..36_000).contains(&scene.gaussians.len()), "{}", scene.gaussians.len());
}

#[test]
fn turntable_goes_around_once() {
    let cameras = turntable(24, 384);
    assert_eq!(cameras.len(), 24);
    for (frame, camera) in cameras.iter().enumerate() {
        camera.validate(frame).expect("a valid camera");
        let eye = camera.eye();
        assert!(
            (eye[0].hypot(eye[1]) - cameras[0].eye()[0].hypot(cameras[0].eye()[1])).abs() < 1e-9
        );
        assert_eq!((camera.width, camera.height), (384, 384));
    }
    assert_ne!(cameras[0], cameras[12]);
    assert!(turntable(0, 384).is_empty());
    assert_eq!(turntable(1, 64)[0].eye(), cameras[0].eye());
}

/// No pixel is out of range.
#[test]
fn the_picture_stays_the_same() {
    const SIDE: u32 = 96;
    let batch = TileBatch::cover(0, SIDE, SIDE, SIDE).expect("one tile");
    let montage = Montage { tiles: 1, side: SIDE as usize, columns: 1, scale: 2 };
    let text = "the built-in scene: a pearl hides what is behind it, gleams, and shows through two sheets of cloth";
    for (backend, renderer) in RENDERERS.iter() {
        let scene = renderer.upload(&scene()).expect("a valid scene");
        let tiles = renderer.render(&scene, &turntable(1, SIDE), &batch).expect("a picture");
        assert!(tiles.data.iter().all(|value| (0.0..=1.0).contains(value)));
        SNAPSHOTS.assert_picture(["built_in_picture", text], backend, &tiles.data, montage);
    }
}

/// The first command trains on small images, and the README's picture is large: the cloth is as sheer in both.
#[test]
fn small_images_are_large_ones_averaged_down() {
    let (_, renderer) = RENDERERS.iter().next().expect("a CPU");
    let on_device = renderer.upload(&scene()).expect("a valid scene");
    let image = |side: u32| -> Image {
        renderer.render_view(&on_device, &turntable(1, side).remove(0)).expect("a picture")
    };
    let numbers = |image: &Image| -> Vec<[f32; 3]> {
        image.pixels().iter().map(|pixel| pixel.map(|channel| f32::from(channel) / 255.0)).collect()
    };
    let small = numbers(&image(128));
    let large = numbers(&image(512));
    let mean = |at: usize| -> [f32; 3] {
        let first = at / 128 * 4 * 512 + at % 128 * 4;
        let square = (0..16).map(|of| large[first + of / 4 * 512 + of % 4]);
        square.fold([0.0; 3], |sum, pixel| std::array::from_fn(|i| sum[i] + pixel[i] / 16.0))
    };
    let averaged: Vec<_> = (0..small.len()).map(mean).collect();
    let alike = metrics::psnr(&small, &averaged, None).expect("pixels");
    assert!(alike > 36.0, "{alike} dB");
}
