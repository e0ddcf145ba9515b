//! A loop over lanes reads whole groups of lanes, and the buffer ends within the last one.

use crate::bug::*;

#[kernel(threads(64), iterations = 128, lanes)]
pub fn lanes_past_the_end<L: Lane>(
    id: Invocation,
    params: &Count,
    input: Read<f32>,
    output: Write<f32>,
) {
    if id.index() == 0 {
        let mut sum = L::splat(0.0);
        let mut at = 0;
        while at < params.count {
            sum = sum + L::read(input, at); //~
            at += L::WIDTH;
        }
        output.write(0, sum.sum());
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let input = bench.input(&[1.0; 100])?;
    let output = bench.output(1)?;
    let params = Count { count: 100 };
    bench.run(&LanesPastTheEndKernel { params, input: &input, output: &output }, 1)?;
    bench.expect(&output, |_| 100.0)
}
