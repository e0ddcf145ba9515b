//! The functions of [`math`](muslin::math) that state an error: a device's own errors are measured with this kernel.

use muslin::math::{
    abs, acos, asin, atan, atan2, clamp, cos, exp2, floor, ln, log2, mix, pack_halves, pow, round,
    sin, tan, tanh, unpack_halves,
};
use muslin::prelude::*;

/// Functions of [`elementary`], in the order of its rows.
pub const FUNCTIONS: [&str; 19] = [
    "sin",
    "cos",
    "tan",
    "ln",
    "pow",
    "floor",
    "round",
    "abs",
    "clamp",
    "mix",
    "asin",
    "acos",
    "atan",
    "atan2",
    "exp2",
    "log2",
    "tanh",
    "pack_halves",
    "unpack_halves",
];

/// Invocations of a workgroup.
const WORKGROUP: u32 = 64;

/// Parameters of [`elementary`].
#[params]
pub struct ElementaryParams {
    /// Numbers.
    pub count: u32,
}

/// `output [19, count]`: each of the [`FUNCTIONS`] of `x`, the logarithms of `positive`, `positive^y`, `x` clamped to 0 and 1,
/// between `x` and `y` the place `positive`, the inverses of sine and cosine, 2^y and tanh of `y`, the angle of the point (x, -10 - y), and halves of `positive` and `x`.
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
        output.write(2 * count + index, tan(x));
        output.write(3 * count + index, ln(positive));
        output.write(4 * count + index, pow(positive, y));
        output.write(5 * count + index, floor(x));
        output.write(6 * count + index, round(x));
        output.write(7 * count + index, abs(x));
        output.write(8 * count + index, clamp(x, 0.0, 1.0));
        output.write(9 * count + index, mix(x, y, positive));
        output.write(10 * count + index, asin(y));
        output.write(11 * count + index, acos(y));
        output.write(12 * count + index, atan(x));
        output.write(13 * count + index, atan2(-10.0 - y, x));
        output.write(14 * count + index, exp2(y));
        output.write(15 * count + index, log2(positive));
        output.write(16 * count + index, tanh(y));
        let [first, second] = unpack_halves(pack_halves([positive, x]));
        output.write(17 * count + index, first);
        output.write(18 * count + index, second);
    }
}
