//! The discrete Fourier transform, in passes (Stockham).

use core::f32::consts::PI;

use muslin::{math, prelude::*};

/// Parameters of [`fft_pass`].
#[params]
pub struct FftParams {
    /// Half of the values: a power of two.
    pub half: u32,
    /// Values of the transforms that are done: 1, 2, 4, ...
    pub done: u32,
    /// -1 for the transform, and 1 for its inverse.
    pub sign: f32,
}

/// Joins transforms to ones that are twice as long: `input [2 * half]`, `output [2 * half]`, complex numbers.
#[kernel(threads(256), over(params.half))]
pub fn fft_pass(id: Invocation, params: &FftParams, input: Read<Vec2>, output: Write<Vec2>) {
    let index = id.index();
    if index < params.half {
        let k = index % params.done;
        let angle = params.sign * PI * k as f32 / params.done as f32;
        let turn = Vec2::new(math::cos(angle), math::sin(angle));
        let a = input.read(index);
        let b = input.read(index + params.half);
        let b = Vec2::new(b.x * turn.x - b.y * turn.y, b.x * turn.y + b.y * turn.x);
        let to = (index - k) * 2 + k;
        output.write(to, a + b);
        output.write(to + params.done, a - b);
    }
}
