//! Counts in an `f32`, which has no odd numbers above 2^24.

use crate::bug::*;

#[kernel(threads(64))]
pub fn float_counts_too_far(id: Invocation, params: &Count, input: Read<u32>, output: Write<u32>) {
    let index = id.index();
    if index < params.count {
        output.write(index, (input.read(index) as f32 + 1.0) as u32); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (input, output) = (bench.input(&[7, 1 << 23, 1 << 24])?, bench.output(3)?);
    let params = Count { count: 3 };
    bench.run(&FloatCountsTooFarKernel { params, input: &input, output: &output }, 3)?;
    bench.expect(&output, |i| [7, 1 << 23, 1 << 24][i as usize] + 1)
}
