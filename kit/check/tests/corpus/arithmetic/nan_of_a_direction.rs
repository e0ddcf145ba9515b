//! Normalizes a vector that can be zero.

use crate::bug::*;
use glam::Vec4;

#[kernel(threads(64))]
pub fn nan_of_a_direction(id: Invocation, params: &Count, input: Read<Vec4>, output: Write<Vec4>) {
    let index = id.index();
    if index < params.count {
        let v = input.read(index);
        output.write(index, v / (v.x * v.x + v.y * v.y + v.z * v.z).sqrt()); //~
    }
}

pub fn test(bench: &Bench) -> Result<(), Found> {
    let (input, output) = (bench.input(&[Vec4::X, Vec4::ZERO])?, bench.output(2)?);
    let params = Count { count: 2 };
    bench.run(&NanOfADirectionKernel { params, input: &input, output: &output }, 2)?;
    bench.expect(&output, |i| [Vec4::X, Vec4::ZERO][i as usize])
}
