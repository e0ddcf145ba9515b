//! The kernel declares no iterations, and its helper has a loop.

use crate::bug::*;

#[loops]
fn ones(mut bits: u32) -> u32 {
    let mut ones = 0;
    //~
    while bits != 0 {
        ones += bits & 1;
        bits >>= 1;
    }
    ones
}

#[kernel(threads(64))]
pub fn helper_is_not_counted(id: Invocation, params: &Count, input: Read<u32>, output: Write<u32>) {
    if id.index() < params.count {
        output.write(id.index(), ones(input.read(id.index())));
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (input, output) = (bench.input(&[7; 100])?, bench.output(100)?);
    let params = Count { count: 100 };
    bench.run(&HelperIsNotCountedKernel { params, input: &input, output: &output }, 100)?;
    bench.expect(&output, |_| 3)
}
