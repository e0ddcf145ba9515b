//! The discrete Fourier transform, in passes (Stockham).

use core::f32::consts::PI;

use muslin::{math, prelude::*};

/// Parameters of [`fft_pass`] and [`fft_pass_4`].
#[params]
pub struct FftParams {
    /// Half of the values, or a quarter: a power of two.
    pub part: u32,
    /// Values of the transforms that are done: 1, 2, 4, ...
    pub done: u32,
    /// -1 for the transform, and 1 for its inverse.
    pub sign: f32,
}

/// The product of two complex numbers.
#[inline(always)]
fn times(a: Vec2, b: Vec2) -> Vec2 {
    Vec2::new(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x)
}

/// Joins transforms to ones that are twice as long: `input [2 * part]`, `output [2 * part]`, complex numbers.
#[kernel(threads(256), over(params.part))]
pub fn fft_pass(id: Invocation, params: &FftParams, input: Read<Vec2>, output: Write<Vec2>) {
    let index = id.index();
    if index < params.part {
        let k = index % params.done;
        let angle = params.sign * PI * k as f32 / params.done as f32;
        let turn = Vec2::new(math::cos(angle), math::sin(angle));
        let a = input.read(index);
        let b = times(input.read(index + params.part), turn);
        let to = (index - k) * 2 + k;
        output.write(to, a + b);
        output.write(to + params.done, a - b);
    }
}

/// Joins transforms to ones that are four times as long, as two passes of [`fft_pass`] do: `input [4 * part]`, `output [4 * part]`.
/// It reads and writes memory once, and takes a quarter of the sines.
#[kernel(threads(256), over(params.part))]
pub fn fft_pass_4(id: Invocation, params: &FftParams, input: Read<Vec2>, output: Write<Vec2>) {
    let index = id.index();
    if index < params.part {
        let k = index % params.done;
        let angle = params.sign * (0.5 * PI) * k as f32 / params.done as f32;
        let turn = Vec2::new(math::cos(angle), math::sin(angle));
        let twice = times(turn, turn);
        let a = input.read(index);
        let b = times(input.read(index + params.part), turn);
        let c = times(input.read(index + 2 * params.part), twice);
        let d = times(input.read(index + 3 * params.part), times(twice, turn));
        // a quarter of a turn multiplies with i
        let apart = (b - d) * params.sign;
        let quarter = Vec2::new(-apart.y, apart.x);
        let to = (index - k) * 4 + k;
        output.write(to, (a + c) + (b + d));
        output.write(to + params.done, (a - c) + quarter);
        output.write(to + 2 * params.done, (a + c) - (b + d));
        output.write(to + 3 * params.done, (a - c) - quarter);
    }
}
