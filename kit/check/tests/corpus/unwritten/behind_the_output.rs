//! Writes one element behind its output, where another buffer may be.

use crate::bug::*;

#[kernel(threads(64))]
pub fn behind_the_output(id: Invocation, params: &Count, output: Write<u32>) {
    if id.index() <= params.count {
        output.write(id.index(), id.index());
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let output = bench.output(100)?;
    bench.run(&BehindTheOutputKernel { params: Count { count: 100 }, output: &output }, 101)?;
    bench.expect(&output, |i| i)
}
