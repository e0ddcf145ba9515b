//! The case of `integer_functions`: integers of 64 bits, and numbers in f64, give the same bits in another way.

use muslin_check::prelude::*;
use muslin_language_kernels::CountParams;
use muslin_language_kernels::integers::{FUNCTIONS, IntegerFunctionsInputs};

use crate::core_functions::INTEGERS;
use crate::elementary::nearest_half;

case!(pub IntegerFunctions(IntegerFunctionsInputs));

/// The bits of a half that is a number.
fn half(x: f64) -> u32 {
    let x = nearest_half(x);
    let size = match x.abs() {
        f64::INFINITY => 0x7c00,
        size if size < 2_f64.powi(-14) => (size * 2_f64.powi(24)) as u32,
        size => {
            let exponent = size.log2().floor();
            let digits = (size / exponent.exp2() - 1.0) * 1024.0;
            (exponent + 15.0) as u32 * 1024 + digits as u32
        }
    };
    size | u32::from(x.is_sign_negative()) << 15
}

/// A number from `low` to 1 as a fraction of `max`, in so many bits.
fn fraction(x: f64, low: f64, max: f64, bits: u32) -> u32 {
    let nearest = (x.clamp(low, 1.0) * max + 0.5).floor() as i64;
    nearest.rem_euclid(1 << bits) as u32
}

/// The bytes of a word as numbers.
fn bytes(word: u32, is_signed: bool) -> [i64; 4] {
    word.to_le_bytes()
        .map(|byte| if is_signed { i64::from(byte.cast_signed()) } else { byte.into() })
}

/// A word of fractions with one code for -1.
fn without_second_least(word: u32, bits: u32) -> u32 {
    let least = 1_u32 << (bits - 1);
    let parts = (0..32 / bits).map(|part| (word >> (part * bits) & (2 * least - 1), part * bits));
    parts.map(|(code, at)| (if code == least { least + 1 } else { code }) << at).sum()
}

impl Parity for IntegerFunctions {
    fn sets() -> Vec<(String, Self)> {
        let mut random = Random::new(7);
        let pairs = INTEGERS.iter().flat_map(|&u| INTEGERS.iter().map(move |&v| [u, v]));
        let more = (0..400).map(|_| [random.bits(), random.bits()]);
        let (u, v): (Vec<_>, Vec<_>) = pairs.chain(more).map(|[u, v]| (u, v)).unzip();
        // products with 65,535 are exact
        let number = |_: &u32| (random.below(513) as f32 - 256.0) / 128.0;
        let x: Vec<_> = u.iter().map(number).collect();
        let powers = [-30, -25, -17, -15, -2, 0, 3, 17, 30].map(|power| 2_f32.powi(power));
        let y = u.iter().zip(&x).enumerate();
        let y = y
            .map(
                |(at, (_, x))| if at.is_multiple_of(3) { x * powers[at / 3 % 9] } else { -x / 2.0 },
            )
            .collect();
        let words = unwritten(FUNCTIONS.len() * u.len());
        let params = CountParams { count: u.len() as u32 };
        vec![("edges".into(), Self(IntegerFunctionsInputs { params, u, v, x, y, words }))]
    }

    /// An output for each function.
    fn convert(&self, outputs: Vec<Output>) -> Vec<Output> {
        let words = outputs[0].words();
        let rows = words.chunks(self.u.len());
        FUNCTIONS.iter().zip(rows).map(|(name, row)| Output::exact(name, row.to_vec())).collect()
    }

    fn exact_at(&self, function: &str, index: usize) -> Option<Rounded> {
        let [u, v] = [self.u[index], self.v[index]];
        let [x, y] = [self.x[index], self.y[index]].map(f64::from);
        let [a, b] = [u, v].map(i64::from);
        let [i, j] = [u, v].map(|bits| i64::from(bits.cast_signed()));
        let [offset, count] = [v % 40, v / 64 % 40];
        let end = (offset + count).min(32);
        // the places of a field in a word
        let places = || (0..32).filter(|bit| (offset..end).contains(bit));
        let field: i64 = places().map(|bit| i64::from(u >> bit & 1) << (bit - offset)).sum();
        let is_negative = offset < end && u >> (end - 1) & 1 == 1;
        let inserted = || {
            let field = places().map(|bit| (v >> (bit - offset) & 1) << bit).sum::<u32>();
            field
                + (0..32)
                    .filter(|bit| !places().any(|of| of == *bit))
                    .map(|bit| u & 1 << bit)
                    .sum::<u32>()
        };
        let dot = |is_signed| -> i64 {
            let pairs = bytes(u, is_signed).into_iter().zip(bytes(v, is_signed));
            pairs.map(|(a, b)| a * b).sum()
        };
        let weighted = |of: [i64; 4]| of[0] + 3 * of[1] + 5 * of[2] + 7 * of[3];
        let four = [x, y, f64::from(1.0 - x as f32), -y];
        let packed = |low: f64, max: f64| {
            let codes = four.map(|x| fraction(x, low, max, 8));
            codes[0] | codes[1] << 8 | codes[2] << 16 | codes[3] << 24
        };
        let two = |[x, y]: [f64; 2], low: f64, max: f64| {
            fraction(x, low, max, 16) | fraction(y, low, max, 16) << 16
        };
        let value = match function {
            "saturating_add" => (a + b).min(u32::MAX.into()),
            "saturating_sub" => (a - b).max(0),
            "saturating_add of i32" => (i + j).clamp(i32::MIN.into(), i32::MAX.into()),
            "saturating_sub of i32" => (i - j).clamp(i32::MIN.into(), i32::MAX.into()),
            "saturating_add of u8" => (a % 256 + b % 256).min(255),
            "saturating_sub of i16" => {
                let [a, b] = [u, v].map(|bits| i64::from(bits as u16 as i16));
                (a - b).clamp(i16::MIN.into(), i16::MAX.into())
            }
            "isqrt" => f64::from(u).sqrt() as i64,
            "multiply_high" => ((u64::from(u) * u64::from(v)) >> 32) as i64,
            "extract_bits" => field,
            "extract_bits of i32" => field - (i64::from(is_negative) << (end.max(offset) - offset)),
            "insert_bits" | "insert_bits of i32" => inserted().into(),
            "count_ones" => (0..32).filter(|bit| u >> bit & 1 == 1).count() as i64,
            "leading_zeros" => (0..32).take_while(|bit| a < 1 << (31 - bit)).count() as i64,
            "trailing_zeros" => (0..32).take_while(|bit| a % (2 << bit) == 0).count() as i64,
            "reverse_bits" => (0..32).map(|bit| (a >> bit & 1) << (31 - bit)).sum(),
            "dot_unsigned_4x8" => dot(false),
            "dot_signed_4x8" => dot(true),
            "pack_4x8" => u32::from_le_bytes([a, b, a >> 8, b >> 16].map(|of| of as u8)).into(),
            "unpack_unsigned_4x8" => weighted(bytes(u, false)),
            "unpack_signed_4x8" => weighted(bytes(u, true)),
            "half_bits" => half(x).into(),
            "pack_half_2x16" => i64::from(half(x) | half(y) << 16),
            "unpack_half_2x16" => (u & 0xbbff_bbff | 0x0400_0400).into(),
            "pack_unorm_4x8" => packed(0.0, 255.0).into(),
            "pack_snorm_4x8" => packed(-1.0, 127.0).into(),
            "pack_unorm_2x16" => two([x, -y], 0.0, 65_535.0).into(),
            "pack_snorm_2x16" => two([-x, y], -1.0, 32_767.0).into(),
            "repacked unorm_4x8" | "repacked unorm_2x16" => a,
            "repacked snorm_4x8" => without_second_least(u, 8).into(),
            "repacked snorm_2x16" => without_second_least(u, 16).into(),
            _ => unreachable!("{function} has no equation"),
        };
        Some((value as u32).into())
    }
}
