//! Declares 8 iterations and runs 16: GPUs have limits, and the host plans for what is declared.

use crate::bug::*;

#[kernel(threads(64), iterations = 8)]
pub fn understated(id: Invocation, input: Read<u32>, output: Write<u32>) {
    let mut sum = 0;
    let mut i = 0;
    //~
    while i < 16 {
        sum += input.read(16 * id.index() + i);
        i += 1;
    }
    output.write(id.index(), sum);
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let input = bench.input(&[1; 1024])?;
    let output = bench.output(64)?;
    bench.run(&UnderstatedKernel { input: &input, output: &output }, 64)?;
    bench.expect(&output, |_| 16)
}
