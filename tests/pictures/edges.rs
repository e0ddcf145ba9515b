//! Changes of single characters in the kernels that no other test detects: `docs/correctness.md`.

use glam::Vec2;
use organza::{Scene, Tile, TileBatch};
use organza_shaders::tile::reaches;
use organza_shaders::unit_cube::Split;
use organza_tests::cases::{self, Case};

use crate::snapshots::RENDERERS;

/// The reference's basic case, with its Gaussians repeated.
fn repeated(times: usize) -> (Case, Scene) {
    let case = Case::load(&cases::folder().join("basic"));
    let mut scene = case.scene.clone();
    let all: Vec<_> = (0..scene.gaussians.len()).collect();
    scene.gaussians = scene.gaussians.select(&all.repeat(times));
    (case, scene)
}

#[test]
fn scans_of_many_blocks_repeat_one_block() {
    // a block scans 1,024 counts
    let times = 50;
    let (case, scene) = repeated(times);
    assert!(scene.gaussians.len() > 2048);
    for (backend, renderer) in RENDERERS.iter() {
        let stages = |scene: &Scene| {
            let scene = renderer.upload(scene).expect("the scene fits");
            renderer.stages(&scene, &case.cameras[0]).expect("the stages run")
        };
        let one = stages(&case.scene);
        let many = stages(&scene);
        assert_eq!(many.sample_count, one.sample_count.repeat(times), "K on {backend}");
        assert_eq!(many.transmittance, one.transmittance.repeat(times), "T on {backend}");
    }
}

#[test]
fn intersections_of_many_blocks_repeat_one_block() {
    let times = 50;
    let (case, scene) = repeated(times);
    for (backend, renderer) in RENDERERS.iter() {
        let report = |scene: &Scene| {
            let scene = renderer.upload(scene).expect("the scene fits");
            renderer.render(&scene, &case.cameras, &case.tiles).expect("it renders").report
        };
        let one = report(&case.scene);
        let many = report(&scene);
        let times = times as u64;
        assert_eq!(
            [many.pairs, many.intersections, many.samples],
            [one.pairs, one.intersections, one.samples].map(|count| count * times),
            "on {backend}"
        );
    }
}

#[test]
fn only_degenerate_gaussians_are_counted() {
    let case = Case::load(&cases::folder().join("basic"));
    for (backend, renderer) in RENDERERS.iter() {
        let degenerate = |scene: &Scene| {
            let scene = renderer.upload(scene).expect("the scene fits");
            let tiles = renderer.render(&scene, &case.cameras, &case.tiles).expect("it renders");
            tiles.report.degenerate
        };
        assert_eq!(degenerate(&case.scene), 0, "on {backend}");
        let mut scene = case.scene.clone();
        // without a rotation: culled in every camera that has a tile
        scene.gaussians.rotation[3] = [0.0; 4];
        scene.gaussians.rotation[7] = [0.0; 4];
        let mut cameras: Vec<usize> = case.tiles.tiles.iter().map(|tile| tile.camera).collect();
        cameras.sort_unstable();
        cameras.dedup();
        let found = degenerate(&scene);
        let max = 2 * cameras.len() as u64;
        assert!(found > 0 && found <= max, "{found} of at most {max} on {backend}");
    }
}

/// A single tile has a small window. Many tiles have a window that leaves out almost nothing.
#[test]
fn intersections_do_not_depend_on_the_window() {
    let case = Case::load(&cases::folder().join("basic"));
    let corner = |at: i32| [8 * (at % 8) - 8, 8 * (at / 8) - 8];
    let tiles: Vec<_> = (0..64).map(|at| Tile { camera: 0, origin: corner(at) }).collect();
    for (backend, renderer) in RENDERERS.iter() {
        let scene = renderer.upload(&case.scene).expect("the scene fits");
        let intersections = |tiles: &[Tile]| {
            let batch = TileBatch { side: 8, tiles: tiles.to_vec() };
            renderer.render(&scene, &case.cameras, &batch).expect("it renders").report.intersections
        };
        let together = intersections(&tiles);
        let alone: u64 = tiles.iter().map(|&tile| intersections(&[tile])).sum();
        assert!(together > 0 && together == alone, "{together}, {alone} on {backend}");
    }
}

#[test]
fn a_gaussian_that_touches_a_tile_intersects_it() {
    for step in 1..200 {
        let radius = step as f32 * 0.25;
        for center in [
            Vec2::new(-radius, 3.0),
            Vec2::new(8.0 + radius, 3.0),
            Vec2::new(3.0, -radius),
            Vec2::new(3.0, 8.0 + radius),
        ] {
            assert!(reaches(center, radius, Vec2::ZERO, 8.0), "{radius} from {center}");
        }
    }
}

#[test]
fn the_faces_of_the_cube_are_in_it() {
    let clamped = |x| Split::new(x, 0.0).clamped();
    for (x, face) in [(1.0, 1.0), (1.5, 1.0), (0.0, 0.0), (-0.5, 0.0)] {
        assert_eq!((clamped(x).coarse, clamped(x).fine), (face, 0.0), "{x}");
    }
}
