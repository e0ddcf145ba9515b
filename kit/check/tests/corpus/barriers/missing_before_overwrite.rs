//! No barrier between reading a neighbor's value and overwriting it.

use crate::bug::*;

#[kernel(threads(64))]
pub fn missing_before_overwrite(id: Invocation, output: Write<u32>, values: Shared<u32, 64>) {
    let at = id.local_index();
    values.write(at, at);
    id.barrier();
    let next = values.read((at + 1) % 64);
    values.write(at, next); //~
    id.barrier();
    output.write(id.index(), values.read((at + 1) % 64));
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let output = bench.output(64)?;
    bench.run(&MissingBeforeOverwriteKernel { output: &output }, 64)?;
    bench.expect(&output, |i| (i + 2) % 64)
}
