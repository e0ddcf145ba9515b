//! The optimizer's step.

use muslin_check::prelude::*;
use organza_shaders::adam::{AdamInputs, AdamParams};
use organza_shaders::hash_grid_backward::VALUES_PER_FLAG;

use super::exact::adam::step;

case!(pub Adam(AdamInputs));

impl Parity for Adam {
    fn sets() -> Vec<(String, Self)> {
        inputs::sets(|values, fill, random| {
            let sparse = values % 2;
            let blocks = if sparse == 1 { values.div_ceil(VALUES_PER_FLAG) } else { 1 };
            let len = values as usize;
            let first_gradient = random.below(9);
            let params = AdamParams {
                values,
                first_gradient,
                sparse,
                rate: 0.01 / (1.0 - 0.9),
                decay1: 0.9,
                decay2: 0.999,
                correction2: (1.0 / (1.0 - 0.999_f32)).sqrt(),
                epsilon: 0.01,
                kept: 1.0 - 0.01 * 0.1,
            };
            let touched = (0..blocks).map(|_| if sparse == 1 { random.below(2) } else { 1 });
            Self(AdamInputs {
                params,
                touched: touched.collect(),
                gradient: fill.values(random, len + first_gradient as usize, [-1.0, 1.0], 1e10),
                first_moment: fill.values(random, len, [-1.0, 1.0], 1e10),
                second_moment: random.values(len, 1e-6, 1.0),
                value: fill.values(random, len, [-3.0, 3.0], 1e10),
            })
        })
    }

    fn exact_at(&self, output: &str, index: usize) -> Option<Rounded> {
        let first = self.params.first_gradient as usize;
        // the kernel leaves the gradients of other groups alone
        let value = if output == "gradient" { index.wrapping_sub(first) } else { index };
        let block = value / VALUES_PER_FLAG as usize * self.params.sparse as usize;
        let is_touched = value < self.value.len() && self.touched[block] != 0;
        if output == "gradient" {
            return Some(if is_touched { 0.0 } else { self.gradient[index] }.into());
        }
        let before = [&self.first_moment, &self.second_moment, &self.value];
        let before = before.map(|values| Rounded::from(values[index]));
        let gradient = self.gradient[index + first].into();
        let after = if is_touched { step(&self.params, gradient, before) } else { before };
        let [m, v, value] = after;
        Some(match output {
            "first_moment" => m,
            "second_moment" => v,
            _ => value,
        })
    }
}
