//! Computes an offset in bytes where an index of elements is meant.

use crate::bug::*;

#[kernel(threads(64))]
pub fn bytes_for_elements(id: Invocation, params: &Count, input: Read<f32>, output: Write<f32>) {
    let index = id.index();
    if index < params.count {
        output.write(index, input.read(index * 4)); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (input, output) = (bench.input(&[1.0; 100])?, bench.output(100)?);
    let params = Count { count: 100 };
    bench.run(&BytesForElementsKernel { params, input: &input, output: &output }, 100)?;
    bench.expect(&output, |_| 1.0)
}
