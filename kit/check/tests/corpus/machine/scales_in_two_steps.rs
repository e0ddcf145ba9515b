//! Scales down in two steps, because the whole factor is too small. A driver may multiply the two steps first.

use crate::bug::*;

const STEP: f32 = 1e-30;

#[kernel(threads(64))]
pub fn scales_in_two_steps(id: Invocation, params: &Count, input: Read<f32>, output: Write<f32>) {
    let index = id.index();
    if index < params.count {
        output.write(index, input.read(index) * STEP * STEP); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let input = bench.input(&[0.0_f32, 1e38])?;
    let output = bench.output(2)?;
    let params = Count { count: 2 };
    bench.run(&ScalesInTwoStepsKernel { params, input: &input, output: &output }, 2)?;
    bench.expect(&output, |i| [0.0, (1e8_f32) * STEP][i as usize])
}
