//! Adds to a counter that was never cleared.

use crate::bug::*;

#[kernel(threads(64))]
pub fn counter_is_not_cleared(id: Invocation, params: &Count, counter: Write<u32>) {
    if id.index() < params.count {
        atomic::add(counter, 0, 1); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let counter = bench.output(1)?;
    bench
        .run(&CounterIsNotClearedKernel { params: Count { count: 100 }, counter: &counter }, 100)?;
    bench.expect(&counter, |_| 100)
}
