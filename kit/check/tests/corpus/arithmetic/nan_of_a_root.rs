//! A variance as a difference of sums rounds to a negative number, and has no root.

use crate::bug::*;

#[kernel(threads(64))]
pub fn nan_of_a_root(id: Invocation, params: &Count, input: Read<f32>, output: Write<f32>) {
    let index = id.index();
    if index < params.count {
        let (mean, mean_of_squares) = (input.read(2 * index), input.read(2 * index + 1));
        output.write(index, (mean_of_squares - mean * mean).sqrt()); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (input, output) = (bench.input(&[1.0, 2.0, 0.1, 0.009_999_99])?, bench.output(2)?);
    let params = Count { count: 2 };
    bench.run(&NanOfARootKernel { params, input: &input, output: &output }, 2)?;
    bench.expect(&output, |i| [1.0, 0.0][i as usize])
}
