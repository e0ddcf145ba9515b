//! The input is the tail of the output's memory.

use crate::bug::*;

#[kernel(threads(64))]
pub fn tail_of_the_output(id: Invocation, params: &Count, input: Read<u32>, output: Write<u32>) {
    if id.index() < params.count {
        output.write(id.index(), input.read(id.index()));
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let output = bench.holding(&numbers(164))?;
    let (params, input) = (Count { count: 100 }, output.tail(64));
    bench.run(&TailOfTheOutputKernel { params, input: &input, output: &output }, 100)?;
    bench.expect(&output, |i| if i < 100 { i + 64 } else { i })
}
