//! One kernel in several sizes: a generic function, and a kernel for each size. docs/kernels.md shows one.

use muslin::prelude::*;
use muslin_check::{KernelRunner, devices};

/// Shape of the input.
#[params]
pub struct Shape {
    /// Height.
    pub rows: u32,
    /// Width.
    pub columns: u32,
}

/// `output [columns, rows]` is `input [rows, columns]`, transposed in tiles of `SIDE` x `SIDE`.
#[loops]
#[inline(always)]
fn transpose<const SIDE: u32, const TILE: usize>(
    id: Invocation,
    params: &Shape,
    input: Read<f32>,
    output: Write<f32>,
    tile: Shared<f32, TILE>,
) {
    const { assert!(TILE == (SIDE * SIDE) as usize) };
    let place = id.global();
    if place.x < params.columns && place.y < params.rows {
        tile.write(id.local.y * SIDE + id.local.x, input.read(place.y * params.columns + place.x));
    }
    id.barrier();
    let column = id.workgroup.y * SIDE + id.local.x;
    let row = id.workgroup.x * SIDE + id.local.y;
    if column < params.rows && row < params.columns {
        output.write(row * params.rows + column, tile.read(id.local.x * SIDE + id.local.y));
    }
}

/// [`transpose`] in tiles of 8 x 8.
#[kernel(threads(8, 8))]
pub fn transpose_8(
    id: Invocation,
    params: &Shape,
    input: Read<f32>,
    output: Write<f32>,
    tile: Shared<f32, 64>,
) {
    transpose::<8, 64>(id, params, input, output, tile);
}

/// [`transpose`] in tiles of 16 x 16.
#[kernel(threads(16, 16))]
pub fn transpose_16(
    id: Invocation,
    params: &Shape,
    input: Read<f32>,
    output: Write<f32>,
    tile: Shared<f32, 256>,
) {
    transpose::<16, 256>(id, params, input, output, tile);
}

#[test]
fn both_sizes_transpose() {
    let params = Shape { rows: 13, columns: 37 };
    let input: Vec<f32> = (0..13 * 37).map(|i| i as f32).collect();
    let expected: Vec<f32> = (0..37 * 13).map(|i| (i % 13 * 37 + i / 13) as f32).collect();
    for device in [devices::checked(), devices::thorough(2)] {
        let runner = KernelRunner::new(&device, "");
        let input = &runner.upload(&input).unwrap();
        let output = &runner.output(13 * 37).unwrap();
        device.run_over(&Transpose8Kernel { params, input, output }, [37, 13, 1]).unwrap();
        assert_eq!(runner.read_all(output).unwrap(), expected);
        let output = &runner.output(13 * 37).unwrap();
        device.run_over(&Transpose16Kernel { params, input, output }, [37, 13, 1]).unwrap();
        assert_eq!(runner.read_all(output).unwrap(), expected);
    }
}
