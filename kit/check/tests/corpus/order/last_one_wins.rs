//! Each invocation stores its own value in one element, atomically. The last one wins, and any can be the last.

use crate::bug::*;

#[kernel(threads(64))]
pub fn last_one_wins(id: Invocation, params: &Count, output: Write<u32>) {
    if id.index() < params.count {
        output.atomic_store(0, id.index()); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let output = bench.output(1)?;
    bench.run(&LastOneWinsKernel { params: Count { count: 100 }, output: &output }, 100)?;
    bench.expect(&output, |_| 99)
}
