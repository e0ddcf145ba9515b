//! Packs two numbers into a word: the upper one has more than 16 bits, and loses some.

use crate::bug::*;

#[kernel(threads(64))]
pub fn bits_shifted_out(id: Invocation, params: &Count, input: Read<u32>, output: Write<u32>) {
    let index = id.index();
    if index < params.count {
        output.write(index, input.read(index) << 16 | index); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (input, output) = (bench.input(&[1, 65_535, 65_537])?, bench.output(3)?);
    let params = Count { count: 3 };
    bench.run(&BitsShiftedOutKernel { params, input: &input, output: &output }, 3)?;
    let unpacked: Vec<u32> = bench.read(&output)?.iter().map(|word| word >> 16).collect();
    bench.expect_values(&unpacked, |i| [1, 65_535, 65_537][i as usize])
}
