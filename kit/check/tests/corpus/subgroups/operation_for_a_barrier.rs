//! A subgroup waits for its lanes, but that is no barrier: what the first one writes to workgroup memory may not be there yet.

use crate::bug::*;

#[kernel(threads(64), subgroups)]
pub fn operation_for_a_barrier(
    id: Invocation,
    input: Read<u32>,
    output: Write<u32>,
    first: Shared<u32, 64>,
) {
    let slot = id.local.x - id.subgroup_lane();
    let own = input.read(id.index());
    if id.subgroup_lane() == 0 {
        first.write(slot, own);
    }
    let sum = id.subgroup_sum(own);
    output.write(id.index(), sum - first.read(slot)); //~
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (input, output) = (bench.input(&[1; 64])?, bench.output(64)?);
    bench.workgroups(&OperationForABarrierKernel { input: &input, output: &output }, [1, 1, 1])?;
    bench.expect(&output, |_| 31)
}
