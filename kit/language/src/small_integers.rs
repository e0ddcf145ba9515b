//! The cases of methods of integers of 8 and 16 bits. The CPU's values are core's own.

use muslin_check::prelude::*;
use muslin_language_kernels::small_integers::{
    I8_METHODS, I8MethodsInputs, I16_METHODS, I16MethodsInputs, SmallParams, U8_METHODS,
    U8MethodsInputs, U16_METHODS, U16MethodsInputs,
};

/// Bits at which methods change, beside the bits of `u8`.
const EDGES: [u32; 16] = [
    0x100,
    0x101,
    0x1ff,
    0x3fff,
    0x4000,
    0x7f00,
    0x7ffe,
    0x7fff,
    0x8000,
    0x8001,
    0xaaaa,
    0xff00,
    0xfffe,
    0xffff,
    0x4b00_0000,
    0xcb7f_ffff,
];

/// All pairs of integers: each `u8` and each edge beside each edge and some of the first.
fn pairs() -> [Vec<u32>; 2] {
    let small = [0, 1, 2, 3, 5, 7, 8, 9, 15, 16, 17, 31, 32, 33, 64, 127, 128, 129, 200, 254, 255];
    let others = || small.into_iter().chain(EDGES);
    let pairs = (0..256).chain(EDGES).flat_map(|x| others().map(move |y| (x, y)));
    let (x, y) = pairs.unzip();
    [x, y]
}

macro_rules! methods {
    ($($case:ident, $inputs:ident, $methods:ident, $integer:ident;)*) => {$(
        case!(pub $case($inputs));

        impl Parity for $case {
            // the CPU's other values come from core, with which devices are compared
            const COMPARED: f64 = 0.0;

            fn sets() -> Vec<(String, Self)> {
                let [x, y] = pairs();
                let params = SmallParams { count: x.len() as u32 };
                let output = unwritten($methods.len() * x.len());
                vec![("edges".into(), Self($inputs { params, x, y, output }))]
            }

            /// An output for each method.
            fn convert(&self, outputs: Vec<Output>) -> Vec<Output> {
                let rows = $methods.iter().zip(outputs[0].values.chunks(self.x.len()));
                rows.map(|(method, row)| Output::exact(method, row.to_vec())).collect()
            }

            fn exact_at(&self, method: &str, index: usize) -> Option<Rounded> {
                let [x, y] = [self.x[index] as $integer, self.y[index] as $integer].map(i64::from);
                let checked = |x: i64| $integer::try_from(x).map_or(0x1234_5678, |x| x as u32);
                let limits = [$integer::MIN, $integer::MAX].map(i64::from);
                let bits = i64::from($integer::BITS);
                // the value modulo 2^bits
                let low = x.rem_euclid(1 << bits);
                let wrapped = |x: i64| x as $integer as u32;
                let by = i64::from(self.y[index]) % bits;
                let value = match method {
                    "leading_zeros" => (0..bits).find(|k| low >> (bits - 1 - k) & 1 == 1).unwrap_or(bits) as u32,
                    "trailing_zeros" => (0..bits).find(|k| low >> k & 1 == 1).unwrap_or(bits) as u32,
                    "count_ones" => (0..bits).filter(|k| low >> k & 1 == 1).count() as u32,
                    "rotate_left" => wrapped(low << by | low >> (bits - by)),
                    "rotate_right" => wrapped(low >> by | low << (bits - by)),
                    "wrapping_add" => wrapped(x + y),
                    "wrapping_sub" => wrapped(x - y),
                    "wrapping_mul" => wrapped(x * y),
                    "checked_add" => checked(x + y),
                    "checked_sub" => checked(x - y),
                    "checked_add(0)" | "checked_sub(0)" => checked(x),
                    "checked_neg" | "0.checked_sub" => checked(-x),
                    "saturating_add" => (x + y).clamp(limits[0], limits[1]) as u32,
                    "saturating_sub" => (x - y).clamp(limits[0], limits[1]) as u32,
                    "abs_diff" => (x - y).unsigned_abs() as u32,
                    _ => return Some(Rounded::UNKNOWN),
                };
                Some(value.into())
            }
        }
    )*};
}

methods! {
    U8, U8MethodsInputs, U8_METHODS, u8;
    U16, U16MethodsInputs, U16_METHODS, u16;
    I8, I8MethodsInputs, I8_METHODS, i8;
    I16, I16MethodsInputs, I16_METHODS, i16;
}
