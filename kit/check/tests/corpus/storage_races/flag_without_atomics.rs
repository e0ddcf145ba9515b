//! Many invocations write the same value to the same element. GPUs promise nothing about that.

use crate::bug::*;

#[kernel(threads(64))]
pub fn flag_without_atomics(id: Invocation, params: &Count, input: Read<u32>, flag: Write<u32>) {
    if id.index() < params.count && input.read(id.index()) > 100 {
        flag.write(0, 1); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (input, flag) = (bench.input(&numbers(128))?, bench.cleared(1)?);
    let params = Count { count: 128 };
    bench.run(&FlagWithoutAtomicsKernel { params, input: &input, flag: &flag }, 128)?;
    bench.expect(&flag, |_| 1)
}
