//! The first element's left neighbor does not exist, and a `u32` has no -1.

use crate::bug::*;

#[kernel(threads(64))]
pub fn neighbor_of_the_first(id: Invocation, params: &Count, input: Read<f32>, output: Write<f32>) {
    let index = id.index();
    if index < params.count {
        output.write(index, input.read(index) - input.read(index - 1)); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (input, output) = (bench.input(&[1.0; 100])?, bench.output(100)?);
    let params = Count { count: 100 };
    bench.run(&NeighborOfTheFirstKernel { params, input: &input, output: &output }, 100)?;
    bench.expect(&output, |_| 0.0)
}
