//! The optimizer's step.

use muslin_check::prelude::*;
use organza_shaders::adam::{AdamInputs, AdamParams};
use organza_shaders::hash_grid_backward::VALUES_PER_FLAG;

use super::exact::adam::step;

case!(pub Adam(AdamInputs));

impl Adam {
    fn new(values: u32, fill: Fill, random: &mut Random) -> Self {
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
        Self(AdamInputs {
            params,
            touched: (0..blocks).map(|_| if sparse == 1 { random.below(2) } else { 1 }).collect(),
            gradient: fill.values(random, len + first_gradient as usize, [-1.0, 1.0], 1e10),
            first_moment: fill.values(random, len, [-1.0, 1.0], 1e10),
            second_moment: random.values(len, 1e-6, 1.0),
            value: fill.values(random, len, [-3.0, 3.0], 1e10),
        })
    }

    /// Whether the kernel moves a value.
    fn is_touched(&self, index: usize) -> bool {
        let block = index / VALUES_PER_FLAG as usize * self.params.sparse as usize;
        index < self.value.len() && self.touched[block] != 0
    }
}

impl Parity for Adam {
    const KERNEL: &'static str = "adam";
    const TOLERANCE: f64 = 1e-6;
    const WHY: &'static str = "one division, one square root and nine roundings";

    fn sets() -> Vec<(String, Self)> {
        inputs::sets(Self::new)
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        runner.run(&self.kernel(), self.params.values, 1)
    }

    fn bound(&self, cpu: &Output, index: usize, _: Rounding) -> Bound {
        if !self.is_touched(index) || cpu.name == "gradient" {
            return Bound::relative_to(0.0);
        }
        let g = f64::from(self.gradient[index + self.params.first_gradient as usize]);
        let m = f64::from(self.first_moment[index].abs()) + g.abs();
        let v = cpu.floats()[index];
        Bound::relative_to(match cpu.name {
            "first_moment" => m,
            "second_moment" => v,
            // the terms of m may cancel
            _ => {
                let v = f64::from(self.second_moment[index]) * 0.999 + 0.001 * g * g;
                let size = v.sqrt() * f64::from(self.params.correction2);
                f64::from(self.value[index].abs()) + f64::from(self.params.rate) * m / size
            }
        })
    }

    fn exact_at(&self, output: &str, index: usize) -> Option<f64> {
        let first = self.params.first_gradient as usize;
        if output == "gradient" {
            // the kernel leaves the gradients of other groups alone
            let is_own = index.checked_sub(first).is_some_and(|own| self.is_touched(own));
            let before = f64::from(*self.gradient.get(index)?);
            return Some(if is_own { 0.0 } else { before });
        }
        let before = [&self.first_moment, &self.second_moment, &self.value];
        let gradient = f64::from(*self.gradient.get(index + first)?);
        let before = before.map(|values| f64::from(values[index]));
        let after = step(&self.params, gradient, before);
        let [m, v, value] = if self.is_touched(index) { after } else { before };
        Some(match output {
            "first_moment" => m,
            "second_moment" => v,
            _ => value,
        })
    }
}
