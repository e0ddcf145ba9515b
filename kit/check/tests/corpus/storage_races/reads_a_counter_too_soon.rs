//! Reads a counter in the dispatch that still adds to it.

use crate::bug::*;

#[kernel(threads(64))]
pub fn reads_a_counter_too_soon(id: Invocation, counter: Write<u32>, output: Write<u32>) {
    atomic::add(counter, 0, 1); //~
    if id.index() == 255 {
        output.write(0, counter.read(0)); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let counter = bench.holding(&[0; 1])?;
    let output = bench.output(1)?;
    bench.run(&ReadsACounterTooSoonKernel { counter: &counter, output: &output }, 256)?;
    bench.expect(&output, |_| 256)
}
