//! A long list is run over as if it were an image of one row: no GPU starts more than 65,535 workgroups along an axis.

use crate::bug::*;

#[kernel(threads(64))]
pub fn too_long_an_axis(id: Invocation, params: &Count, output: Write<u32>) {
    let index = id.global().x;
    if index < params.count {
        output.write(index, index);
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let output = bench.output(100)?;
    let params = Count { count: 100 };
    bench.device.run_over(&TooLongAnAxisKernel { params, output: &output }, [65_536 * 64, 1, 1])?;
    bench.expect(&output, |i| i)
}
