//! The functions of [`math`](muslin::math) that state an error: a device's own errors are measured with this kernel.

use muslin::math::{abs, atan, atan2, clamp, cos, floor, ln, pow, round, sin, tanh};
use muslin::prelude::*;

/// Functions of [`elementary`], in the order of its rows.
pub const FUNCTIONS: [&str; 11] =
    ["sin", "cos", "ln", "pow", "floor", "round", "abs", "clamp", "atan", "atan2", "tanh"];

/// Invocations of a workgroup.
const WORKGROUP: u32 = 64;

/// Parameters of [`elementary`].
#[params]
pub struct ElementaryParams {
    /// Numbers.
    pub count: u32,
}

/// `output [11, count]`: each of the [`FUNCTIONS`] of `x`, the logarithm of `positive`, `positive^y`, `x` clamped to 0 and 1, the
/// angle of the point (x, -10 - y), and tanh of `y`.
#[kernel(threads(WORKGROUP), over(params.count))]
pub fn elementary(
    id: Invocation,
    params: &ElementaryParams,
    x: Read<f32>,
    y: Read<f32>,
    positive: Read<f32>,
    output: Write<f32>,
) {
    let index = id.index();
    let count = params.count;
    if index < count {
        let x = x.read(index);
        let y = y.read(index);
        let positive = positive.read(index);
        output.write(index, sin(x));
        output.write(count + index, cos(x));
        output.write(2 * count + index, ln(positive));
        output.write(3 * count + index, pow(positive, y));
        output.write(4 * count + index, floor(x));
        output.write(5 * count + index, round(x));
        output.write(6 * count + index, abs(x));
        output.write(7 * count + index, clamp(x, 0.0, 1.0));
        output.write(8 * count + index, atan(x));
        output.write(9 * count + index, atan2(-10.0 - y, x));
        output.write(10 * count + index, tanh(y));
    }
}
