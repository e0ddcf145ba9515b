//! Adds to a 64-bit sum as only a kernel with `z_serial` may.

use crate::bug::*;

#[kernel(threads(64))]
pub fn wide_sum_without_layers(id: Invocation, sum: Write<u32>) {
    atomic::add_wide(sum, 0, [id.index(), 0]); //~
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let sum = bench.cleared(2)?;
    bench.run(&WideSumWithoutLayersKernel { sum: &sum }, 128)?;
    bench.expect(&sum, |i| if i == 0 { 127 * 64 } else { 0 })
}
