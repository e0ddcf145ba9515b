//! An image has the same bits for every cut into tiles, and for any number of threads.

use organza::{Camera, DeviceScene, Renderer, TileBatch};
use organza_tests::{cases, compare::bits, devices};

/// The whole image of a camera, `[3, height, width]`, from tiles with a given side.
pub fn image(
    renderer: &Renderer,
    scene: &DeviceScene,
    cameras: &[Camera],
    camera: usize,
    side: u32,
) -> Vec<f32> {
    let width = cameras[camera].width;
    let height = cameras[camera].height;
    let batch = TileBatch::cover(camera, width, height, side).expect("a batch");
    let tiles = renderer.render(scene, cameras, &batch).expect("it renders").data;
    let width = width as usize;
    let height = height as usize;
    let side = side as usize;
    let mut image = vec![0.0; 3 * width * height];
    let mut written = 0;
    for (tile, pixels) in batch.tiles.iter().zip(tiles.chunks_exact(3 * side * side)) {
        let [left, top] = tile.origin.map(|o| usize::try_from(o).expect("a tile in the image"));
        for channel in 0..3 {
            for (y, row) in (top..height.min(top + side)).enumerate() {
                for (x, column) in (left..width.min(left + side)).enumerate() {
                    image[(channel * height + row) * width + column] =
                        pixels[(channel * side + y) * side + x];
                    written += 1;
                }
            }
        }
    }
    assert_eq!(written, image.len(), "the tiles do not cover the image once");
    image
}

#[test]
fn the_image_does_not_depend_on_the_tiling() {
    cases::on_every_device(|backend, renderer, case, scene| {
        for camera in 0..case.cameras.len() {
            let whole = image(renderer, scene, &case.cameras, camera, 16);
            assert!(whole.iter().all(|value| value.is_finite()), "{} on {backend}", case.name);
            for side in [32, 50, 64] {
                let other = image(renderer, scene, &case.cameras, camera, side);
                let same = whole.iter().zip(&other).all(|(a, b)| a.to_bits() == b.to_bits());
                assert!(
                    same,
                    "{}, camera {camera}, tiles of 16 and of {side} differ on {backend}",
                    case.name
                );
            }
        }
    });
}

#[test]
fn the_image_does_not_depend_on_the_threads() {
    let renderers = [1, 2, 3].map(|threads| Renderer::new(devices::cpu(Some(threads))));
    for case in cases::all() {
        let tiles = renderers.each_ref().map(|renderer| {
            let scene = renderer.upload(&case.scene).expect("the scene fits");
            renderer.render(&scene, &case.cameras, &case.tiles).expect("it renders").data
        });
        let bits = tiles.map(|tiles| bits(&tiles));
        assert!(
            bits[0] == bits[1] && bits[0] == bits[2],
            "{}: the number of threads shows",
            case.name
        );
    }
}

#[test]
fn a_batch_in_parts_is_the_batch() {
    cases::on_every_device(|backend, renderer, case, scene| {
        let in_parts = renderer.clone().with_part_bytes(1);
        let whole = renderer.render(scene, &case.cameras, &case.tiles).expect("it renders");
        let parts = in_parts.render(scene, &case.cameras, &case.tiles).expect("it renders");
        assert_eq!((whole.report.parts, parts.report.parts), (1, case.tiles.tiles.len()));
        assert_eq!(whole.report.intersections, parts.report.intersections);
        assert!(whole.data == parts.data, "{}: the parts show on {backend}", case.name);
    });
}
