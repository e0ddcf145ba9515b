//! The right neighbor of a row's last pixel is the first pixel of the next row: in range, and wrong.

use crate::bug::*;

#[kernel(threads(8, 8))]
pub fn end_of_the_row(id: Invocation, params: &Size, image: Read<u32>, output: Write<u32>) {
    let at = id.global();
    if at.x < params.width && at.y < params.height {
        let index = at.y * params.width + at.x;
        let right = (index + 1).min(params.width * params.height - 1);
        output.write(index, image.read(right)); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let image = bench.input(&numbers(160))?;
    let output = bench.output(160)?;
    let params = Size { width: 16, height: 10 };
    bench.device.run_over(&EndOfTheRowKernel { params, image: &image, output: &output }, [16, 10, 1])?;
    bench.expect(&output, |i| if i % 16 == 15 { i } else { i + 1 })
}
