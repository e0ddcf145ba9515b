//! Several small numbers in a word, the first in the lowest bits: halves, integers of 8 bits, and fractions of 8 and 16 bits.
//!
//! Words have the layouts of WGSL's `pack2x16float`, `pack4x8unorm`, `pack4x8snorm` and so on, and of vertex formats. These are integer operations, sums
//! and products: all devices give the same bits, unless the kernel is `fused` or a driver fuses what naga gave it. NaN becomes 0, but in a half.

use glam::{IVec4, UVec4, Vec2, Vec4};

use crate::half::{half_bits, half_value};
use crate::math::{clamp, floor, to_u32};

/// Two numbers as the nearest [halves](half_bits), as `pack2x16float` of WGSL.
#[inline(always)]
pub fn pack_half_2x16(v: Vec2) -> u32 {
    half_bits(v.x) | half_bits(v.y) << 16
}

/// The values of two halves, as `unpack2x16float` of WGSL.
#[inline(always)]
pub fn unpack_half_2x16(word: u32) -> Vec2 {
    Vec2::new(half_value(word & 0xffff), half_value(word >> 16))
}

/// The nearest half, as `quantizeToF16` of WGSL; infinite from 65,520 on.
#[inline(always)]
pub fn quantize_to_half(x: f32) -> f32 {
    half_value(half_bits(x))
}

/// The nearest of `max + 1` fractions from 0 to 1, of two the larger.
#[inline(always)]
fn unorm(x: f32, max: f32) -> u32 {
    to_u32(clamp(x, 0.0, 1.0) * max + 0.5)
}

/// The nearest of `2 max + 1` fractions from -1 to 1, of two the larger, in two's complement.
#[inline(always)]
fn snorm(x: f32, max: f32) -> u32 {
    let nearest = floor(clamp(x, -1.0, 1.0) * max + 0.5);
    to_u32(nearest + max).wrapping_sub(max as u32)
}

/// The value of a fraction from -1 to 1 whose sign is the highest bit of a word. -1 has two codes.
#[inline(always)]
fn signed(code: u32, unused: u32, max: f32) -> f32 {
    let value = (code as i32 >> unused) as f32 * (1.0 / max);
    if value < -1.0 { -1.0 } else { value }
}

/// Four numbers from 0 to 1, which are clamped, as bytes `floor(255 x + 0.5)`: `pack4x8unorm` of WGSL.
#[inline(always)]
pub fn pack_unorm_4x8(v: Vec4) -> u32 {
    let [x, y, z, w] = [unorm(v.x, 255.0), unorm(v.y, 255.0), unorm(v.z, 255.0), unorm(v.w, 255.0)];
    x | y << 8 | z << 16 | w << 24
}

/// Four numbers from 0 to 1, to 1.2e-7, of bytes: `unpack4x8unorm` of WGSL. 255 is 1.
#[inline(always)]
pub fn unpack_unorm_4x8(word: u32) -> Vec4 {
    let UVec4 { x, y, z, w } = unpack_unsigned_4x8(word);
    Vec4::new(x as f32, y as f32, z as f32, w as f32) * (1.0 / 255.0)
}

/// Four numbers from -1 to 1, which are clamped, as signed bytes `floor(127 x + 0.5)`: `pack4x8snorm` of WGSL.
#[inline(always)]
pub fn pack_snorm_4x8(v: Vec4) -> u32 {
    let [x, y, z, w] = [snorm(v.x, 127.0), snorm(v.y, 127.0), snorm(v.z, 127.0), snorm(v.w, 127.0)];
    x & 0xff | (y & 0xff) << 8 | (z & 0xff) << 16 | w << 24
}

/// Four numbers from -1 to 1, to 1.2e-7, of signed bytes: `unpack4x8snorm` of WGSL. -127 and -128 are -1.
#[inline(always)]
pub fn unpack_snorm_4x8(word: u32) -> Vec4 {
    let of = |left: u32| signed(word << left, 24, 127.0);
    Vec4::new(of(24), of(16), of(8), of(0))
}

/// Two numbers from 0 to 1, which are clamped, as 16 bits `floor(65,535 x + 0.5)`: `pack2x16unorm` of WGSL.
#[inline(always)]
pub fn pack_unorm_2x16(v: Vec2) -> u32 {
    unorm(v.x, 65_535.0) | unorm(v.y, 65_535.0) << 16
}

/// Two numbers from 0 to 1, to 1.2e-7, of 16 bits: `unpack2x16unorm` of WGSL. 65,535 is 1.
#[inline(always)]
pub fn unpack_unorm_2x16(word: u32) -> Vec2 {
    Vec2::new((word & 0xffff) as f32, (word >> 16) as f32) * (1.0 / 65_535.0)
}

/// Two numbers from -1 to 1, which are clamped, as signed integers of 16 bits `floor(32,767 x + 0.5)`: `pack2x16snorm` of WGSL.
#[inline(always)]
pub fn pack_snorm_2x16(v: Vec2) -> u32 {
    snorm(v.x, 32_767.0) & 0xffff | snorm(v.y, 32_767.0) << 16
}

/// Two numbers from -1 to 1, to 1.2e-7, of signed integers of 16 bits: `unpack2x16snorm` of WGSL. -32,767 and -32,768 are -1.
#[inline(always)]
pub fn unpack_snorm_2x16(word: u32) -> Vec2 {
    Vec2::new(signed(word << 16, 16, 32_767.0), signed(word, 16, 32_767.0))
}

/// The lower 8 bits of four integers: `pack4xU8` and `pack4xI8` of WGSL.
#[inline(always)]
pub fn pack_4x8(v: UVec4) -> u32 {
    v.x & 0xff | (v.y & 0xff) << 8 | (v.z & 0xff) << 16 | v.w << 24
}

/// Four bytes: `unpack4xU8` of WGSL.
#[inline(always)]
pub fn unpack_unsigned_4x8(word: u32) -> UVec4 {
    UVec4::new(word & 0xff, word >> 8 & 0xff, word >> 16 & 0xff, word >> 24)
}

/// Four signed bytes: `unpack4xI8` of WGSL.
#[inline(always)]
pub fn unpack_signed_4x8(word: u32) -> IVec4 {
    let of = |left: u32| (word << left) as i32 >> 24;
    IVec4::new(of(24), of(16), of(8), of(0))
}
