//! The last index of an empty list is 0 - 1.

use crate::bug::*;

#[kernel(threads(64))]
pub fn difference_underflows(id: Invocation, params: &Count, output: Write<u32>) {
    let last = params.count - 1; //~
    if id.index() <= last {
        output.write(id.index(), id.index());
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let output = bench.output(1)?;
    bench.run(&DifferenceUnderflowsKernel { params: Count { count: 0 }, output: &output }, 1)?;
    Ok(())
}
