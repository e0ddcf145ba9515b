//! Converts a number to `u32` that has no room in it: the largest `u32` on the CPU, anything on a GPU.

use crate::bug::*;

#[kernel(threads(64))]
pub fn too_large_for_an_integer(
    id: Invocation,
    params: &Count,
    depth: Read<f32>,
    output: Write<u32>,
) {
    let index = id.index();
    if index < params.count {
        output.write(index, (depth.read(index) * 1000.0) as u32); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (depth, output) = (bench.input(&[0.5_f32, 4_000_000.0, 1e9])?, bench.output(3)?);
    let params = Count { count: 3 };
    bench.run(&TooLargeForAnIntegerKernel { params, depth: &depth, output: &output }, 3)?;
    bench.expect(&output, |i| [500, 4_000_000_000, u32::MAX][i as usize])
}
