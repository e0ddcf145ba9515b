//! Rounds to the nearest integer by adding a large number and taking it away. Where a driver regroups, nothing is rounded.

use crate::bug::*;

const LARGE: f32 = 12_582_912.0;

#[kernel(threads(64))]
pub fn rounds_by_a_large_number(
    id: Invocation,
    params: &Count,
    input: Read<f32>,
    output: Write<f32>,
) {
    let index = id.index();
    if index < params.count {
        let x = input.read(index);
        let shifted = x + LARGE;
        output.write(index, shifted - LARGE); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let input = bench.input(&[3.0_f32, 0.4, -7.6])?;
    let output = bench.output(3)?;
    let params = Count { count: 3 };
    bench.run(&RoundsByALargeNumberKernel { params, input: &input, output: &output }, 3)?;
    bench.expect(&output, |i| [3.0, 0.0, -8.0][i as usize])
}
