//! The functions of [`math`](muslin::math) that state an error: a device's own errors are measured with this kernel.

use muslin::math::{abs, clamp, cos, floor, ln, mix, pow, round, sin, tan};
use muslin::prelude::*;

/// Functions of [`elementary`], in the order of its rows.
pub const FUNCTIONS: [&str; 10] =
    ["sin", "cos", "tan", "ln", "pow", "floor", "round", "abs", "clamp", "mix"];

/// Invocations of a workgroup.
const WORKGROUP: u32 = 64;

/// Parameters of [`elementary`].
#[params]
pub struct ElementaryParams {
    /// Numbers.
    pub count: u32,
}

/// `output [10, count]`: each of the [`FUNCTIONS`] of `x`, the logarithm of `positive`, `positive^y`, `x` clamped to 0 and 1, and
/// between `x` and `y` the place `positive`.
#[kernel(threads(WORKGROUP))]
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
        output.write(2 * count + index, tan(x));
        output.write(3 * count + index, ln(positive));
        output.write(4 * count + index, pow(positive, y));
        output.write(5 * count + index, floor(x));
        output.write(6 * count + index, round(x));
        output.write(7 * count + index, abs(x));
        output.write(8 * count + index, clamp(x, 0.0, 1.0));
        output.write(9 * count + index, mix(x, y, positive));
    }
}
