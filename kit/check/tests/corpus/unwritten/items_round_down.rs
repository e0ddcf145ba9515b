//! The number of items is rounded down to whole workgroups. The additional workgroup of the checked device writes the rest, and no other does.

use crate::bug::*;

#[kernel(threads(64))]
pub fn items_round_down(id: Invocation, params: &Count, output: Write<u32>) {
    if id.index() < params.count {
        output.write(id.index(), id.index());
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let count = 100;
    let output = bench.output(100)?;
    let kernel = ItemsRoundDownKernel { params: Count { count }, output: &output };
    bench.run(&kernel, count / 64 * 64)?;
    bench.expect(&output, |i| i)
}
