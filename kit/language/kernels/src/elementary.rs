//! The functions of [`math`](muslin::math) that state an error: a device's own errors are measured with this kernel.

use muslin::math::*;
use muslin::prelude::*;

use crate::{CountParams, rows};

/// Invocations of a workgroup.
const WORKGROUP: u32 = 64;

macro_rules! functions {
    ([$x:ident, $y:ident, $p:ident]; $($name:literal: $value:expr,)*) => {
        /// Functions of [`elementary`], in the order of its rows.
        pub const FUNCTIONS: &[&str] = &[$($name),*];

        /// `output [FUNCTIONS, count]`: each of the functions of `x`, of `y`, which is small, and of `positive`, all `[count]`.
        #[kernel(threads(WORKGROUP), over(params.count))]
        pub fn elementary(
            id: Invocation,
            params: &CountParams,
            x: Read<f32>,
            y: Read<f32>,
            positive: Read<f32>,
            output: Write<f32>,
        ) {
            let index = id.index();
            if index < params.count {
                let [$x, $y, $p] = [x.read(index), y.read(index), positive.read(index)];
                rows! { output [params.count] at index; $($value,)* }
            }
        }
    };
}

functions! { [x, y, p];
    "sin": sin(x),
    "cos": cos(x),
    "tan": tan(x),
    "ln": ln(p),
    "log2": log2(p),
    "pow": pow(p, y),
    "exp2": exp2(y),
    "floor": floor(x),
    "fract": fract(x),
    "round": round(x),
    "round_even": round_even(x),
    "truncate": truncate(x),
    "ceil": ceil(x),
    "abs": abs(x),
    "sign": sign(x),
    "clamp": clamp(x, 0.0, 1.0),
    "step": step(y, x),
    "smoothstep": smoothstep(-2.0, 3.0, y),
    "mix": mix(x, y, p),
    "min and max": min(x, y) + 2.0 * max(x, y),
    "inverse_sqrt": inverse_sqrt(p),
    "asin": asin(y),
    "acos": acos(y),
    "atan": atan(x),
    "atan2": atan2(-10.0 - y, x),
    "sinh": sinh(y),
    "sinh of large": sinh(10.0 * y),
    "cosh": cosh(y),
    "cosh of large": cosh(10.0 * y),
    "tanh": tanh(y),
    "asinh": asinh(x),
    "asinh of small": asinh(0.125 * y),
    "acosh": acosh(p),
    "atanh": atanh(0.0625 * y),
    "atanh of large": atanh(0.124 * y),
    "sigmoid": sigmoid(y),
    "log_sigmoid": log_sigmoid(y),
    "ldexp": ldexp(p, x as i32 % 20),
    "frexp": {
        let (fraction, exponent) = frexp(p);
        fraction + exponent as f32
    },
    "to_degrees": y.to_degrees(),
    "to_radians": x.to_radians(),
    "quantize_to_half": quantize_to_half(x),
    "the lower half": unpack_half_2x16(pack_half_2x16(Vec2::new(p, x))).x,
    "the upper half": unpack_half_2x16(pack_half_2x16(Vec2::new(p, x))).y,
    "unpack_unorm_4x8": unpack_unorm_4x8(pack_unorm_4x8(Vec4::new(p, y, x, 0.25 * y))).w,
    "unpack_snorm_4x8": unpack_snorm_4x8(pack_snorm_4x8(Vec4::new(p, y, 0.25 * y, x))).z,
    "unpack_unorm_2x16": unpack_unorm_2x16(pack_unorm_2x16(Vec2::new(0.25 * y, x))).x,
    "unpack_snorm_2x16": unpack_snorm_2x16(pack_snorm_2x16(Vec2::new(x, 0.25 * y))).y,
}
