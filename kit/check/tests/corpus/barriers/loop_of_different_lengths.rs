//! A loop with a barrier runs as often as the invocation's own data says.

use crate::bug::*;

#[kernel(threads(64), iterations = 8)]
pub fn loop_of_different_lengths(
    id: Invocation,
    rounds: Read<u32>,
    output: Write<u32>,
    values: Shared<u32, 64>,
) {
    let at = id.local_index();
    values.write(at, 0);
    let mut i = 0;
    while i < rounds.read(id.index()) {
        values.write(at, values.read(at) + 1);
        id.barrier(); //~
        i += 1;
    }
    output.write(id.index(), values.read(at));
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let rounds: Vec<u32> = (0..64).map(|i| 4 + i / 60).collect();
    let (input, output) = (bench.input(&rounds)?, bench.output(64)?);
    bench.run(&LoopOfDifferentLengthsKernel { rounds: &input, output: &output }, 64)?;
    bench.expect(&output, |i| 4 + i / 60)
}
