//! Workgroups of two z add to the same 64-bit sum.

use crate::bug::*;

#[kernel(threads(64), z_serial)]
pub fn layers_share_a_sum(id: Invocation, sum: Write<u32>) {
    atomic::add_wide(sum, id.workgroup.z / 2, [1, 0]); //~
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let sum = bench.holding(&[0; 4])?;
    bench.device.run(&LayersShareASumKernel { sum: &sum }, 64, 4)?;
    bench.expect(&sum, |i| if i % 2 == 0 { 128 } else { 0 })
}
