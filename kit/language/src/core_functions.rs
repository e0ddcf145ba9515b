//! The case of `core_functions`: what kernels take of core has the same values on every device.

use muslin::math::HUGE;
use muslin_check::prelude::*;
use muslin_language_kernels::CountParams;
use muslin_language_kernels::core_functions::{CoreFunctionsInputs, ROWS, WORKGROUP};

case!(pub CoreFunctions(CoreFunctionsInputs));

/// Integers at which functions change.
pub const INTEGERS: [u32; 25] = [
    0, 1, 2, 3, 7, 31, 32, 33, 127, 128, 255, 256, 0x7c00, 0x7fff, 0xffff, 0x1_0000, 0x7fffffff,
    0x80000000, 0x80000001, !0x7fff, !0x7f, !1, !0, 123456789, 3000000000,
];

/// Floats at which functions change. What is no number is not here: through naga, devices do not see it.
const FLOATS: [f32; 25] = [
    0.0, -0.0, 0.3, -0.3, 0.5, -0.5, HALF, -HALF, 1.5, 2.5, -2.5, 7.0, -8.0, 100.25, 8388607.5,
    -8388607.5, 8388608.0, TWO_31, 3e9, -3e9, 1e20, HUGE, -HUGE, ENDLESS, -ENDLESS,
];
const HALF: f32 = 0.499_999_97;
const TWO_31: f32 = 2_147_483_648.0;
const ENDLESS: f32 = f32::INFINITY;

impl Parity for CoreFunctions {
    // integers, and bits of floats that are not rounded: the CPU's other values come from core, with which devices are compared
    const COMPARED: f64 = 0.15;

    fn sets() -> Vec<(String, Self)> {
        let places = (0..INTEGERS.len()).flat_map(|a| (0..INTEGERS.len()).map(move |b| [a, b]));
        let [a, b]: [Vec<_>; 2] = [0, 1].map(|k| places.clone().map(|place| place[k]).collect());
        let integers = |of: &[usize]| of.iter().map(|&at| INTEGERS[at]).collect();
        let floats = |of: &[usize]| of.iter().map(|&at| FLOATS[at]).collect();
        let output = unwritten(a.len() * ROWS as usize);
        let params = CountParams { count: a.len() as u32 };
        let [u, v] = [&a, &b].map(|of| integers(of));
        let [x, y] = [&a, &b].map(|of| floats(of));
        vec![("edges".into(), Self(CoreFunctionsInputs { params, u, v, x, y, output }))]
    }

    /// Of functions that are not core's own on the CPU.
    fn exact_at(&self, _: &str, index: usize) -> Option<Rounded> {
        let at = index % self.u.len();
        let [u, v] = [self.u[at], self.v[at]];
        let [a, b] = [u, v].map(i64::from);
        let [i, j] = [u, v].map(|bits| i64::from(bits as i32));
        let signed = |x: i64| (x + 128).rem_euclid(256) - 128;
        let checked = |x: i64| i32::try_from(x).unwrap_or(77) as u32;
        let is_beyond = |x: i64| u32::from(i32::try_from(x).is_err());
        let bits = |x: f64| (x as f32).to_bits();
        let x = f64::from(self.x[at]);
        let half = |bits: u32| {
            let [exponent, rest] = [bits >> 10 & 31, bits & 1023].map(f64::from);
            let size = match exponent {
                0.0 => rest * 2_f64.powi(-24),
                31.0 if rest == 0.0 => f64::INFINITY,
                _ => (1.0 + rest / 1024.0) * 2_f64.powf(exponent - 15.0),
            };
            if bits & 0x8000 == 0 { size } else { -size }
        };
        let value = match index / self.u.len() {
            0 => u32::from(((index % WORKGROUP) ^ 1).is_multiple_of(3)),
            12 => (a + b) as u32,
            24 => u32::from(a < b),
            59 => bits(x.floor()),
            60 => bits(x.round()),
            61 => bits(x.trunc()),
            84 => signed(i) as u32,
            85 => ((i + 32_768).rem_euclid(65_536) - 32_768) as u32,
            86 => (a % 256 + b % 65_536) as u32,
            87 => ((a + b) % 256) as u32,
            88 => u32::from(signed(i) < signed(j)) + 2 * u32::from(a % 256 < b % 256),
            90 if u & 0x7fff <= 0x7c00 => bits(half(u & 0xffff)),
            91 => bits(x.ceil()),
            92 => u32::from(x.is_finite()),
            93 => u32::from(x == f64::NEG_INFINITY),
            99 => checked(i + j),
            100 => checked(i - j),
            108 => is_beyond(i + j),
            109 => is_beyond(i - j),
            110 => is_beyond(i + b),
            _ => return Some(Rounded::UNKNOWN),
        };
        Some(value.into())
    }
}
