//! Counts workgroups along x alone: a long dispatch has several rows of them.

use crate::bug::*;

#[kernel(threads(64))]
pub fn one_row_of_workgroups(id: Invocation, params: &Count, output: Write<u32>) {
    let index = id.global().x;
    if index < params.count {
        output.write(index, index); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let output = bench.output(256)?;
    let kernel = OneRowOfWorkgroupsKernel { params: Count { count: 256 }, output: &output };
    // as more than 65,535 workgroups would be laid out
    bench.workgroups(&kernel, [2, 2, 1])?;
    bench.expect(&output, |i| i)
}
