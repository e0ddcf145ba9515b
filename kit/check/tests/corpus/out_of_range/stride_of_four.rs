//! Points have three numbers, and the kernel reads them four apart.

use crate::bug::*;

#[kernel(threads(64))]
pub fn stride_of_four(id: Invocation, params: &Count, points: Read<f32>, output: Write<f32>) {
    let index = id.index();
    if index < params.count {
        output.write(index, points.read(4 * index + 2)); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let points: Vec<f32> = (0..300).map(|i| (i / 3) as f32).collect();
    let (points, output) = (bench.input(&points)?, bench.output(100)?);
    let params = Count { count: 100 };
    bench.run(&StrideOfFourKernel { params, points: &points, output: &output }, 100)?;
    bench.expect(&output, |i| i as f32)
}
