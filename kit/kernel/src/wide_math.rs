//! Functions of [`Wide`](crate::lane::Wide) that take more than one instruction.

use crate::lane::Lane;
use crate::wide::{Wide, lanes};

/// e^x = 2^n e^r with |r| <= ln 2 / 2: Cephes' polynomial. Each step runs for all lanes: a closure of this length
/// would not be vectorized.
#[inline(always)]
pub fn exp<const N: usize, const FUSED: bool>(x: Wide<N, FUSED>) -> Wide<N, FUSED> {
    /// 1.5 * 2^23: adding it leaves the nearest integer in the low bits.
    const MAGIC: f32 = 12_582_912.0;
    let number = Wide::<N, FUSED>::splat;
    let x = x.min(number(89.0)).max(number(-88.0));
    let shifted = x * number(core::f32::consts::LOG2_E) + number(MAGIC);
    let n = shifted - number(MAGIC);
    let r = (x - n * number(0.693_359_4)) + n * number(2.121_944_4e-4);
    let p = number(1.987_569_1e-4);
    let p = p.mul_add(r, number(1.398_199_9e-3));
    let p = p.mul_add(r, number(8.333_452e-3));
    let p = p.mul_add(r, number(4.166_579_6e-2));
    let p = p.mul_add(r, number(1.666_666_5e-1));
    let p = p.mul_add(r, number(0.5));
    let p = (p * r).mul_add(r, r) + number(1.0);
    // 2^n in two factors: n may be 128
    let whole: [i32; N] = lanes!(|i| ((shifted.0[i].to_bits() as i32) << 9) >> 9);
    let half: [i32; N] = lanes!(|i| whole[i] >> 1);
    let first = Wide(lanes!(|i| f32::from_bits(((half[i] + 127) as u32) << 23)));
    let second = Wide(lanes!(|i| f32::from_bits(((whole[i] - half[i] + 127) as u32) << 23)));
    p * first * second
}

/// The sum as a tree of pairs. It is not inlined: otherwise the compiler would keep the terms in pairs of lanes.
#[inline(never)]
pub fn pairwise<const N: usize>(values: &[f32; N]) -> f32 {
    let mut values = *values;
    let mut width = N / 2;
    while width > 0 {
        let mut i = 0;
        while i < width {
            values[i] += values[i + width];
            i += 1;
        }
        width /= 2;
    }
    values[0]
}

/// Values without their fractions, clamped to the range of an integer. A plain `as` does the same, but one by one.
#[inline(always)]
pub fn wholes<const N: usize>(mut x: [f32; N]) -> [i32; N] {
    /// The largest number below 2^31.
    const MOST: f32 = 2_147_483_520.0;
    let mut whole = [0; N];
    let mut i = 0;
    while i < N {
        x[i] = if x[i] < MOST { x[i] } else { MOST };
        x[i] = if x[i] > -MOST { x[i] } else { -MOST };
        // SAFETY: it is limited, and what was NaN is MOST
        whole[i] = unsafe { x[i].to_int_unchecked() };
        i += 1;
    }
    whole
}

/// `a b + c`, with one rounding if the instruction set has that.
#[inline(always)]
pub fn fma<const FUSED: bool>(a: f32, b: f32, c: f32) -> f32 {
    if FUSED { a.mul_add(b, c) } else { a * b + c }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::TINY;

    #[test]
    fn the_exponential_is_that_of_f64() {
        let mut worst = 0.0_f64;
        for step in -90_000..90_000 {
            let x = step as f32 * 0.001;
            let exact = libm::exp(f64::from(x));
            for found in
                [Wide::<4, true>::splat(x).exp().0[1], Wide::<4, false>::splat(x).exp().0[3]]
            {
                if x > 88.722 {
                    assert!(found.is_infinite() || f64::from(found) > 3e38, "{x}: {found}");
                } else if exact < f64::from(TINY) {
                    assert!(found <= TINY, "{x}: {found}");
                } else {
                    worst = worst.max((f64::from(found) - exact).abs() / exact);
                }
            }
        }
        assert!(worst < 1.5 * f64::from(f32::EPSILON), "{worst:e}");
        assert_eq!(Wide::<2, true>::splat(0.0).exp().0, [1.0; 2]);
    }
}
