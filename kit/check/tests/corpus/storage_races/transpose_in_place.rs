//! A transpose in place: both invocations of a pair swap it.

use crate::bug::*;

#[kernel(threads(8, 8))]
pub fn transpose_in_place(id: Invocation, params: &Size, image: Write<u32>) {
    let at = id.global();
    if at.x < params.width && at.y < params.height {
        let (here, there) = (at.y * params.width + at.x, at.x * params.width + at.y);
        let (a, b) = (image.read(here), image.read(there)); //~
        image.write(here, b); //~
        image.write(there, a); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let image = bench.holding(&numbers(256))?;
    let params = Size { width: 16, height: 16 };
    bench.pixels(&TransposeInPlaceKernel { params, image: &image }, [16, 16])?;
    bench.expect(&image, |i| i % 16 * 16 + i / 16)
}
