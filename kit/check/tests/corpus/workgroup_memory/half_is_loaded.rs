//! Every second element of workgroup memory is never written.

use crate::bug::*;

#[kernel(threads(64))]
pub fn half_is_loaded(
    id: Invocation,
    input: Read<u32>,
    output: Write<u32>,
    values: Shared<u32, 64>,
) {
    let at = id.local_index();
    if at.is_multiple_of(2) {
        values.write(at, input.read(id.index()));
    }
    id.barrier();
    output.write(id.index(), values.read(at ^ 1)); //~
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (input, output) = (bench.input(&numbers(64))?, bench.output(64)?);
    bench.run(&HalfIsLoadedKernel { input: &input, output: &output }, 64)?;
    bench.expect(&output, |i| i ^ 1)
}
