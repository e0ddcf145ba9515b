//! Compares a difference of unsigned numbers with 0, after it has wrapped on purpose.

use crate::bug::*;

#[kernel(threads(64))]
pub fn sign_is_lost(id: Invocation, params: &Count, input: Read<u32>, output: Write<u32>) {
    let index = id.index();
    if index < params.count {
        let above = input.read(index).wrapping_sub(10);
        output.write(index, (above > 0) as u32); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (input, output) = (bench.input(&[5, 10, 15])?, bench.output(3)?);
    let params = Count { count: 3 };
    bench.run(&SignIsLostKernel { params, input: &input, output: &output }, 3)?;
    bench.expect(&output, |i| [0, 0, 1][i as usize])
}
