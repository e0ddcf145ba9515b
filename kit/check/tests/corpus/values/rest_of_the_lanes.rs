//! A loop over lanes leaves out what does not fill all lanes.

use crate::bug::*;

#[kernel(threads(64), iterations = 128, lanes)]
pub fn rest_of_the_lanes<L: Lane>(
    id: Invocation,
    params: &Count,
    input: Read<f32>,
    output: Write<f32>,
) {
    if id.index() == 0 {
        let (mut sum, mut at) = (L::splat(0.0), 0);
        while at + L::WIDTH <= params.count {
            sum = sum + L::read(input, at);
            at += L::WIDTH;
        }
        output.write(0, sum.sum()); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (input, output) = (bench.input(&[1.0; 101])?, bench.output(1)?);
    let params = Count { count: 101 };
    bench.run(&RestOfTheLanesKernel { params, input: &input, output: &output }, 1)?;
    bench.expect(&output, |_| 101.0)
}
