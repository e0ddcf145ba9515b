//! A column left of the image becomes a huge index.

use crate::bug::*;

#[kernel(threads(64))]
pub fn negative_column(id: Invocation, params: &Count, input: Read<f32>, output: Write<f32>) {
    let index = id.index();
    if index < params.count {
        let left = index as i32 - 2;
        output.write(index, input.read(left as u32)); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (input, output) = (bench.input(&[1.0; 100])?, bench.output(100)?);
    let params = Count { count: 100 };
    bench.run(&NegativeColumnKernel { params, input: &input, output: &output }, 100)?;
    bench.expect(&output, |_| 1.0)
}
