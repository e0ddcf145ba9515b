use organza_check::prelude::*;
use organza_shaders::blend::{BlendInputs, BlendParams};

case!(pub Blend(BlendInputs));

impl Parity for Blend {
    const KERNEL: &'static str = "blend";
    const TOLERANCE: f64 = 2e-7;
    const WHY: &'static str = "three roundings of the terms' sizes";

    fn sets() -> Vec<(String, Self)> {
        inputs::sets(|count, fill, random| {
            let first = fill.values(random, count as usize, [0.0, 1.0], 3e38);
            let second = fill.values(random, count as usize, [0.0, 1.0], 3e38);
            let params = BlendParams { count, weight: random.between(0.0, 1.0) };
            Self(BlendInputs { params, first, second, output: unwritten(count as usize) })
        })
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        runner.run(&self.kernel(), self.params.count, 1)
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<f64> {
        let [a, b] = [self.first[index], self.second[index]].map(f64::from);
        let weight = f64::from(self.params.weight);
        Some((1.0 - weight) * a + weight * b)
    }

    fn bound(&self, _: &Output, index: usize, _: Rounding) -> Bound {
        let size = |values: &[f32]| f64::from(values[index].abs());
        let weight = f64::from(self.params.weight);
        Bound::of((1.0 - weight) * size(&self.first) + weight * size(&self.second))
    }
}
