//! Packs colors above 1 into bytes: the red spills over into the green.

use crate::bug::*;

#[kernel(threads(64))]
pub fn color_spills_over(id: Invocation, params: &Count, color: Read<f32>, output: Write<u32>) {
    let index = id.index();
    if index < params.count {
        let red = (255.0 * color.read(2 * index)) as u32;
        let green = (255.0 * color.read(2 * index + 1)) as u32;
        output.write(index, red | green << 8); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (color, output) = (bench.input(&[1.0, 0.0, 1.1, 0.0])?, bench.output(2)?);
    let params = Count { count: 2 };
    bench.run(&ColorSpillsOverKernel { params, color: &color, output: &output }, 2)?;
    bench.expect(&output, |_| 255)
}
