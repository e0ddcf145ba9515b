//! No invocation tests its index: the last workgroup has more invocations than there are elements.

use crate::bug::*;

#[kernel(threads(64))]
pub fn no_test_of_the_index(id: Invocation, input: Read<f32>, output: Write<f32>) {
    output.write(id.index(), 2.0 * input.read(id.index())); //~
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let input = bench.input(&[1.0; 100])?;
    let output = bench.output(100)?;
    bench.run(&NoTestOfTheIndexKernel { input: &input, output: &output }, 100)?;
    bench.expect(&output, |_| 2.0)
}
