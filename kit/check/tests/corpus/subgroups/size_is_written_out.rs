//! Takes 32 invocations for a subgroup, which is so on some GPUs.

use crate::bug::*;

#[kernel(threads(64), subgroups)]
pub fn size_is_written_out(id: Invocation, input: Read<u32>, sums: Write<u32>) {
    let sum = id.subgroup_sum(input.read(id.index()));
    if id.local.x.is_multiple_of(32) {
        sums.write(id.index() / 32, sum); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (input, sums) = (bench.input(&[1; 64])?, bench.output(2)?);
    bench.device.dispatch(&SizeIsWrittenOutKernel { input: &input, sums: &sums }, [1, 1, 1])?;
    bench.expect(&sums, |_| 32)
}
