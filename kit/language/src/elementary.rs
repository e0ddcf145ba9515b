//! The case of `elementary`: the errors that the kit's functions state.

use muslin::math::MAX_ANGLE;
use muslin_check::prelude::*;
use muslin_language_kernels::CountParams;
use muslin_language_kernels::elementary::{ElementaryInputs, FUNCTIONS};

case!(pub Elementary(ElementaryInputs));

/// The nearest half, of two the even one.
pub fn nearest_half(x: f64) -> f64 {
    if x.abs() >= 65_520.0 {
        return f64::INFINITY.copysign(x);
    }
    let unit = (x.abs().log2().floor().max(-14.0) - 10.0).exp2();
    (x / unit).round_ties_even() * unit
}

/// The exponent of the power of two above a positive number.
fn exponent(x: f64) -> f64 {
    x.log2().floor() + 1.0
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
            let output = unwritten(FUNCTIONS.len() * len);
            Self(ElementaryInputs { params: CountParams { count }, x, y, positive, output })
        })
    }

    /// An output for each function.
    fn convert(&self, outputs: Vec<Output>) -> Vec<Output> {
        let rows = outputs[0].values.chunks(self.x.len().max(1));
        FUNCTIONS.iter().zip(rows).map(|(name, row)| Output::float(name, row.to_vec())).collect()
    }

    /// The errors are what each function states, and a tenth more for divisions and roots.
    fn exact_at(&self, function: &str, index: usize) -> Option<Rounded> {
        let tiny = f64::from(TINY);
        let [x, y, p] = [&self.x, &self.y, &self.positive].map(|values| f64::from(values[index]));
        let rounded = |x: f64| f64::from(x as f32);
        // as the kernel rounds it
        let [tenfold, eighth, sixteenth] = [rounded(10.0 * y), 0.125 * y, 0.0625 * y];
        let most = rounded(0.124_f32 as f64 * y);
        // a denormal may count as 0, and some functions make more of it
        let near =
            |exact: f64, error: f64| Rounded::within(exact, error * exact.abs() + 60.0 * tiny);
        let growing = |exact: f64, x: f64| near(exact, 1.1e-6 * (1.0 + x.abs()));
        // of two fractions that are as near, rounding decides
        let fraction = |x: f64, max: f64| {
            let code = max * x + 0.5;
            let is_between = (code - code.round()).abs() < 2e-7 * max;
            let value = near(code.floor() / max, 1.2e-7);
            if is_between { Rounded::within(value.value, 1.1 / max) } else { value }
        };
        let unorm = |x: f64, max: f64| fraction(x.clamp(0.0, 1.0), max);
        let snorm = |x: f64, max: f64| fraction(x.clamp(-1.0, 1.0), max);
        let number = Rounded::from;
        Some(match function {
            "sin" => Rounded::within(x.sin(), 1.2e-7),
            "cos" => Rounded::within(x.cos(), 1.2e-7),
            "tan" => Rounded::within(x.tan(), 5.5e-7 * (1.0 + x.tan() * x.tan())),
            "ln" => near(p.ln(), 5e-7),
            "log2" => near(p.log2(), 5.5e-7),
            "pow" => near(p.powf(y), 1e-6 * (1.0 + (y * p.ln()).abs())),
            "exp2" => near(y.exp2(), 3.3e-7),
            // a GPU may take a denormal for 0
            "floor" | "ceil" | "fract" | "sign" if x != 0.0 && x.abs() < tiny => {
                Rounded::within(0.0, 1.0)
            }
            "floor" => Rounded::exact(x.floor()),
            "fract" => Rounded::exact(rounded(x - x.floor())),
            "round" => Rounded::exact(x.round()),
            "round_even" => Rounded::exact(x.round_ties_even()),
            "truncate" => Rounded::exact(x.trunc()),
            "ceil" => Rounded::exact(x.ceil()),
            "abs" => Rounded::within(x.abs(), tiny),
            "sign" => Rounded::exact(if x == 0.0 { 0.0 } else { x.signum() }),
            "clamp" => Rounded::within(x.clamp(0.0, 1.0), tiny),
            "step" if (x - y).abs() < 2.0 * tiny => Rounded::within(0.0, 1.0),
            "step" => Rounded::exact(if x < y { 0.0 } else { 1.0 }),
            "smoothstep" => {
                let t = ((y + 2.0) / 5.0).clamp(0.0, 1.0);
                Rounded::within(t * t * (3.0 - 2.0 * t), 1.1e-6)
            }
            "mix" => number(x) + number(p) * (number(y) - number(x)),
            "min and max" => number(x.min(y)) + number(2.0) * number(x.max(y)),
            "inverse_sqrt" => near(1.0 / p.sqrt(), 1.1e-6),
            "asin" => Rounded::within(y.clamp(-1.0, 1.0).asin(), 2.2e-7),
            "acos" => Rounded::within(y.clamp(-1.0, 1.0).acos(), 4.4e-7),
            "atan" => Rounded::within(x.atan(), 2.2e-7),
            "atan2" => Rounded::within(rounded(-10.0 - y).atan2(x), 4.4e-7),
            "sinh" => growing(y.sinh(), y),
            "sinh of large" => growing(tenfold.sinh(), tenfold),
            "cosh" => growing(y.cosh(), y),
            "cosh of large" => growing(tenfold.cosh(), tenfold),
            "tanh" => near(y.tanh(), 3.3e-7),
            "asinh" => near(x.asinh(), 1.1e-6),
            "asinh of small" => near(eighth.asinh(), 1.1e-6),
            "acosh" => near(p.max(1.0).acosh(), 1.1e-6),
            "atanh" => near(sixteenth.atanh(), 1.1e-6),
            "atanh of large" => near(most.atanh(), 1.1e-6),
            "sigmoid" => number(y).sigmoid(),
            "log_sigmoid" => number(y).log_sigmoid(),
            "ldexp" => Rounded::exact(p * (x.trunc() % 20.0).exp2()),
            "frexp" => Rounded::exact(rounded(p / exponent(p).exp2() + exponent(p))),
            "to_degrees" => near(y.to_degrees(), 1.2e-7),
            "to_radians" => near(x.to_radians(), 1.2e-7),
            "quantize_to_half" | "the upper half" => Rounded::exact(nearest_half(x)),
            "the lower half" => Rounded::exact(nearest_half(p)),
            "unpack_unorm_4x8" => unorm(0.25 * y, 255.0),
            "unpack_snorm_4x8" => snorm(0.25 * y, 127.0),
            "unpack_unorm_2x16" => unorm(0.25 * y, 65_535.0),
            "unpack_snorm_2x16" => snorm(0.25 * y, 32_767.0),
            _ => unreachable!("{function} has no equation"),
        })
    }
}
