//! Invocations without an item return before the barrier that the others wait at.

use crate::bug::*;

#[kernel(threads(64))]
pub fn returns_before_barrier(
    id: Invocation,
    params: &Count,
    input: Read<u32>,
    output: Write<u32>,
    values: Shared<u32, 64>,
) {
    let (index, at) = (id.index(), id.local_index());
    if index >= params.count {
        return;
    }
    values.write(at, input.read(index));
    id.barrier(); //~
    output.write(index, values.read(at - at % 2));
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (input, output) = (bench.input(&numbers(100))?, bench.output(100)?);
    let params = Count { count: 100 };
    bench.run(&ReturnsBeforeBarrierKernel { params, input: &input, output: &output }, 100)?;
    bench.expect(&output, |i| i - i % 2)
}
