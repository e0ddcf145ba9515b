//! A histogram reads a count and writes it back, without an atomic.

use crate::bug::*;

#[kernel(threads(64))]
pub fn histogram_without_atomics(
    id: Invocation,
    params: &Count,
    input: Read<u32>,
    counts: Write<u32>,
) {
    if id.index() < params.count {
        let bin = input.read(id.index()) % 16;
        counts.write(bin, counts.read(bin) + 1); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (input, counts) = (bench.input(&numbers(256))?, bench.cleared(16)?);
    let params = Count { count: 256 };
    bench.run(&HistogramWithoutAtomicsKernel { params, input: &input, counts: &counts }, 256)?;
    bench.expect(&counts, |_| 16)
}
