//! The case of `elementary`: the errors that the kit's functions state.

use muslin::math::MAX_ANGLE;
use muslin_check::prelude::*;
use muslin_language_kernels::elementary::{ElementaryInputs, ElementaryParams};

case!(pub Elementary(ElementaryInputs));

impl Elementary {
    /// The function of an element, its arguments, and its value in f64.
    fn at(&self, index: usize) -> (usize, [f64; 3], f64) {
        let row = index / self.x.len();
        let at = index % self.x.len();
        let [x, y, p] = [&self.x, &self.y, &self.positive].map(|values| f64::from(values[at]));
        let all = [x.sin(), x.cos(), x.tan(), p.ln(), p.powf(y), x.floor(), x.round(), x.abs()];
        let exact = match row {
            8 => x.clamp(0.0, 1.0),
            9 => x + p * (y - x),
            10 => y.clamp(-1.0, 1.0).asin(),
            11 => y.clamp(-1.0, 1.0).acos(),
            12 => x.atan(),
            13 => f64::from(-10.0 - y as f32).atan2(x),
            14 => y.exp2(),
            15 => p.log2(),
            16 => y.tanh(),
            17 => nearest_half(p),
            18 => nearest_half(x),
            row => all[row],
        };
        (row, [x, y, p], exact)
    }
}

/// The nearest half, of two the even one.
fn nearest_half(x: f64) -> f64 {
    if x.abs() >= 65_520.0 {
        return f64::INFINITY.copysign(x);
    }
    let unit = (x.abs().log2().floor().max(-14.0) - 10.0).exp2();
    (x / unit).round_ties_even() * unit
}

impl Parity for Elementary {
    fn sets() -> Vec<(String, Self)> {
        inputs::sets(|count, fill, random| {
            let len = count as usize;
            let x = fill.values(random, len, [-50.0, 50.0], MAX_ANGLE);
            let y = fill.values(random, len, [-3.0, 3.0], 8.0);
            let sizes = fill.values(random, len, [-10.0, 10.0], 10.0);
            // of all sizes, and many about 1
            let positive = sizes
                .iter()
                .map(|size| if count % 2 == 0 { size.exp() } else { 1.0 + 0.01 * size });
            let positive = positive.collect();
            let output = unwritten(19 * len);
            Self(ElementaryInputs { params: ElementaryParams { count }, x, y, positive, output })
        })
    }

    /// The errors are what each function states, and a tenth more for divisions and roots.
    fn exact_at(&self, _: &str, index: usize) -> Option<Rounded> {
        let (row, [x, y, p], exact) = self.at(index);
        let tiny = f64::from(TINY);
        Some(Rounded::within(
            exact,
            match row {
                0 | 1 => 1.2e-7,
                2 => 5e-7 * (1.0 + exact * exact),
                3 => 5e-7 * exact.abs() + tiny,
                4 => 1e-6 * (1.0 + (y * p.ln()).abs()) * exact + tiny,
                // a GPU may take a denormal for 0
                5 if x != 0.0 && x.abs() < tiny => 1.0,
                5 | 6 | 17 | 18 => 0.0,
                7 | 8 => tiny,
                10 | 12 => 2.2e-7,
                11 | 13 => 4.4e-7,
                14 | 16 => 3.3e-7 * exact.abs() + tiny,
                15 => 5.5e-7 * exact.abs() + tiny,
                // a linear mix
                _ => {
                    let [x, y, p] = [x, y, p].map(Rounded::from);
                    return Some(x + p * (y - x));
                }
            },
        ))
    }
}
