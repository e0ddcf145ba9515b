//! The workgroup's size was changed to 128, and the index still counts in 64.

use crate::bug::*;

#[kernel(threads(128))]
pub fn size_is_written_out(id: Invocation, params: &Count, output: Write<u32>) {
    let index = id.workgroup.x * 64 + id.local.x;
    if index < params.count {
        output.write(index, index); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let output = bench.output(256)?;
    bench.run(&SizeIsWrittenOutKernel { params: Count { count: 256 }, output: &output }, 256)?;
    bench.expect(&output, |i| i)
}
