//! Counts in workgroup memory are added to before they are cleared: it does not begin with zeros.

use crate::bug::*;

#[kernel(threads(64))]
pub fn counts_are_not_cleared(
    id: Invocation,
    input: Read<u32>,
    output: Write<u32>,
    counts: Shared<u32, 64>,
) {
    let at = id.local_index();
    counts.write(at, counts.read(at) + input.read(id.index())); //~
    id.barrier();
    output.write(id.index(), counts.read(63 - at));
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (input, output) = (bench.input(&[3; 64])?, bench.output(64)?);
    bench.run(&CountsAreNotClearedKernel { input: &input, output: &output }, 64)?;
    bench.expect(&output, |_| 3)
}
