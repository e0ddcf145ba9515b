//! Converts a negative number to `u32`: 0 on the CPU, anything on a GPU.

use crate::bug::*;

#[kernel(threads(64))]
pub fn negative_float_to_unsigned(
    id: Invocation,
    params: &Count,
    place: Read<f32>,
    output: Write<u32>,
) {
    let index = id.index();
    if index < params.count {
        output.write(index, place.read(index) as u32 % 16); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let place = bench.input(&[3.0, 17.0, -1.0])?;
    let output = bench.output(3)?;
    let params = Count { count: 3 };
    bench.run(&NegativeFloatToUnsignedKernel { params, place: &place, output: &output }, 3)?;
    bench.expect(&output, |i| [3, 1, 15][i as usize])
}
