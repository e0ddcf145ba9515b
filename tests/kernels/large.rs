//! Sizes beyond one dispatch, one workgroup or one invocation, and counts of all invocations.

use glam::{Vec2, Vec3, Vec4};
use muslin_check::inputs::Random;
use organza_parity::exact::composite::Splat;
use organza_shaders::camera::Camera;
use organza_shaders::composite::{CompositeKernel, CompositeParams};
use organza_shaders::limits::MAX_INTERSECTIONS;
use organza_shaders::project::{EVERYWHERE, ProjectKernel, ProjectParams};
use organza_shaders::tile::Tile;
use organza_tests::devices;

#[test]
fn a_tile_takes_more_intersections_than_one_dispatch() {
    const SIDE: u32 = 8;
    let intersections = 2 * MAX_INTERSECTIONS + 777;
    let mut random = Random::new(1);
    let splats: Vec<Vec4> = (0..intersections)
        .flat_map(|_| {
            let [x, y] = [0; 2].map(|_| random.between(-4.0, 12.0));
            let color = Vec4::from_slice(&random.values(4, 0.0, 1.0));
            [Vec4::new(x, y, color.w, 1e9), Vec4::new(0.05, 0.01, 0.04, 1e9), color.with_w(0.0)]
        })
        .collect();
    let exact = |pixel: Vec2| -> [f64; 4] {
        let mut sum = [0.0; 4];
        for splat in splats.as_chunks::<3>().0 {
            let term: [f64; 4] = Splat::from_vectors(splat).term(pixel.as_dvec2().to_array());
            sum.iter_mut().zip(term).for_each(|(sum, term)| *sum += term);
        }
        sum
    };
    for (backend, device) in devices::all() {
        let tile = device
            .upload("tile", &Tile { camera: 0, origin: [0, 0], output: 0 }.pack())
            .expect("memory");
        let tile_first = device.upload("first", &[0, intersections]).expect("memory");
        let intersection =
            device.upload("intersection", &(0..intersections).collect::<Vec<_>>()).expect("memory");
        let cells =
            device.upload("cells", &vec![u32::MAX; intersections as usize]).expect("memory");
        let splat = device.upload("splat", &splats).expect("memory");
        let sum = device.zeros("sum", (4 * SIDE * SIDE) as usize).expect("memory");
        for pass in 0..intersections.div_ceil(MAX_INTERSECTIONS) {
            let skip = pass * MAX_INTERSECTIONS;
            let params = CompositeParams { side: SIDE, skip, sloped: 0, shaped: 0 };
            let kernel = CompositeKernel {
                params,
                tile: &tile,
                tile_first: &tile_first,
                intersection: &intersection,
                cells: &cells,
                splat: &splat,
                slope: &splat,
                sum: &sum,
            };
            device.run_over(&kernel, [SIDE, SIDE, 1]).expect("it runs");
        }
        let found: Vec<f32> = device.read(&sum).expect("it ran");
        for index in 0..SIDE * SIDE {
            let pixel = Vec2::new((index % SIDE) as f32 + 0.5, (index / SIDE) as f32 + 0.5);
            for (plane, exact) in exact(pixel).into_iter().enumerate() {
                let found = found[plane * (SIDE * SIDE) as usize + index as usize];
                // 33,545 terms: their rounding errors add up like a random walk
                assert!(
                    (f64::from(found) - exact).abs() <= 2e-5 * exact,
                    "{found} for {exact} at {pixel} on {backend}"
                );
            }
        }
    }
}

#[test]
fn every_invocation_counts_once() {
    const GAUSSIANS: u32 = 10_007;
    const CAMERAS: u32 = 3;
    let camera = Camera {
        rotation: [Vec3::X, Vec3::Y, Vec3::Z],
        eye: Vec3::new(0.0, 0.0, -5.0),
        focal: Vec2::splat(100.0),
        center: Vec2::splat(50.0),
        size: Vec2::splat(100.0),
    };
    // too large for f32: only one of three can be projected
    let log_scale: Vec<_> =
        (0..GAUSSIANS).flat_map(|i| [if i % 3 == 0 { -2.0 } else { 200.0 }; 3]).collect();
    let degenerate = CAMERAS * (0..GAUSSIANS).filter(|i| i % 3 != 0).count() as u32;
    let rotation = [1.0, 0.0, 0.0, 0.0].repeat(GAUSSIANS as usize);
    for (name, device) in devices::all() {
        let cameras = [camera.pack(); CAMERAS as usize].concat();
        let slots = (GAUSSIANS * CAMERAS) as usize;
        let counter = device.upload("degenerate", &[5_u32]).unwrap();
        let kernel = ProjectKernel {
            params: ProjectParams { gaussians: GAUSSIANS, blur: 0.3 },
            camera: &device.upload("camera", &cameras).unwrap(),
            window: &device.upload("window", &EVERYWHERE.repeat(CAMERAS as usize)).unwrap(),
            position: &device.zeros("position", 3 * GAUSSIANS as usize).unwrap(),
            rotation: &device.upload("rotation", &rotation).unwrap(),
            log_scale: &device.upload("log_scale", &log_scale).unwrap(),
            projection: &device.zeros("projection", 2 * slots).unwrap(),
            degenerate: &counter,
        };
        for round in 1..=4 {
            device.run(&kernel, GAUSSIANS, CAMERAS).unwrap();
            assert_eq!(device.read(&counter).unwrap(), [5 + round * degenerate], "{name}");
        }
    }
}
