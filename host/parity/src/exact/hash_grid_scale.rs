//! The unit of the hash grids' gradient, as docs/correctness.md defines it.

use super::numeric::{Number, Rounded};

/// A bound of |dL/dlogit| of a color (Eq. 3): a sigmoid's slope is at most 1/4.
pub fn color_bound(gradient: [Rounded; 3]) -> Rounded {
    largest(gradient.map(|g| g / 4.0.into()))
}

/// A bound of |dL/da_k| of a segment's samples (Eq. 11). Their product has the exponent `power`.
pub fn transmittance_bound([gradient, transmittance, power]: [Rounded; 3]) -> Rounded {
    power * (gradient * transmittance).abs()
}

/// The largest absolute value; infinite if a value is infinite or NaN.
pub fn largest(values: impl IntoIterator<Item = Rounded>) -> Rounded {
    let endless = Rounded::exact(f64::INFINITY);
    let larger = |largest: Rounded, x: Rounded| match x.value.is_finite() {
        true => largest.max(x.abs()),
        false => endless,
    };
    values.into_iter().fold(Rounded::exact(0.0), larger)
}

/// The exponent of the unit, a power of two, and the limit: the largest gradient that can be added.
///
/// 2^e is the next power of two above the product of the bounds, plus 1% for rounding, with e from -125 to 128.  2^b is the
/// next power of two of the samples. The unit is `2^(62 - e - b)`, at most 2^126, and the limit is the f32 before 2^e.
pub fn unit(bounds: &[f32], samples: u32) -> (i32, f32) {
    // a denormal counts as up to 2^-126: the bits of its mantissa after a leading 1, at 2^-127
    let logarithm = |&bound: &f32| {
        let bound = f64::from(bound);
        let smallest = 2_f64.powi(-126);
        if bound < smallest { (1.0 + bound / smallest).log2() - 127.0 } else { bound.log2() }
    };
    let product = bounds.iter().map(logarithm).sum::<f64>() + 1.01_f64.log2();
    let e = (product.floor() as i32 + 1).clamp(-125, 128);
    let b = f64::from(samples.max(1)).log2().ceil() as i32;
    let limit = 2_f64.powi(e) * (1.0 - 2_f64.powi(-24));
    ((62 - e - b).min(126), limit as f32)
}
