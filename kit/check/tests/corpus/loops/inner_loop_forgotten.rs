//! Declares the iterations of the outer loop alone.

use crate::bug::*;

#[kernel(threads(64), iterations = 8)]
pub fn inner_loop_forgotten(id: Invocation, input: Read<u32>, output: Write<u32>) {
    let (mut sum, mut row) = (0, 0);
    while row < 8 {
        let mut column = 0;
        //~
        while column < 8 {
            sum += input.read(8 * row + column);
            column += 1;
        }
        row += 1;
    }
    output.write(id.index(), sum);
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (input, output) = (bench.input(&[1; 64])?, bench.output(64)?);
    bench.run(&InnerLoopForgottenKernel { input: &input, output: &output }, 64)?;
    bench.expect(&output, |_| 64)
}
