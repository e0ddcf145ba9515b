//! A sum of counts passes 2^32.

use crate::bug::*;

#[kernel(threads(64))]
pub fn sum_overflows(id: Invocation, params: &Count, input: Read<u32>, output: Write<u32>) {
    let index = id.index();
    if index < params.count {
        output.write(index, (input.read(index) + input.read(index)) / 2); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (input, output) = (bench.input(&[1 << 31; 100])?, bench.output(100)?);
    let params = Count { count: 100 };
    bench.run(&SumOverflowsKernel { params, input: &input, output: &output }, 100)?;
    bench.expect(&output, |_| 1 << 31)
}
