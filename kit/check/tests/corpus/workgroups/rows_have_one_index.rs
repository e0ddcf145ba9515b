//! A workgroup of 8 x 8 invocations takes its index from x alone.

use crate::bug::*;

#[kernel(threads(8, 8))]
pub fn rows_have_one_index(id: Invocation, params: &Count, output: Write<u32>) {
    let index = id.index();
    if index < params.count {
        output.write(index, index); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let output = bench.output(128)?;
    bench.run(&RowsHaveOneIndexKernel { params: Count { count: 128 }, output: &output }, 128)?;
    bench.expect(&output, |i| i)
}
