//! Rows are as far apart as the image is high, and it is higher than wide.

use crate::bug::*;

#[kernel(threads(8, 8))]
pub fn height_for_width(id: Invocation, params: &Size, image: Read<u32>, output: Write<u32>) {
    let at = id.global();
    if at.x < params.width && at.y < params.height {
        let pixel = image.read(at.y * params.height + at.x); //~
        output.write(at.y * params.width + at.x, pixel);
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (image, output) = (bench.input(&numbers(240))?, bench.output(240)?);
    let params = Size { width: 10, height: 24 };
    bench.pixels(&HeightForWidthKernel { params, image: &image, output: &output }, [10, 24])?;
    bench.expect(&output, |i| i)
}
