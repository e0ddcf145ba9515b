//! A kernel with lanes reads one element and gives it to all lanes.

use crate::bug::*;

#[kernel(threads(64), lanes(count))]
pub fn one_weight_for_all_lanes<L: Lane>(
    id: Invocation,
    params: &Count,
    weight: Read<f32>,
    output: Write<f32>,
) {
    let index = id.index();
    if index < params.count {
        L::splat(weight.read(index)).write(output, index); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let weights: Vec<f32> = (0..100).map(|i| i as f32).collect();
    let (weight, output) = (bench.input(&weights)?, bench.output(100)?);
    let params = Count { count: 100 };
    bench.run(&OneWeightForAllLanesKernel { params, weight: &weight, output: &output }, 100)?;
    bench.expect(&output, |i| i as f32)
}
