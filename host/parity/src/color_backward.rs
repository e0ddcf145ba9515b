//! Cases of `color_head_backward` and `material_backward`.

use glam::Vec4;
use muslin_check::prelude::*;
use organza_shaders::color_backward::{
    ColorHeadBackwardInputs, ColorHeadBackwardParams, MaterialBackwardInputs,
    MaterialBackwardParams,
};

use super::exact::color::logit;
use super::exact::numeric::{Dual, gradient, sigmoid};

/// Pairs before the chunk.
const FIRST_PAIR: u32 = 2;

case!(pub ColorHeadBackward(ColorHeadBackwardInputs));

impl Parity for ColorHeadBackward {
    const KERNEL: &'static str = "color_head_backward";
    const TOLERANCE: f64 = 2.4e-7;
    const WHY: &'static str = "three roundings of dL/dc c: drivers may fuse c (1 - c)";

    fn sets() -> Vec<(String, Self)> {
        inputs::sets(|samples, fill, random| {
            let pairs = (samples + FIRST_PAIR) as usize;
            let color = fill.values(random, 3 * pairs, [0.0, 1.0], 1.0);
            let gradient = fill.values(random, 12 * pairs, [-1.0, 1.0], 1e30);
            let stride = samples + 3;
            Self(ColorHeadBackwardInputs {
                params: ColorHeadBackwardParams { samples, first_pair: FIRST_PAIR, stride },
                color: color.into_iter().map(f32::abs).collect(),
                pair_gradient: gradient.chunks_exact(4).map(Vec4::from_slice).collect(),
                logit_gradient: unwritten(3 * stride as usize),
            })
        })
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        runner.run(&self.kernel(), self.params.samples, 1)
    }

    fn bound(&self, _: &Output, index: usize, _: Rounding) -> Bound {
        let channel = index / self.params.stride as usize;
        let sample = index % self.params.stride as usize;
        if sample >= self.params.samples as usize {
            return Bound::EXACT;
        }
        let pair = sample + FIRST_PAIR as usize;
        let gradient = f64::from(self.pair_gradient[3 * pair + 2][channel]).abs();
        let bound = Bound::relative_to(gradient * f64::from(self.color[3 * pair + channel]));
        // a color that may be flushed
        Bound { floor: bound.floor * (1.0 + gradient), ..bound }
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<f64> {
        let channel = index / self.params.stride as usize;
        let sample = index % self.params.stride as usize;
        (sample < self.params.samples as usize).then(|| {
            let pair = sample + FIRST_PAIR as usize;
            let of_color = Dual::from(f64::from(self.pair_gradient[3 * pair + 2][channel]));
            let before = logit(f64::from(self.color[3 * pair + channel]));
            let [slope] = gradient([before], |[x]| of_color * sigmoid(x));
            slope
        })
    }
}

case!(pub MaterialBackward(MaterialBackwardInputs));

impl MaterialBackward {
    /// The gradient of a pair's material.  The network's input is a copy of the material, so this copies its gradient.
    fn gradient_at(&self, index: usize) -> Option<f64> {
        let material = self.params.material as usize;
        let stride = self.params.stride as usize;
        let pair = index / material;
        let value = index % material;
        let sample = pair.checked_sub(FIRST_PAIR as usize);
        let sample = sample.filter(|&sample| sample < self.params.samples as usize)?;
        Some(f64::from(self.input_gradient[(1 + value) * stride + sample]))
    }
}

impl Parity for MaterialBackward {
    const KERNEL: &'static str = "material_backward";
    const TOLERANCE: f64 = 1e-7;
    const WHY: &'static str = "a copy";

    fn sets() -> Vec<(String, Self)> {
        let set = |samples: u32, material: u32, fill: Fill, random: &mut Random| {
            let stride = samples + 3;
            let len = ((1 + material) * stride) as usize;
            Self(MaterialBackwardInputs {
                params: MaterialBackwardParams {
                    samples,
                    first_pair: FIRST_PAIR,
                    stride,
                    material,
                    material_row: 1,
                },
                input_gradient: fill.values(random, len, [-1.0, 1.0], 3e38),
                pair_material: unwritten(((samples + FIRST_PAIR) * material) as usize),
            })
        };
        let mut sets = inputs::sets(|n, fill, random| set(n, 3, fill, random));
        for material in [1, 256] {
            let mut random = Random::new(13);
            let set = set(ITEMS, material, Fill::Random, &mut random);
            sets.push((format!("{material} values"), set));
        }
        sets
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        runner.run(&self.kernel(), self.params.samples, 1)
    }

    fn bound(&self, _: &Output, index: usize, _: Rounding) -> Bound {
        // a GPU may flush it
        self.gradient_at(index).map_or(Bound::EXACT, |_| Bound::relative_to(0.0))
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<f64> {
        self.gradient_at(index)
    }
}
