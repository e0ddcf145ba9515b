//! Methods of vectors that could become instructions of which GLSL leaves something open, such as where `Round` has halves.

use muslin::math;
use muslin::prelude::*;

use crate::rows;

/// Parameters of [`vector_methods`].
#[params]
pub struct VectorParams {
    /// Pairs of vectors.
    pub count: u32,
}

macro_rules! vectors {
    ([$x:ident, $y:ident]; $($method:literal: $value:expr,)*) => {
        /// The rows of [`vector_methods`].
        pub const METHODS: &[&str] = &[$($method),*];

        /// `bits [rows, count]`: one element of each method of `x` and `y`, both `[count]`.
        #[kernel(threads(64), over(params.count))]
        pub fn vector_methods(
            id: Invocation,
            params: &VectorParams,
            x: Read<Vec4>,
            y: Read<Vec4>,
            bits: Write<u32>,
        ) {
            let index = id.index();
            if index < params.count {
                let [$x, $y] = [x.read(index), y.read(index)];
                rows! { bits [params.count] at index; $(f32::to_bits($value),)* }
            }
        }
    };
}

vectors! { [x, y];
    "round": x.round().x,
    "round of Vec3": x.truncate().round().z,
    "floor": x.floor().y,
    "ceil": x.ceil().z,
    "trunc": x.trunc().w,
    "fract": x.fract().x,
    "fract_gl": x.fract_gl().y,
    "abs": x.abs().z,
    "signum": x.signum().w,
    "copysign": x.copysign(y).x,
    "step": y.step(x).y,
    "min": x.min(y).x,
    "max": x.max(y).x,
    "clamp": x.clamp(Vec4::splat(-1.0), Vec4::splat(1.5)).y,
    "saturate": x.saturate().z,
    "min_element": (x + y).min_element(),
    "max_element": (x - y).max_element(),
    "select": Vec4::select(x.cmpge(y), x, y).w,
    "is_finite": x.is_finite() as u32 as f32,
    "is_negative_bitmask": x.is_negative_bitmask() as f32,
    "normalize_or_zero": {
        let size = Vec4::new(x.x, 0.0, 0.0, 0.0).normalize_or_zero().x;
        // the rest depends on the roundings of a device
        math::round(size * 8.0)
    },
    "try_normalize": x.try_normalize().is_some() as u32 as f32,
    "as_ivec4": x.clamp(Vec4::splat(-1e6), Vec4::splat(1e6)).as_ivec4().x as f32,
    "math::round": math::round(x.x),
    "math::floor": math::floor(x.y),
    "math::ceil": math::ceil(x.z),
    "math::truncate": math::truncate(x.w),
}
