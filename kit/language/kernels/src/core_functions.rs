//! What kernels take of Rust and of its core library: a device's values are compared with the CPU's, where core computes them.

// the functions of core are what it is for
#![allow(clippy::obfuscated_if_else, clippy::collapsible_match)]

use core::cmp::Ordering;

use muslin::math;
use muslin::prelude::*;

use crate::CountParams;

/// Rows of [`core_functions`].
pub const ROWS: u32 = 112;

/// Invocations of a workgroup.
pub const WORKGROUP: usize = 64;

/// An enum without `#[repr(u32)]`: GPUs have no integers of 8 bits.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Mood {
    Bad = -3,
    Fine = 0,
    Good = 100,
}

/// An enum with data.
#[derive(Clone, Copy, PartialEq)]
enum Shape {
    Nothing,
    Ball(f32),
    Box { width: f32, height: f32 },
    Pair(f32, i32),
}

/// An array that is a field.
struct Shapes {
    all: [Shape; 3],
}

/// Arguments of a function.
#[derive(Clone, Copy)]
struct Arguments {
    u: u32,
    v: u32,
    x: f32,
    y: f32,
}

/// `output [ROWS, count]`: each function of `u`, `v`, `x` and `y`, all `[count]`.
#[kernel(threads(WORKGROUP), over(params.count * ROWS), iterations = 20)]
pub fn core_functions(
    id: Invocation,
    params: &CountParams,
    u: Read<u32>,
    v: Read<u32>,
    x: Read<f32>,
    y: Read<f32>,
    output: Write<u32>,
    is_third: Shared<u32, WORKGROUP>,
) {
    let own = id.local.x;
    is_third.write(own, own.is_multiple_of(3) as u32);
    id.barrier();
    let index = id.index();
    if index >= params.count * ROWS {
        return;
    }
    let row = index / params.count;
    if row == 0 {
        output.write(index, is_third.read(own ^ 1));
        return;
    }
    let at = index % params.count;
    let of = Arguments { u: u.read(at), v: v.read(at), x: x.read(at), y: y.read(at) };
    output.write(index, value(row, of));
}

/// A function's value.
#[inline(always)]
fn value(row: u32, of: Arguments) -> u32 {
    match row {
        1..=34 => of_unsigned(row, of.u, of.v),
        35..=49 => of_signed(row, of.u as i32, of.v as i32),
        50..=62 => of_floats(row, of.x, of.y),
        63..=83 => of_language(row, of.u, of.v),
        84..=89 => of_small(row, of.u as i32, of.v as i32),
        90..=93 => of_math(row, of),
        111 => of_enums(of.u, of.v),
        _ => of_remainders_and_overflow(row, of.u as i32, of.v as i32),
    }
}

#[inline(always)]
fn of_unsigned(row: u32, u: u32, v: u32) -> u32 {
    let n = v % 32;
    match row {
        1 => u.min(v),
        2 => u.max(v),
        3 => u.clamp(5, 1000),
        4 => u.abs_diff(v),
        5 => u.count_ones() + 100 * u.count_zeros(),
        6 => u.leading_zeros() + 100 * u.trailing_zeros(),
        7 => u.leading_ones() + 100 * u.trailing_ones(),
        8 => u.rotate_left(n),
        9 => u.rotate_right(n),
        10 => u.swap_bytes(),
        11 => u.reverse_bits(),
        12 => u.wrapping_add(v),
        13 => u.wrapping_sub(v),
        14 => u.wrapping_mul(v),
        15 => u.wrapping_neg(),
        16 => u.wrapping_shl(v),
        17 => u.wrapping_shr(v),
        18 => u.checked_add(v).unwrap_or(77),
        19 => u.checked_sub(v).unwrap_or(77),
        20 => u.checked_div(v).unwrap_or(77),
        21 => u.checked_rem(v).unwrap_or(77),
        22 => u.checked_shl(v % 64).unwrap_or(77),
        23 => u.overflowing_add(v).0,
        24 => u.overflowing_sub(v).1 as u32,
        25 => u.is_power_of_two() as u32,
        26 => (u % 1000).next_power_of_two(),
        27 => u.div_ceil(v | 1),
        28 => (u % 1000).next_multiple_of(7),
        29 => (u | 1).ilog2(),
        30 => u.cast_signed().cast_unsigned(),
        31 => u.rem_euclid(v | 1),
        32 => u.div_euclid(v | 1),
        33 => u.is_multiple_of(3) as u32,
        _ => u.wrapping_add_signed(v as i32),
    }
}

#[inline(always)]
fn of_signed(row: u32, i: i32, j: i32) -> u32 {
    let value = match row {
        35 => i.wrapping_abs(),
        36 => i.unsigned_abs() as i32,
        37 => i.signum(),
        38 => i.is_negative() as i32 + 2 * i.is_positive() as i32,
        39 => (i % 1000).rem_euclid(7),
        40 => (i % 1000).div_euclid(7),
        41 => i.abs_diff(j) as i32,
        42 => i.checked_neg().unwrap_or(77),
        43 => i.wrapping_neg(),
        44 => i.min(j) ^ i.max(j),
        45 => i.clamp(-100, 100),
        46 => (i % 1000).abs(),
        47 => i >> (j & 31),
        48 => (i.leading_zeros() + i.count_ones()) as i32,
        _ => i.wrapping_rem(j | 1),
    };
    value as u32
}

#[inline(always)]
fn of_floats(row: u32, x: f32, y: f32) -> u32 {
    match row {
        // which zero it is differs
        50 => x.min(y).abs().to_bits() | ((x.min(y) < 0.0) as u32) << 31,
        51 => x.max(y).abs().to_bits() | ((x.max(y) < 0.0) as u32) << 31,
        52 => x.abs().to_bits(),
        53 => x.clamp(-1.0, 1.0).to_bits(),
        54 => x.copysign(y).to_bits(),
        55 => x.signum().to_bits(),
        56 => x.is_finite() as u32 + 4 * x.is_infinite() as u32,
        57 => x.is_sign_negative() as u32 + 2 * x.is_sign_positive() as u32,
        58 => x.total_cmp(&y) as i32 as u32,
        59 => math::floor(x).to_bits(),
        60 => math::round(x).to_bits(),
        61 => math::truncate(x).to_bits(),
        _ => if x > y { f32::INFINITY } else { y }.to_bits(),
    }
}

#[inline(always)]
#[loops]
fn of_language(row: u32, u: u32, v: u32) -> u32 {
    let small = [u % 100, v % 100, 7, 3];
    match row {
        63 => (u > v).then_some(5).unwrap_or(6),
        64 => (u > v).then(|| u - v).unwrap_or(6),
        65 => Some(u).filter(|u| *u > v).map_or(3, |u| u - v),
        66 => Some(u).map(|u| u ^ v).unwrap_or_default(),
        67 => u.checked_sub(v).and_then(|x| x.checked_sub(10)).is_some() as u32,
        68 => match u.checked_sub(v).ok_or(4) {
            Ok(a) => a,
            Err(b) => b,
        },
        69 => (u.cmp(&v).reverse() as i32 + 5 * u.cmp(&v).is_lt() as i32) as u32,
        70 => {
            let mut two = (u, v);
            core::mem::swap(&mut two.0, &mut two.1);
            two.0.wrapping_sub(two.1.wrapping_mul(2))
        }
        71 => {
            let mut a = u;
            core::mem::replace(&mut a, v).wrapping_add(a.wrapping_mul(3))
        }
        72 => {
            let [a, b, c, _] = small;
            a + 1000 * b + c
        }
        73 => {
            let add = |k: u32| k.wrapping_add(u);
            add(v).wrapping_mul(add(1))
        }
        74 => match u {
            0..=9 => 1,
            k if k.is_multiple_of(2) => 2,
            11 | 13 | 15 => 3,
            _ => 4,
        },
        75 => match (u / 3, u % 3) {
            (k, 1) => k,
            _ => 0,
        },
        76 => u32::from(u > v) + u32::from(true),
        77 => small[v as usize % 4],
        78 => match u.cmp(&v) {
            Ordering::Less => 10,
            Ordering::Equal => 20,
            Ordering::Greater => 30,
        },
        79 => class(u),
        80 => {
            let mut sum = 0;
            for k in [1, 10, 100] {
                sum += small[0] * k;
            }
            for k in small {
                sum = sum * 3 + k;
            }
            sum
        }
        81 => {
            let mut sum = 0;
            for k in &small {
                sum += k;
            }
            for (at, k) in small.iter().enumerate() {
                sum += k * at as u32;
            }
            sum
        }
        82 => {
            let mut best = f32::INFINITY;
            for k in small.iter() {
                best = best.min(*k as f32);
            }
            best as u32
        }
        _ => {
            let is_same = mood(u as i32) == mood(v as i32);
            (mood(u as i32) as i32 + 1000 * is_same as i32) as u32
        }
    }
}

/// Returns in many places.
fn class(u: u32) -> u32 {
    if u < 3 {
        return 100;
    }
    if u.is_multiple_of(2) {
        if u.is_multiple_of(3) {
            return 6;
        }
        if u > 20 {
            return 2000;
        }
    }
    match u % 7 {
        0 => return 7,
        1 => {
            if u > 30 {
                return 77;
            }
        }
        _ => {}
    }
    u
}

fn mood(i: i32) -> Mood {
    match i {
        i32::MIN..=-1 => Mood::Bad,
        0 => Mood::Fine,
        _ => Mood::Good,
    }
}

/// Of integers of 8 and 16 bits, of which enums are made.
#[inline(always)]
fn of_small(row: u32, i: i32, j: i32) -> u32 {
    let value = match row {
        84 => i as i8 as i32,
        85 => i as i16 as i32,
        86 => i as u8 as i32 + j as u16 as i32,
        87 => (i as u8).wrapping_add(j as u8) as i32,
        88 => ((i as i8) < (j as i8)) as i32 + 2 * ((i as u8) < (j as u8)) as i32,
        _ => match i as i8 {
            0 => 1,
            -1 => 2,
            127 => 3,
            -128 => 5,
            _ => 4,
        },
    };
    value as u32
}

/// Of enums with data, of options, and of patterns.
#[inline(always)]
#[loops]
fn of_enums(u: u32, v: u32) -> u32 {
    let shapes = Shapes { all: [shape(u % 100), shape(v % 100), shape(u % 7)] };
    let mut sum = 0;
    for one in shapes.all {
        sum += match area(one) {
            Ok(area) => area as u32 * 10,
            Err(code) => code,
        };
    }
    let pair = if u > v { Some((u % 100, v % 50)) } else { None };
    if let Some((n, _)) = pair
        && n.is_multiple_of(3)
    {
        sum += 1000;
    }
    let Some((n, m)) = pair else { return sum };
    let [low, .., high] = [n % 3, n % 5, m % 7, m % 11];
    let is_small = matches!(shapes.all[1], Shape::Ball(radius) if radius < 30.0);
    sum + 100_000 * low + 10_000 * high + u32::from(is_small)
}

#[inline(always)]
fn shape(x: u32) -> Shape {
    match x % 4 {
        0 => Shape::Nothing,
        1 => Shape::Ball(x as f32),
        2 => Shape::Box { width: x as f32, height: 2.0 },
        _ => Shape::Pair(x as f32 + 1.0, -(x as i32)),
    }
}

#[inline(always)]
fn area(shape: Shape) -> Result<f32, u32> {
    match shape {
        Shape::Nothing => Err(7),
        Shape::Ball(radius) if radius > 50.0 => Err(9),
        Shape::Ball(radius) => Ok(radius * 3.0),
        Shape::Box { width, height } => Ok(width * height),
        Shape::Pair(x, y) => Ok(x + y as f32),
    }
}

#[inline(always)]
fn of_math(row: u32, Arguments { u, x, .. }: Arguments) -> u32 {
    match row {
        90 => muslin::half::half_value(u & 0xffff).to_bits(),
        91 => math::ceil(x).to_bits(),
        92 => math::is_finite(x) as u32,
        _ => (x == f32::NEG_INFINITY) as u32,
    }
}

/// Compilers have no remainder of negative numbers, and none but wrapping sums.
#[inline(always)]
fn of_remainders_and_overflow(row: u32, i: i32, j: i32) -> u32 {
    let value = match row {
        94 => i.wrapping_rem_euclid(j | 1),
        95 => i % 3,
        96 => i % -4,
        97 => i % 768,
        98 => (i >> 2) % 5,
        99 => i.checked_add(j).unwrap_or(77),
        100 => i.checked_sub(j).unwrap_or(77),
        101 => i.checked_add(0).unwrap_or(77),
        102 => i.checked_sub(0).unwrap_or(77),
        103 => 0_i32.checked_add(j).unwrap_or(77),
        104 => 0_i32.checked_sub(j).unwrap_or(77),
        105 => i.checked_add(5).unwrap_or(77),
        106 => i.checked_sub(i32::MIN).unwrap_or(77),
        107 => i.wrapping_sub(j).checked_add(j).unwrap_or(77),
        108 => i.overflowing_add(j).1 as i32,
        109 => i.overflowing_sub(j).1 as i32,
        _ => i.checked_add_unsigned(j as u32).is_none() as i32,
    };
    value as u32
}
