//! The buffer has an element for each point, and the kernel reads three.

use crate::bug::*;

#[kernel(threads(64))]
pub fn buffer_of_another_size(
    id: Invocation,
    params: &Count,
    points: Read<f32>,
    output: Write<f32>,
) {
    let index = id.index();
    if index < params.count {
        output.write(index, points.read(3 * index) + points.read(3 * index + 2)); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (points, output) = (bench.input(&[1.0; 100])?, bench.output(100)?);
    let params = Count { count: 100 };
    bench.run(&BufferOfAnotherSizeKernel { params, points: &points, output: &output }, 100)?;
    bench.expect(&output, |_| 2.0)
}
