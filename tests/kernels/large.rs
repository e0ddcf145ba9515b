//! Sizes beyond one dispatch, one workgroup or one invocation.

use glam::{Vec2, Vec4};
use organza_parity::exact::composite::Splat;
use organza_shaders::composite::{CompositeKernel, CompositeParams};
use organza_shaders::limits::MAX_MEMBERS;
use organza_shaders::scan::{BLOCK, ScanBlockKernel, ScanParams};
use organza_shaders::tile::Tile;
use organza_tests::devices;

/// Pseudo-random numbers in [0, 1).
fn noise(index: u32) -> f32 {
    let mut x = index.wrapping_add(1).wrapping_mul(0x9e37_79b9);
    x = (x ^ (x >> 16)).wrapping_mul(0x85eb_ca6b);
    x = (x ^ (x >> 13)).wrapping_mul(0xc2b2_ae35);
    ((x ^ (x >> 16)) >> 8) as f32 / (1 << 24) as f32
}

#[test]
fn a_tile_takes_more_members_than_one_dispatch() {
    const SIDE: u32 = 8;
    let members = 2 * MAX_MEMBERS + 777;
    let splats: Vec<Vec4> = (0..members)
        .flat_map(|i| {
            let random = |k: u32| noise(i * 8 + k);
            let placed = Vec4::new(random(0) * 16.0 - 4.0, random(1) * 16.0 - 4.0, random(2), 1e9);
            [
                placed,
                Vec4::new(0.05, 0.01, 0.04, 1e9),
                Vec4::new(random(3), random(4), random(5), 0.0),
            ]
        })
        .collect();
    let exact = |pixel: Vec2| -> [f64; 4] {
        let mut sum = [0.0; 4];
        for splat in splats.as_chunks::<3>().0 {
            let term = Splat::of(splat).term(pixel.as_dvec2().to_array());
            sum.iter_mut().zip(term).for_each(|(sum, term)| *sum += term);
        }
        sum
    };
    for (backend, device) in devices::all() {
        let tile = device
            .upload("tile", &Tile { camera: 0, origin: [0, 0], output: 0 }.pack())
            .expect("memory");
        let tile_first = device.upload("first", &[0, members]).expect("memory");
        let member = device.upload("member", &(0..members).collect::<Vec<_>>()).expect("memory");
        let cells = device.upload("cells", &vec![u32::MAX; members as usize]).expect("memory");
        let splat = device.upload("splat", &splats).expect("memory");
        let sum = device.zeros("sum", (4 * SIDE * SIDE) as usize).expect("memory");
        for pass in 0..members.div_ceil(MAX_MEMBERS) {
            let params = CompositeParams { side: SIDE, skip: pass * MAX_MEMBERS };
            let kernel = CompositeKernel {
                params,
                tile: &tile,
                tile_first: &tile_first,
                member: &member,
                cells: &cells,
                splat: &splat,
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
fn a_block_scan_takes_every_size() {
    for (backend, device) in devices::all() {
        for count in
            [0, 1, 15, 16, 17, 63, 64, 1023, 1024, 1025, 3 * BLOCK - 1, 3 * BLOCK, 3 * BLOCK + 1]
        {
            let values: Vec<u32> = (0..count).map(|i| (noise(i) * 1000.0) as u32).collect();
            let value = device.upload("value", &values).expect("memory");
            let blocks = (count + 1).div_ceil(BLOCK);
            let prefix = device.zeros("prefix", count as usize + 1).expect("memory");
            // not zeros, because the sum of an empty block must be written, too
            let block_sum =
                device.upload("block sum", &vec![u32::MAX; blocks as usize]).expect("memory");
            let params = ScanParams { count };
            let kernel =
                ScanBlockKernel { params, value: &value, prefix: &prefix, block_sum: &block_sum };
            device.dispatch(&kernel, [blocks, 1, 1]).expect("it runs");
            let prefix = device.read(&prefix).expect("it ran");
            let block_sum = device.read(&block_sum).expect("it ran");
            for (block, sum) in block_sum.iter().enumerate() {
                let begin = block * BLOCK as usize;
                let end = values.len().min(begin + BLOCK as usize);
                let mut expected = 0;
                let last = (count as usize + 1).min(begin + BLOCK as usize);
                for (found, index) in prefix[begin..last].iter().zip(begin..) {
                    assert_eq!(*found, expected, "{count} values, at {index} on {backend}");
                    expected += values.get(index).copied().unwrap_or(0);
                }
                assert_eq!(
                    *sum,
                    values[begin.min(end)..end].iter().sum::<u32>(),
                    "block {block} of {count} on {backend}"
                );
            }
        }
    }
}
