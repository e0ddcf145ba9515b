//! The case of `elementary`: the errors that the kit's functions state.

use muslin::math::MAX_ANGLE;
use muslin_check::prelude::*;
use muslin_language_kernels::elementary::{ElementaryInputs, ElementaryParams, FUNCTIONS};

case!(pub Elementary(ElementaryInputs));

impl Elementary {
    /// The function of an element, its arguments, and its value in f64.
    fn at(&self, index: usize) -> (usize, [f64; 3], f64) {
        let row = index / self.x.len();
        let at = index % self.x.len();
        let [x, y, p] = [&self.x, &self.y, &self.positive].map(|values| f64::from(values[at]));
        let angle = f64::from(-10.0 - y as f32).atan2(x);
        let all = [x.sin(), x.cos(), p.ln(), p.powf(y), x.floor(), x.round(), x.abs()];
        let others = [x.clamp(0.0, 1.0), x.atan(), angle, y.tanh()];
        let exact = all.into_iter().chain(others).nth(row).expect("a row is a function");
        (row, [x, y, p], exact)
    }
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
                2 => 5e-7 * exact.abs() + tiny,
                3 => 1e-6 * (1.0 + (y * p.ln()).abs()) * exact + tiny,
                // a GPU may take a denormal for 0
                4 if x != 0.0 && x.abs() < tiny => 1.0,
                4 | 5 => 0.0,
                6 | 7 => tiny,
                8 => 2.2e-7,
                9 => 4.4e-7,
                _ => 3.3e-7 * exact.abs() + tiny,
            },
        ))
    }
}
