//! Functions over arrays of lanes, for [`Wide`](crate::lane::Wide).

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
