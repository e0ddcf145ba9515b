//! Squares a signed distance with `pow`, which takes the logarithm: it knows no power of a negative number.

use crate::bug::*;

#[kernel(threads(64))]
pub fn square_by_pow(id: Invocation, params: &Count, distance: Read<f32>, output: Write<f32>) {
    let index = id.index();
    if index < params.count {
        output.write(index, muslin::math::pow(distance.read(index), 2.0)); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let distance = bench.input(&[1.0_f32, 0.0, -2.0])?;
    let output = bench.output(3)?;
    let params = Count { count: 3 };
    bench.run(&SquareByPowKernel { params, distance: &distance, output: &output }, 3)?;
    bench.expect(&output, |i| [1.0, 0.0, 4.0][i as usize])
}
