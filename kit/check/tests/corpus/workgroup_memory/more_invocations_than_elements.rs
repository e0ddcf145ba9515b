//! The workgroup has 128 invocations, and workgroup memory has room for 64.

use crate::bug::*;

#[kernel(threads(128))]
pub fn more_invocations_than_elements(id: Invocation, output: Write<u32>, values: Shared<u32, 64>) {
    values.write(id.local_index(), id.index()); //~
    id.barrier();
    output.write(id.index(), values.read(id.local_index() ^ 1));
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let output = bench.output(128)?;
    bench.run(&MoreInvocationsThanElementsKernel { output: &output }, 128)?;
    bench.expect(&output, |i| i ^ 1)
}
