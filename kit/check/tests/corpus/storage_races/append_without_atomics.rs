//! Takes the next place of a list by reading its length and writing it back.

use crate::bug::*;

#[kernel(threads(64))]
pub fn append_without_atomics(
    id: Invocation,
    params: &Count,
    input: Read<u32>,
    length: Write<u32>,
    list: Write<u32>,
) {
    if id.index() < params.count && input.read(id.index()).is_multiple_of(2) {
        let place = length.read(0); //~
        length.write(0, place + 1); //~
        list.write(place, input.read(id.index()));
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (input, length, list) = (bench.input(&numbers(128))?, bench.cleared(1)?, bench.output(64)?);
    let params = Count { count: 128 };
    let kernel = AppendWithoutAtomicsKernel { params, input: &input, length: &length, list: &list };
    bench.run(&kernel, 128)?;
    bench.expect(&length, |_| 64)
}
