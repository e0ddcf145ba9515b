//! Rows are as far apart as the image is high, and it is wider than high.

use crate::bug::*;

#[kernel(threads(8, 8))]
pub fn rows_overlap(id: Invocation, params: &Size, output: Write<u32>) {
    let at = id.global();
    if at.x < params.width && at.y < params.height {
        output.write(at.y * params.height + at.x, at.x); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let output = bench.output(24 * 10)?;
    let params = Size { width: 24, height: 10 };
    bench.pixels(&RowsOverlapKernel { params, output: &output }, [24, 10])?;
    bench.expect(&output, |i| i % 24)
}
