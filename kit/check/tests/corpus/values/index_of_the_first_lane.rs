//! A kernel with lanes computes with the index of its first lane in all of them.

use crate::bug::*;

#[kernel(threads(64), lanes(count))]
pub fn index_of_the_first_lane<L: Lane>(id: Invocation, params: &Count, output: Write<f32>) {
    let index = id.index();
    if index < params.count {
        (L::splat(index as f32) * L::splat(0.5)).write(output, index); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let output = bench.output(100)?;
    bench.run(&IndexOfTheFirstLaneKernel { params: Count { count: 100 }, output: &output }, 100)?;
    bench.expect(&output, |i| 0.5 * i as f32)
}
