//! The test of the index leaves out the last element.

use crate::bug::*;

#[kernel(threads(64))]
pub fn last_element(id: Invocation, params: &Count, input: Read<f32>, output: Write<f32>) {
    if id.index() + 1 < params.count {
        output.write(id.index(), 2.0 * input.read(id.index()));
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let input = bench.input(&[1.0; 100])?;
    let output = bench.output(100)?;
    let params = Count { count: 100 };
    bench.run(&LastElementKernel { params, input: &input, output: &output }, 100)?;
    bench.expect(&output, |_| 2.0)
}
