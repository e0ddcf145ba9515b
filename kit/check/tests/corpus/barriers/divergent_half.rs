//! Only the invocations that have work reach the barrier.

use crate::bug::*;

#[kernel(threads(64))]
pub fn divergent_half(id: Invocation, output: Write<u32>, values: Shared<u32, 64>) {
    let at = id.local_index();
    values.write(at, at);
    if at < 32 {
        id.barrier(); //~
        values.write(at, values.read(at + 32));
    }
    output.write(id.index(), at);
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let output = bench.output(64)?;
    bench.run(&DivergentHalfKernel { output: &output }, 64)?;
    bench.expect(&output, |i| i)
}
