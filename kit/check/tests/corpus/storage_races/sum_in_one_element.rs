//! Every invocation adds to one element, without an atomic.

use crate::bug::*;

#[kernel(threads(64))]
pub fn sum_in_one_element(id: Invocation, params: &Count, input: Read<u32>, sum: Write<u32>) {
    if id.index() < params.count {
        sum.write(0, sum.read(0) + input.read(id.index())); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (input, sum) = (bench.input(&[1; 256])?, bench.cleared(1)?);
    let params = Count { count: 256 };
    bench.run(&SumInOneElementKernel { params, input: &input, sum: &sum }, 256)?;
    bench.expect(&sum, |_| 256)
}
