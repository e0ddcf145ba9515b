//! A barrier orders workgroup memory, not a storage buffer: the neighbor's value may not be there yet.

use crate::bug::*;

#[kernel(threads(64))]
pub fn barrier_for_storage(
    id: Invocation,
    scratch: Write<u32>,
    output: Write<u32>,
    unused: Shared<u32, 64>,
) {
    unused.write(id.local_index(), 0);
    scratch.write(id.index(), id.index());
    id.barrier();
    output.write(id.index(), scratch.read(id.index() ^ 1)); //~
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let scratch = bench.output(64)?;
    let output = bench.output(64)?;
    bench.run(&BarrierForStorageKernel { scratch: &scratch, output: &output }, 64)?;
    bench.expect(&output, |i| i ^ 1)
}
