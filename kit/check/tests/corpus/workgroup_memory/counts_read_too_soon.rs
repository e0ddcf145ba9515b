//! Reads counts in workgroup memory that other invocations still add to: no barrier lies between.

use crate::bug::*;

#[kernel(threads(64))]
pub fn counts_read_too_soon(
    id: Invocation,
    input: Read<u32>,
    output: Write<u32>,
    counts: Shared<u32, 8>,
) {
    let at = id.local_index();
    if at < 8 {
        counts.write(at, 0);
    }
    id.barrier();
    counts.atomic_add(input.read(id.index()) % 8, 1); //~
    if at < 8 {
        output.write(at, counts.read(at)); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let input = bench.input(&numbers(64))?;
    let output = bench.output(8)?;
    bench.run(&CountsReadTooSoonKernel { input: &input, output: &output }, 64)?;
    bench.expect(&output, |_| 8)
}
