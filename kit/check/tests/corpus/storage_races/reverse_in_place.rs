//! Reverses a buffer in place with one invocation for each element, not for each pair.

use crate::bug::*;

#[kernel(threads(64))]
pub fn reverse_in_place(id: Invocation, params: &Count, values: Write<u32>) {
    let index = id.index();
    if index < params.count {
        let value = values.read(params.count - 1 - index); //~
        values.write(index, value); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let values = bench.holding(&numbers(128))?;
    bench.run(&ReverseInPlaceKernel { params: Count { count: 128 }, values: &values }, 128)?;
    bench.expect(&values, |i| 127 - i)
}
