//! A second kernel reads one element more than the first one has written.

use crate::bug::*;

#[kernel(threads(64))]
pub fn differences(id: Invocation, params: &Count, scratch: Write<u32>, output: Write<u32>) {
    if id.index() < params.count {
        let next = scratch.read(id.index() + 1); //~
        output.write(id.index(), next.abs_diff(scratch.read(id.index())));
    }
}

#[kernel(threads(64))]
pub fn producer_is_too_short(id: Invocation, params: &Count, scratch: Write<u32>) {
    if id.index() < params.count {
        scratch.write(id.index(), 3 * id.index());
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (scratch, output) = (bench.scratch(101)?, bench.output(100)?);
    let params = Count { count: 100 };
    bench.run(&ProducerIsTooShortKernel { params, scratch: &scratch }, 100)?;
    bench.run(&DifferencesKernel { params, scratch: &scratch, output: &output }, 100)?;
    bench.expect(&output, |_| 3)
}
