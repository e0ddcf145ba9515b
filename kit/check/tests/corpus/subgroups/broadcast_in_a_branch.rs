//! A broadcast in a branch that each lane chooses by its value, though it is meant to be the value of the first lane of all.

use crate::bug::*;

#[kernel(threads(64), subgroups)]
pub fn broadcast_in_a_branch(id: Invocation, input: Read<u32>, output: Write<u32>) {
    let own = input.read(id.index());
    let mut base = 0;
    if own % 2 == 1 {
        base = id.subgroup_broadcast_first(own); //~
    }
    output.write(id.index(), base);
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (input, output) = (bench.input(&[7, 8].repeat(32))?, bench.output(64)?);
    bench.workgroups(&BroadcastInABranchKernel { input: &input, output: &output }, [1, 1, 1])?;
    bench.expect(&output, |i| if i % 2 == 0 { 7 } else { 0 })
}
