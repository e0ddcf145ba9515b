//! Moves all elements by one within their buffer.

use crate::bug::*;

#[kernel(threads(64))]
pub fn shift_in_place(id: Invocation, params: &Count, values: Write<u32>) {
    let index = id.index();
    if index + 1 < params.count {
        values.write(index, values.read(index + 1)); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let values = bench.holding(&numbers(200))?;
    bench.run(&ShiftInPlaceKernel { params: Count { count: 200 }, values: &values }, 200)?;
    bench.expect(&values, |i| (i + 1).min(199))
}
