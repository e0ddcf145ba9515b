//! The mean of no members is 0 / 0.

use crate::bug::*;

#[kernel(threads(64))]
pub fn nan_of_an_empty_mean(
    id: Invocation,
    params: &Count,
    sum: Read<f32>,
    weight: Read<f32>,
    output: Write<f32>,
) {
    let index = id.index();
    if index < params.count {
        output.write(index, sum.read(index) / weight.read(index)); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let sum = bench.input(&[1.0, 0.0, 4.0])?;
    let weight = bench.input(&[1.0, 0.0, 4.0])?;
    let params = Count { count: 3 };
    let output = bench.output(3)?;
    let kernel = NanOfAnEmptyMeanKernel { params, sum: &sum, weight: &weight, output: &output };
    bench.run(&kernel, 3)?;
    bench.expect(&output, |i| [1.0, 0.0, 1.0][i as usize])
}
