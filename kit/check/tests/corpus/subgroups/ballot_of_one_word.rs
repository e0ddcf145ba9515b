//! Counts the lanes of a ballot's first word, and where a subgroup has 64 lanes, the others are in the second.

use crate::bug::*;

#[kernel(threads(64), subgroups)]
pub fn ballot_of_one_word(id: Invocation, input: Read<u32>, count: Write<u32>) {
    let ballot = id.subgroup_ballot(input.read(id.index()) > 0);
    if id.subgroup_lane() == 0 {
        count.atomic_add(0, ballot.x.count_ones()); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (input, count) = (bench.input(&numbers(64))?, bench.cleared(1)?);
    bench.workgroups(&BallotOfOneWordKernel { input: &input, count: &count }, [1, 1, 1])?;
    bench.expect(&count, |_| 63)
}
