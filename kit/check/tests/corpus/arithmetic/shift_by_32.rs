//! Shifts by 32 to make a mask of all bits: GPUs shift by 0.

use crate::bug::*;

#[kernel(threads(64))]
pub fn shift_by_32(id: Invocation, params: &Count, bits: Read<u32>, output: Write<u32>) {
    let index = id.index();
    if index < params.count {
        output.write(index, (1 << bits.read(index)) - 1); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let bits = bench.input(&[4, 8, 32])?;
    let output = bench.output(3)?;
    bench.run(&ShiftBy32Kernel { params: Count { count: 3 }, bits: &bits, output: &output }, 3)?;
    bench.expect(&output, |i| [0xf, 0xff, u32::MAX][i as usize])
}
