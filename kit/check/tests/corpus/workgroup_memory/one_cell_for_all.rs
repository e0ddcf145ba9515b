//! All invocations of a workgroup write the same element.

use crate::bug::*;

#[kernel(threads(64))]
pub fn one_cell_for_all(
    id: Invocation,
    input: Read<u32>,
    output: Write<u32>,
    largest: Shared<u32, 1>,
) {
    largest.write(0, input.read(id.index())); //~
    id.barrier();
    output.write(id.index(), largest.read(0));
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (input, output) = (bench.input(&numbers(64))?, bench.output(64)?);
    bench.run(&OneCellForAllKernel { input: &input, output: &output }, 64)?;
    bench.expect(&output, |_| 63)
}
