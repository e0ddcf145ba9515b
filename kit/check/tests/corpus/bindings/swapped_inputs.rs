//! Two inputs of the same type and length are bound the wrong way round.

use crate::bug::*;

#[kernel(threads(64))]
pub fn swapped_inputs(
    id: Invocation,
    params: &Count,
    first: Read<f32>,
    second: Read<f32>,
    output: Write<f32>,
) {
    let index = id.index();
    if index < params.count {
        output.write(index, first.read(index) - second.read(index));
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let first = bench.device.upload("first", &[3.0; 100])?;
    let second = bench.device.upload("second", &[2.0; 100])?;
    let params = Count { count: 100 };
    let output = bench.output(100)?;
    let kernel = SwappedInputsKernel { params, first: &second, second: &first, output: &output };
    bench.run(&kernel, 100)?;
    bench.expect(&output, |_| 1.0)
}
