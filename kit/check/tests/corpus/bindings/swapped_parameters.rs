//! Width and height are given the wrong way round.

use crate::bug::*;

#[kernel(threads(8, 8))]
pub fn swapped_parameters(id: Invocation, params: &Size, output: Write<u32>) {
    let at = id.global();
    if at.x < params.width && at.y < params.height {
        output.write(at.y * params.width + at.x, at.y);
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let output = bench.output(160)?;
    let params = Size { width: 10, height: 16 };
    bench.pixels(&SwappedParametersKernel { params, output: &output }, [16, 10])?;
    bench.expect(&output, |i| i / 16)
}
