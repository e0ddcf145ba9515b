//! Cases of `color_head_backward` and `material_backward`.

use muslin_check::prelude::*;
use organza_shaders::color_backward::{
    ColorHeadBackwardInputs, ColorHeadBackwardParams, MaterialBackwardInputs,
    MaterialBackwardParams,
};

/// Pairs before the chunk.
const FIRST_PAIR: u32 = 2;

case!(pub ColorHeadBackward(ColorHeadBackwardInputs));

impl Parity for ColorHeadBackward {
    fn sets() -> Vec<(String, Self)> {
        inputs::sets(|samples, fill, random| {
            let pairs = (samples + FIRST_PAIR) as usize;
            let color = fill.values(random, 3 * pairs, [0.0, 1.0], 1.0);
            let stride = samples + 3;
            Self(ColorHeadBackwardInputs {
                params: ColorHeadBackwardParams { samples, first_pair: FIRST_PAIR, stride },
                color: color.into_iter().map(f32::abs).collect(),
                pair_gradient: fill.vectors(random, 3 * pairs, [-1.0, 1.0], 1e30),
                logit_gradient: unwritten(3 * stride as usize),
            })
        })
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<Rounded> {
        let channel = index / self.params.stride as usize;
        let sample = index % self.params.stride as usize;
        (sample < self.params.samples as usize).then(|| {
            let pair = sample + FIRST_PAIR as usize;
            let slope = Rounded::from(self.pair_gradient[3 * pair + 2][channel]);
            // the slope of a sigmoid, of its value
            let color = Rounded::from(self.color[3 * pair + channel]);
            slope * (color * (Rounded::from(1.0) - color))
        })
    }
}

case!(pub MaterialBackward(MaterialBackwardInputs));

impl Parity for MaterialBackward {
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

    /// The network's input is a copy of the material, so this copies its gradient.
    fn exact_at(&self, _: &str, index: usize) -> Option<Rounded> {
        let material = self.params.material as usize;
        let pair = index / material;
        let sample = pair.checked_sub(FIRST_PAIR as usize);
        let sample = sample.filter(|&sample| sample < self.params.samples as usize)?;
        let row = 1 + index % material;
        Some(self.input_gradient[row * self.params.stride as usize + sample].into())
    }
}
