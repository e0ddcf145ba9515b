//! Each invocation has two elements and writes the first of them.

use crate::bug::*;

#[kernel(threads(64))]
pub fn every_second_pair(id: Invocation, params: &Count, output: Write<u32>) {
    let first = 2 * id.index();
    if first < params.count {
        output.write(first, first);
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let output = bench.output(100)?;
    bench.run(&EverySecondPairKernel { params: Count { count: 100 }, output: &output }, 50)?;
    bench.expect(&output, |i| i)
}
