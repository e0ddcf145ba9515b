//! Rows of workgroup memory have 9 elements when they are written, and 8 when they are read.

use crate::bug::*;

#[kernel(threads(8, 8))]
pub fn row_without_its_padding(id: Invocation, output: Write<u32>, tile: Shared<u32, 72>) {
    let (x, y) = (id.local.x, id.local.y);
    tile.write(9 * y + x, id.local_index());
    id.barrier();
    output.write(id.local_index(), tile.read(8 * x + y)); //~
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let output = bench.output(64)?;
    bench.pixels(&RowWithoutItsPaddingKernel { output: &output }, [8, 8])?;
    bench.expect(&output, |i| 8 * (i % 8) + i / 8)
}
