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

/// `a b + c`, with one rounding if the instruction set has that.
#[inline(always)]
pub fn fma<const FUSED: bool>(a: f32, b: f32, c: f32) -> f32 {
    if FUSED { a.mul_add(b, c) } else { a * b + c }
}
