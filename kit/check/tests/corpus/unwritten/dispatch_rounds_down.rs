//! The number of workgroups is rounded down: the last elements have no invocation.

use crate::bug::*;

#[kernel(threads(64))]
pub fn dispatch_rounds_down(id: Invocation, params: &Count, output: Write<u32>) {
    if id.index() < params.count {
        output.write(id.index(), id.index());
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let output = bench.output(100)?;
    let kernel = DispatchRoundsDownKernel { params: Count { count: 100 }, output: &output };
    bench.workgroups(&kernel, [100 / 64, 1, 1])?;
    bench.expect(&output, |i| i)
}
