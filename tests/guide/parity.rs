use organza_check::{Bound, KernelRunner, Output, Parity, Rounding, inputs};
use organza_device::Result;
use organza_shaders::blend::{BlendKernel, BlendParams};

/// Inputs of `blend`.
#[derive(Clone, Debug)]
pub struct Blend {
    /// `[count]`
    pub first: Vec<f32>,
    /// `[count]`
    pub second: Vec<f32>,
    /// Weight of `second`.
    pub weight: f32,
}

impl Parity for Blend {
    const KERNEL: &'static str = "blend";
    const TOLERANCE: f64 = 2e-7;
    const WHY: &'static str = "three roundings of the terms' sizes";

    fn sets() -> Vec<(String, Self)> {
        inputs::sets(|count, fill, random| Self {
            first: fill.values(random, count as usize, [0.0, 1.0], 3e38),
            second: fill.values(random, count as usize, [0.0, 1.0], 3e38),
            weight: random.between(0.0, 1.0),
        })
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let count = self.first.len() as u32;
        let kernel = BlendKernel {
            params: BlendParams { count, weight: self.weight },
            first: &self.first,
            second: &self.second,
            output: &runner.unwritten(count as usize),
        };
        runner.run(&kernel, count, 1)
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<f64> {
        let [a, b] = [self.first[index], self.second[index]].map(f64::from);
        let weight = f64::from(self.weight);
        Some((1.0 - weight) * a + weight * b)
    }

    fn bound(&self, _: &Output, index: usize, _: Rounding) -> Bound {
        let size = |values: &[f32]| f64::from(values[index].abs());
        let weight = f64::from(self.weight);
        Bound::of((1.0 - weight) * size(&self.first) + weight * size(&self.second))
    }
}
