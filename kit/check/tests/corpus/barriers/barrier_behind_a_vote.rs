//! A barrier in a branch that a value in workgroup memory decides, which not all have read yet.

use crate::bug::*;

#[kernel(threads(64))]
pub fn barrier_behind_a_vote(
    id: Invocation,
    input: Read<u32>,
    output: Write<u32>,
    vote: Shared<u32, 1>,
) {
    if id.local_index() == 0 {
        vote.write(0, input.read(id.workgroup.x));
    }
    id.barrier();
    let is_wanted = vote.read(0) > 0;
    if is_wanted && input.read(id.workgroup.x) > id.local_index() {
        id.barrier(); //~
    }
    output.write(id.index(), vote.read(0));
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (input, output) = (bench.input(&[0, 9])?, bench.output(128)?);
    bench.run(&BarrierBehindAVoteKernel { input: &input, output: &output }, 128)?;
    bench.expect(&output, |i| if i < 64 { 0 } else { 9 })
}
