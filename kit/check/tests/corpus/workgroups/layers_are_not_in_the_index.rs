//! The dispatch has four layers, and the index leaves them out.

use crate::bug::*;

#[kernel(threads(64))]
pub fn layers_are_not_in_the_index(id: Invocation, params: &Count, output: Write<u32>) {
    if id.index() < params.count {
        output.write(id.index(), id.workgroup.z); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let output = bench.output(256)?;
    let kernel = LayersAreNotInTheIndexKernel { params: Count { count: 64 }, output: &output };
    bench.layers(&kernel, 64, 4)?;
    bench.expect(&output, |i| i / 64)
}
