//! Normalizes by a sum that can be a denormal: where a GPU flushes it, the kernel divides by zero.

use crate::bug::*;

#[kernel(threads(64))]
pub fn divides_by_a_denormal(id: Invocation, params: &Count, input: Read<f32>, output: Write<f32>) {
    let index = id.index();
    if index < params.count {
        let (x, sum) = (input.read(2 * index), input.read(2 * index) + input.read(2 * index + 1));
        output.write(index, x / sum); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (input, output) = (bench.input(&[1.0_f32, 3.0, 1e-40, 0.0])?, bench.output(2)?);
    let params = Count { count: 2 };
    bench.run(&DividesByADenormalKernel { params, input: &input, output: &output }, 2)?;
    bench.expect(&output, |i| [0.25, 1.0][i as usize])
}
