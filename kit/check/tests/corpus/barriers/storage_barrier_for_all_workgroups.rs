//! A storage barrier orders one workgroup, and the kernel reads what another workgroup has written.

use crate::bug::*;

#[kernel(threads(64), storage_barriers)]
pub fn storage_barrier_for_all_workgroups(
    id: Invocation,
    scratch: Write<u32>,
    output: Write<u32>,
) {
    scratch.write(id.index(), id.index());
    id.storage_barrier();
    output.write(id.index(), scratch.read(id.index().saturating_sub(64))); //~
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (scratch, output) = (bench.output(256)?, bench.output(256)?);
    bench.run(
        &StorageBarrierForAllWorkgroupsKernel { scratch: &scratch, output: &output },
        256,
    )?;
    bench.expect(&output, |i| i.saturating_sub(64))
}
