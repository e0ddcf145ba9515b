//! A ring buffer of length 0.

use crate::bug::*;

#[kernel(threads(64))]
pub fn remainder_by_zero(id: Invocation, params: &Count, output: Write<u32>) {
    output.write(id.index() % params.count, id.index()); //~
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let output = bench.output(1)?;
    bench.run(&RemainderByZeroKernel { params: Count { count: 0 }, output: &output }, 1)?;
    bench.expect_unwritten(&output)
}
