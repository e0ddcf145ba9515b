//! A kernel of two dimensions is dispatched along one.

use crate::bug::*;

#[kernel(threads(8, 8))]
pub fn dispatch_without_rows(id: Invocation, params: &Size, output: Write<u32>) {
    let at = id.global();
    if at.x < params.width && at.y < params.height {
        output.write(at.y * params.width + at.x, at.y);
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let output = bench.output(160)?;
    let params = Size { width: 16, height: 10 };
    bench.run(&DispatchWithoutRowsKernel { params, output: &output }, 160)?;
    bench.expect(&output, |i| i / 16)
}
