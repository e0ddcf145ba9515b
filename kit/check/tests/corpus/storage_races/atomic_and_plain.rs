//! One invocation clears a counter that the others add to atomically.

use crate::bug::*;

#[kernel(threads(64))]
pub fn atomic_and_plain(id: Invocation, counter: Write<u32>) {
    if id.index() == 0 {
        counter.write(0, 0); //~
    }
    atomic::add(counter, 0, 1); //~
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let counter = bench.output(1)?;
    bench.run(&AtomicAndPlainKernel { counter: &counter }, 256)?;
    bench.expect(&counter, |_| 256)
}
