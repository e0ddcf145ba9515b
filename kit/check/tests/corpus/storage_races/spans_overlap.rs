//! Each invocation writes five elements, and they are four apart.

use crate::bug::*;

#[kernel(threads(64), iterations = 5)]
pub fn spans_overlap(id: Invocation, params: &Count, output: Write<u32>) {
    let mut i = 0;
    while i < 5 {
        let at = 4 * id.index() + i;
        if at < params.count {
            output.write(at, at); //~
        }
        i += 1;
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let output = bench.output(256)?;
    bench.run(&SpansOverlapKernel { params: Count { count: 256 }, output: &output }, 64)?;
    bench.expect(&output, |i| i)
}
