//! The last element's right neighbor does not exist.

use crate::bug::*;

#[kernel(threads(64))]
pub fn neighbor_of_the_last(id: Invocation, params: &Count, input: Read<f32>, output: Write<f32>) {
    let index = id.index();
    if index < params.count {
        output.write(index, input.read(index + 1) - input.read(index)); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (input, output) = (bench.input(&[1.0; 100])?, bench.output(100)?);
    let params = Count { count: 100 };
    bench.run(&NeighborOfTheLastKernel { params, input: &input, output: &output }, 100)?;
    bench.expect(&output, |_| 0.0)
}
