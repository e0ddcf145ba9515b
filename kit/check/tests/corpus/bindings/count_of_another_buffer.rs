//! The number of items is that of the longer of two buffers.

use crate::bug::*;

#[kernel(threads(64))]
pub fn count_of_another_buffer(
    id: Invocation,
    params: &Count,
    index: Read<u32>,
    output: Write<u32>,
) {
    if id.index() < params.count {
        output.write(id.index(), index.read(id.index())); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (index, output) = (bench.input(&numbers(100))?, bench.output(120)?);
    let params = Count { count: 120 };
    bench.run(&CountOfAnotherBufferKernel { params, index: &index, output: &output }, 120)?;
    bench.expect(&output, |i| i)
}
