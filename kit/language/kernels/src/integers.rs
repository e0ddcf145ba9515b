//! Functions of integers and of packed numbers, which have the same bits on all devices.

use muslin::half::half_bits;
use muslin::math::*;
use muslin::prelude::*;

use crate::{CountParams, rows};

macro_rules! functions {
    ([$u:ident, $v:ident, $x:ident, $y:ident]; $($name:literal: $value:expr,)*) => {
        /// Functions of [`integer_functions`], in the order of its rows.
        pub const FUNCTIONS: &[&str] = &[$($name),*];

        /// `words [FUNCTIONS, count]`: each function of `u`, `v`, `x` and `y`, all `[count]`.
        #[kernel(threads(64), over(params.count))]
        pub fn integer_functions(
            id: Invocation,
            params: &CountParams,
            u: Read<u32>,
            v: Read<u32>,
            x: Read<f32>,
            y: Read<f32>,
            words: Write<u32>,
        ) {
            let index = id.index();
            if index < params.count {
                let [$u, $v] = [u.read(index), v.read(index)];
                let [$x, $y] = [x.read(index), y.read(index)];
                rows! { words [params.count] at index; $($value,)* }
            }
        }
    };
}

functions! { [u, v, x, y];
    "saturating_add": saturating_add(u, v),
    "saturating_sub": saturating_sub(u, v),
    "saturating_add of i32": saturating_add(u as i32, v as i32) as u32,
    "saturating_sub of i32": saturating_sub(u as i32, v as i32) as u32,
    "saturating_add of u8": saturating_add(u as u8, v as u8) as u32,
    "saturating_sub of i16": saturating_sub(u as i16, v as i16) as i32 as u32,
    "isqrt": isqrt(u),
    "multiply_high": multiply_high(u, v),
    "extract_bits": extract_bits(u, v % 40, v / 64 % 40),
    "extract_bits of i32": extract_bits(u as i32, v % 40, v / 64 % 40) as u32,
    "insert_bits": insert_bits(u, v, v % 40, v / 64 % 40),
    "insert_bits of i32": insert_bits(u as i32, v as i32, v % 40, v / 64 % 40) as u32,
    "count_ones": u.count_ones(),
    "leading_zeros": u.leading_zeros(),
    "trailing_zeros": u.trailing_zeros(),
    "reverse_bits": u.reverse_bits(),
    "dot_unsigned_4x8": dot_unsigned_4x8(u, v),
    "dot_signed_4x8": dot_signed_4x8(u, v) as u32,
    "pack_4x8": pack_4x8(UVec4::new(u, v, u >> 8, v >> 16)),
    "unpack_unsigned_4x8": {
        let UVec4 { x, y, z, w } = unpack_unsigned_4x8(u);
        x + 3 * y + 5 * z + 7 * w
    },
    "unpack_signed_4x8": {
        let IVec4 { x, y, z, w } = unpack_signed_4x8(u);
        (x + 3 * y + 5 * z + 7 * w) as u32
    },
    "half_bits": half_bits(x),
    "pack_half_2x16": pack_half_2x16(Vec2::new(x, y)),
    "unpack_half_2x16": {
        // what is a number, and no denormal
        let Vec2 { x, y } = unpack_half_2x16(u & 0xbbff_bbff | 0x0400_0400);
        half_bits(x) | half_bits(y) << 16
    },
    "pack_unorm_4x8": pack_unorm_4x8(Vec4::new(x, y, 1.0 - x, -y)),
    "pack_snorm_4x8": pack_snorm_4x8(Vec4::new(x, y, 1.0 - x, -y)),
    "pack_unorm_2x16": pack_unorm_2x16(Vec2::new(x, -y)),
    "pack_snorm_2x16": pack_snorm_2x16(Vec2::new(-x, y)),
    "repacked unorm_4x8": pack_unorm_4x8(unpack_unorm_4x8(u)),
    "repacked snorm_4x8": pack_snorm_4x8(unpack_snorm_4x8(u)),
    "repacked unorm_2x16": pack_unorm_2x16(unpack_unorm_2x16(u)),
    "repacked snorm_2x16": pack_snorm_2x16(unpack_snorm_2x16(u)),
}
