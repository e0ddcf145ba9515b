//! A loop over a row runs once too often.

use crate::bug::*;

#[kernel(threads(64), iterations = 17)]
pub fn one_iteration_too_many(id: Invocation, input: Read<u32>, output: Write<u32>) {
    let (mut sum, mut i) = (0, 0);
    while i <= 16 {
        sum += input.read(16 * id.index() + i); //~
        i += 1;
    }
    output.write(id.index(), sum);
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (input, output) = (bench.input(&[1; 1024])?, bench.output(64)?);
    bench.run(&OneIterationTooManyKernel { input: &input, output: &output }, 64)?;
    bench.expect(&output, |_| 16)
}
