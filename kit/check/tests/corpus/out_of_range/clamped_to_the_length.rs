//! Clamps an index to the length, which is one past the last element.

use crate::bug::*;

#[kernel(threads(64))]
pub fn clamped_to_the_length(id: Invocation, params: &Count, input: Read<f32>, output: Write<f32>) {
    let index = id.index();
    if index < params.count {
        let right = (index + 3).min(params.count);
        output.write(index, input.read(right)); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (input, output) = (bench.input(&[1.0; 100])?, bench.output(100)?);
    let params = Count { count: 100 };
    bench.run(&ClampedToTheLengthKernel { params, input: &input, output: &output }, 100)?;
    bench.expect(&output, |_| 1.0)
}
