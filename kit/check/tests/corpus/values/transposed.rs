//! Writes columns where rows are meant: every element once, all in the wrong place.

use crate::bug::*;

#[kernel(threads(8, 8))]
pub fn transposed(id: Invocation, params: &Size, image: Read<u32>, output: Write<u32>) {
    let at = id.global();
    if at.x < params.width && at.y < params.height {
        let pixel = image.read(at.y * params.width + at.x);
        output.write(at.x * params.height + at.y, pixel); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (image, output) = (bench.input(&numbers(160))?, bench.output(160)?);
    let params = Size { width: 16, height: 10 };
    bench.pixels(&TransposedKernel { params, image: &image, output: &output }, [16, 10])?;
    bench.expect(&output, |i| i)
}
