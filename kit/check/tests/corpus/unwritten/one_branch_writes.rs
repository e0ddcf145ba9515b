//! Only one of two branches writes a result.

use crate::bug::*;

#[kernel(threads(64))]
pub fn one_branch_writes(id: Invocation, params: &Count, input: Read<f32>, output: Write<f32>) {
    if id.index() < params.count {
        let value = input.read(id.index());
        if value > 0.0 {
            output.write(id.index(), value);
        }
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let input: Vec<f32> = (0..100).map(|i| i as f32 - 50.0).collect();
    let (input, output) = (bench.input(&input)?, bench.output(100)?);
    let params = Count { count: 100 };
    bench.run(&OneBranchWritesKernel { params, input: &input, output: &output }, 100)?;
    bench.expect(&output, |i| (i as f32 - 50.0).max(0.0))
}
