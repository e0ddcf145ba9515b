//! The test of the index lets one too many through: `<=` in the place of `<`.

use crate::bug::*;

#[kernel(threads(64))]
pub fn test_is_off_by_one(id: Invocation, params: &Count, input: Read<f32>, output: Write<f32>) {
    if id.index() <= params.count {
        output.write(id.index(), 2.0 * input.read(id.index())); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (input, output) = (bench.input(&[1.0; 100])?, bench.output(100)?);
    let params = Count { count: 100 };
    bench.run(&TestIsOffByOneKernel { params, input: &input, output: &output }, 100)?;
    bench.expect(&output, |_| 2.0)
}
