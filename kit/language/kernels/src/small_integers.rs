//! The methods of integers of 8 and 16 bits, which GPUs lack.

// the methods of core are what it is for
#![allow(clippy::unnecessary_cast, clippy::useless_conversion)]

use muslin::math;
use muslin::prelude::*;

use crate::rows;

/// Parameters of the kernels of this module.
#[params]
pub struct SmallParams {
    /// Pairs of integers.
    pub count: u32,
}

/// What stands for `None`.
const NONE: u32 = 0x1234_5678;

/// A kernel that computes rows of x and y, which are integers of a type, and n, which are all bits of y.
macro_rules! table {
    (
        $kernel:ident, $methods:ident, $t:ident, [$x:ident, $y:ident, $n:ident];
        $($method:literal: $value:expr,)*
    ) => {
        #[doc = concat!("The rows of [`", stringify!($kernel), "`].")]
        pub const $methods: &[&str] = &[$($method),*];

        #[doc = concat!("`output [rows, count]`: each method of `", stringify!($t), "`, of the low bits of `x` and `y`, both `[count]`.")]
        #[kernel(threads(64), over(params.count))]
        pub fn $kernel(id: Invocation, params: &SmallParams, x: Read<u32>, y: Read<u32>, output: Write<u32>) {
            let index = id.index();
            if index < params.count {
                let $n = y.read(index);
                let [$x, $y] = [x.read(index) as $t, $n as $t];
                rows! { output [params.count] at index; $(($value) as u32,)* }
            }
        }
    };
}

/// What all four types have; `$same` has as many bits, with or without a sign as the type has not.
macro_rules! integers {
    (
        $kernel:ident, $methods:ident, $t:ident, $same:ident, [$x:ident, $y:ident, $n:ident];
        $($more:literal: $value:expr,)*
    ) => {
        table! { $kernel, $methods, $t, [$x, $y, $n];
            "count_ones": $x.count_ones(),
            "count_zeros": $x.count_zeros(),
            "leading_zeros": $x.leading_zeros(),
            "leading_ones": $x.leading_ones(),
            "trailing_zeros": $x.trailing_zeros(),
            "trailing_ones": $x.trailing_ones(),
            "rotate_left": $x.rotate_left($n),
            "rotate_right": $x.rotate_right($n),
            "rotate_left(27)": $x.rotate_left(27),
            "rotate_right(5)": $x.rotate_right(5),
            "swap_bytes": $x.swap_bytes(),
            "reverse_bits": $x.reverse_bits(),
            "to_be": $x.to_be(),
            "from_be": $t::from_be($x),
            "wrapping_add": $x.wrapping_add($y),
            "wrapping_sub": $x.wrapping_sub($y),
            "wrapping_mul": $x.wrapping_mul($y),
            "wrapping_neg": $x.wrapping_neg(),
            "wrapping_shl": $x.wrapping_shl($n),
            "wrapping_shr": $x.wrapping_shr($n),
            "checked_add": $x.checked_add($y).map_or(NONE, |x| x as u32),
            "checked_sub": $x.checked_sub($y).map_or(NONE, |x| x as u32),
            "checked_add(0)": $x.checked_add(0).map_or(NONE, |x| x as u32),
            "checked_sub(0)": $x.checked_sub(0).map_or(NONE, |x| x as u32),
            "checked_sub(MIN)": $x.checked_sub($t::MIN).map_or(NONE, |x| x as u32),
            "0.checked_sub": (0 as $t).checked_sub($x).map_or(NONE, |x| x as u32),
            "checked_neg": $x.checked_neg().map_or(NONE, |x| x as u32),
            "checked_shl": $x.checked_shl($n).map_or(NONE, |x| x as u32),
            "checked_shr": $x.checked_shr($n).map_or(NONE, |x| x as u32),
            "overflowing_add": $x.overflowing_add($y).0 as u32 ^ ($x.overflowing_add($y).1 as u32) << 31,
            "overflowing_sub": $x.overflowing_sub($y).0 as u32 ^ ($x.overflowing_sub($y).1 as u32) << 31,
            "overflowing_neg": $x.overflowing_neg().0 as u32 ^ ($x.overflowing_neg().1 as u32) << 31,
            "overflowing_shl": $x.overflowing_shl($n).0 as u32 ^ ($x.overflowing_shl($n).1 as u32) << 31,
            "overflowing_shr": $x.overflowing_shr($n).0 as u32 ^ ($x.overflowing_shr($n).1 as u32) << 31,
            "checked_div": $x.checked_div($y).map_or(NONE, |x| x as u32),
            "checked_rem": $x.checked_rem($y).map_or(NONE, |x| x as u32),
            "checked_div_euclid": $x.checked_div_euclid($y).map_or(NONE, |x| x as u32),
            "checked_rem_euclid": $x.checked_rem_euclid($y).map_or(NONE, |x| x as u32),
            "wrapping_div": $x.wrapping_div($y | 1),
            "wrapping_rem": $x.wrapping_rem($y | 1),
            "wrapping_div_euclid": $x.wrapping_div_euclid($y | 1),
            "wrapping_rem_euclid": $x.wrapping_rem_euclid($y | 1),
            "overflowing_div": $x.overflowing_div($y | 1).1,
            "overflowing_rem": $x.overflowing_rem($y | 1).1,
            "unbounded_shl": $x.unbounded_shl($n),
            "unbounded_shr": $x.unbounded_shr($n),
            "saturating_add": math::saturating_add($x, $y),
            "saturating_sub": math::saturating_sub($x, $y),
            "abs_diff": $x.abs_diff($y),
            "min": $x.min($y),
            "max": $x.max($y),
            "clamp": $x.clamp(5, 100),
            "cmp": $x.cmp(&$y) as i32,
            "<": $x < $y,
            "<=": $x <= $y,
            ">": $x > $y,
            ">=": $x >= $y,
            "==": $x == $y,
            "!=": $x != $y,
            "!": !$x,
            "& | ^": ($x & $y) ^ (($x | $y) << 1),
            "<<": $x << ($n % $t::BITS),
            ">>": $x >> ($n % $t::BITS),
            ">> 3": $x >> 3,
            "as u8": $x as u8,
            "as i8": $x as i8,
            "as u16": $x as u16,
            "as i16": $x as i16,
            "as i32": $x as i32,
            "as other": $x as $same,
            "as f32": ($x as f32).to_bits(),
            "of f32": ($n as i32 as f32 * 0.5) as $t,
            "of large f32": f32::from_bits($n & 0xcfff_ffff) as $t,
            "u32 as leading_zeros": ($x as u32).leading_zeros(),
            "u32 | 1 as ilog2": ($x as u32 | 1).ilog2(),
            "u32 as next_power_of_two": (($x as u32) & 0xff).next_power_of_two(),
            "match": match $x {
                0 => 1,
                1..=9 => 2,
                $t::MAX => 3,
                _ => 4,
            },
            "Wrapping": (core::num::Wrapping($x) * core::num::Wrapping($y) - core::num::Wrapping(3)).0,
            "checked_ilog10": $x.checked_ilog10().unwrap_or(77),
            "try_from": $t::try_from($n as i32).map_or(NONE, |x| x as u32),
            "array": [$x, $y, 3, 4][$n as usize % 4],
            "Option": Some($x).filter(|x| *x > $y).unwrap_or(7),
            $($more: $value,)*
        }
    };
}

/// What both types without sign have.
macro_rules! unsigned {
    (
        $kernel:ident, $methods:ident, $t:ident, $same:ident, [$x:ident, $y:ident, $n:ident];
        $($more:literal: $value:expr,)*
    ) => {
        integers! { $kernel, $methods, $t, $same, [$x, $y, $n];
            "/": $x / ($y | 1),
            "%": $x % ($y | 1),
            "div_euclid": $x.div_euclid($y | 1),
            "rem_euclid": $x.rem_euclid($y | 1),
            "div_ceil": $x.div_ceil($y | 1),
            "is_multiple_of": $x.is_multiple_of($y),
            "is_power_of_two": $x.is_power_of_two(),
            "checked_next_multiple_of": $x.checked_next_multiple_of($y | 1).map_or(NONE, |x| x as u32),
            "checked_add_signed": $x.checked_add_signed($y as $same).map_or(NONE, |x| x as u32),
            "wrapping_add_signed": $x.wrapping_add_signed($y as $same),
            "overflowing_add_signed": $x.overflowing_add_signed($y as $same).1,
            "cast_signed": $x.cast_signed(),
            "u32::from": u32::from($x),
            "carrying_add": $x.carrying_add($y, $n & 64 != 0).0 as u32 ^ ($x.carrying_add($y, $n & 64 != 0).1 as u32) << 31,
            "borrowing_sub": $x.borrowing_sub($y, $n & 64 != 0).0 as u32 ^ ($x.borrowing_sub($y, $n & 64 != 0).1 as u32) << 31,
            $($more: $value,)*
        }
    };
}

/// What both types with a sign have.
macro_rules! signed {
    ($kernel:ident, $methods:ident, $t:ident, $same:ident) => {
        integers! { $kernel, $methods, $t, $same, [x, y, n];
            "wrapping_abs": x.wrapping_abs(),
            "unsigned_abs": x.unsigned_abs(),
            "checked_abs": x.checked_abs().map_or(NONE, |x| x as u32),
            "overflowing_abs": x.overflowing_abs().1,
            "signum": x.signum(),
            "is_negative": x.is_negative() as u32 + 2 * x.is_positive() as u32,
            "/": (x as i32 / (y | 1) as i32) as $t,
            "% 7": x % 7,
            "/ 7": x / 7,
            "rem_euclid": x.rem_euclid(7),
            "div_euclid": x.div_euclid(7),
            "checked_add_unsigned": x.checked_add_unsigned(y as $same).map_or(NONE, |x| x as u32),
            "checked_sub_unsigned": x.checked_sub_unsigned(y as $same).map_or(NONE, |x| x as u32),
            "wrapping_add_unsigned": x.wrapping_add_unsigned(y as $same),
            "cast_unsigned": x.cast_unsigned(),
            "i32::from": i32::from(x),
        }
    };
}

unsigned! { u8_methods, U8_METHODS, u8, i8, [x, y, n];
    "is_ascii": x.is_ascii(),
    "is_ascii_alphabetic": x.is_ascii_alphabetic(),
    "is_ascii_alphanumeric": x.is_ascii_alphanumeric(),
    "is_ascii_digit": x.is_ascii_digit(),
    "is_ascii_hexdigit": x.is_ascii_hexdigit(),
    "is_ascii_punctuation": x.is_ascii_punctuation(),
    "is_ascii_whitespace": x.is_ascii_whitespace(),
    "is_ascii_control": x.is_ascii_control(),
    "to_ascii_uppercase": x.to_ascii_uppercase(),
    "to_ascii_lowercase": x.to_ascii_lowercase(),
    "eq_ignore_ascii_case": x.eq_ignore_ascii_case(&y),
}
unsigned! { u16_methods, U16_METHODS, u16, i16, [x, y, n]; }
signed!(i8_methods, I8_METHODS, i8, u8);
signed!(i16_methods, I16_METHODS, i16, u16);
