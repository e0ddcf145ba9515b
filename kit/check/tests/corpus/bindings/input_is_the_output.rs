//! One buffer is bound as input and as output.

use crate::bug::*;

#[kernel(threads(64))]
pub fn input_is_the_output(id: Invocation, params: &Count, input: Read<f32>, output: Write<f32>) {
    let index = id.index();
    if index < params.count {
        output.write(index, input.read(params.count - 1 - index));
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let values: Vec<f32> = (0..100).map(|i| i as f32).collect();
    let both = bench.holding(&values)?;
    let params = Count { count: 100 };
    bench.run(&InputIsTheOutputKernel { params, input: &both, output: &both }, 100)?;
    bench.expect(&both, |i| 99.0 - i as f32)
}
