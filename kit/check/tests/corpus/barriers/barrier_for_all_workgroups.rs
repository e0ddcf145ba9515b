//! A barrier waits for one workgroup, and the kernel reads what another workgroup writes.

use crate::bug::*;

#[kernel(threads(64))]
pub fn barrier_for_all_workgroups(
    id: Invocation,
    sums: Write<u32>,
    output: Write<u32>,
    own: Shared<u32, 64>,
) {
    own.write(id.local_index(), id.index());
    id.barrier();
    if id.local_index() == 0 {
        sums.write(id.workgroup.x, own.read(63));
    }
    id.barrier();
    let before = if id.workgroup.x > 0 { sums.read(id.workgroup.x - 1) } else { 0 }; //~
    output.write(id.index(), before);
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (sums, output) = (bench.output(4)?, bench.output(256)?);
    bench.run(&BarrierForAllWorkgroupsKernel { sums: &sums, output: &output }, 256)?;
    bench.expect(&output, |i| if i < 64 { 0 } else { i / 64 * 64 - 1 })
}
