//! A storage barrier waits for one workgroup, and the kernel reads what another workgroup writes.

use crate::bug::*;

#[kernel(threads(64))]
pub fn storage_barrier_for_all_workgroups(
    id: Invocation,
    scratch: Write<u32>,
    output: Write<u32>,
) {
    scratch.write(id.index(), id.index());
    id.storage_barrier();
    output.write(id.index(), scratch.read(id.index() / 2)); //~
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (scratch, output) = (bench.output(128)?, bench.output(128)?);
    let kernel = StorageBarrierForAllWorkgroupsKernel { scratch: &scratch, output: &output };
    bench.run(&kernel, 128)?;
    bench.expect(&output, |i| i / 2)
}
