//! The product of width and height passes 2^32, and nothing lies outside of the image any more.

use crate::bug::*;

#[kernel(threads(64))]
pub fn product_overflows(id: Invocation, params: &Size, output: Write<u32>) {
    let is_inside = id.index() < params.width * params.height; //~
    output.write(id.index(), is_inside as u32);
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let output = bench.output(64)?;
    let params = Size { width: 1 << 16, height: 1 << 16 };
    bench.run(&ProductOverflowsKernel { params, output: &output }, 64)?;
    bench.expect(&output, |_| 1)
}
