//! Two invocations write each element.

use crate::bug::*;

#[kernel(threads(64))]
pub fn two_write_one(id: Invocation, params: &Count, output: Write<u32>) {
    if id.index() < params.count {
        output.write(id.index() / 2, id.index()); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let output = bench.output(128)?;
    bench.run(&TwoWriteOneKernel { params: Count { count: 256 }, output: &output }, 256)?;
    bench.expect(&output, |i| 2 * i)
}
