//! A helper turns the logarithm of a negative number into a level: NaN ends in an integer.

use crate::bug::*;

/// The level of detail of a size.
#[loops]
fn level(size: f32) -> u32 {
    size.log2() as u32 //~
}

#[kernel(threads(64))]
pub fn nan_in_a_helper(id: Invocation, params: &Count, size: Read<f32>, output: Write<u32>) {
    let index = id.index();
    if index < params.count {
        output.write(index, level(size.read(index)));
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let size = bench.input(&[1.0_f32, 8.5, -2.0])?;
    let output = bench.output(3)?;
    let params = Count { count: 3 };
    bench.run(&NanInAHelperKernel { params, size: &size, output: &output }, 3)?;
    bench.expect(&output, |i| [0, 3, 0][i as usize])
}
