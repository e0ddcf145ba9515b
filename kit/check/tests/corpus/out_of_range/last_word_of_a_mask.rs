//! Rounds the number of mask words down, so that the last bits have no word.

use crate::bug::*;

#[kernel(threads(64))]
pub fn last_word_of_a_mask(id: Invocation, params: &Count, mask: Read<u32>, output: Write<u32>) {
    let index = id.index();
    if index < params.count {
        output.write(index, mask.read(index / 32) >> (index % 32) & 1); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (mask, output) = (bench.input(&[u32::MAX; 100 / 32])?, bench.output(100)?);
    let params = Count { count: 100 };
    bench.run(&LastWordOfAMaskKernel { params, mask: &mask, output: &output }, 100)?;
    bench.expect(&output, |_| 1)
}
