//! No barrier between writing to workgroup memory and reading what a neighbor has written.

use crate::bug::*;

#[kernel(threads(64))]
pub fn missing_before_read(id: Invocation, output: Write<u32>, values: Shared<u32, 64>) {
    let at = id.local_index();
    values.write(at, at);
    output.write(id.index(), values.read(63 - at)); //~
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let output = bench.output(64)?;
    bench.run(&MissingBeforeReadKernel { output: &output }, 64)?;
    bench.expect(&output, |i| 63 - i)
}
