//! The last invocation's neighbor is past the end of workgroup memory.

use crate::bug::*;

#[kernel(threads(64))]
pub fn past_the_end(id: Invocation, output: Write<u32>, values: Shared<u32, 64>) {
    let at = id.local_index();
    values.write(at, at);
    id.barrier();
    output.write(id.index(), values.read(at + 1)); //~
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let output = bench.output(64)?;
    bench.run(&PastTheEndKernel { output: &output }, 64)?;
    bench.expect(&output, |i| i + 1)
}
