//! An index that comes from a buffer says "none" with its largest value, and nobody looks.

use crate::bug::*;

#[kernel(threads(64))]
pub fn index_from_a_buffer(
    id: Invocation,
    params: &Count,
    parent: Read<u32>,
    value: Read<f32>,
    output: Write<f32>,
) {
    let index = id.index();
    if index < params.count {
        output.write(index, value.read(parent.read(index))); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let parent: Vec<u32> = (0..100_u32).map(|i| i.wrapping_sub(1)).collect();
    let (parent, value, output) =
        (bench.input(&parent)?, bench.input(&[1.0; 100])?, bench.output(100)?);
    let params = Count { count: 100 };
    let kernel = IndexFromABufferKernel { params, parent: &parent, value: &value, output: &output };
    bench.run(&kernel, 100)?;
    bench.expect(&output, |i| if i == 0 { 0.0 } else { 1.0 })
}
