//! The cases of `hash_grid_peak`, `hash_grid_norm` and `hash_grid_scale`.

use glam::Vec4;
use muslin_check::prelude::*;
use organza_shaders::hash_grid_scale::{
    HashGridNormInputs, HashGridNormParams, HashGridPeakInputs, HashGridPeakParams,
    HashGridScaleInputs, HashGridScaleParams, SCALE_VALUES,
};
use organza_shaders::limits::MAX_LAYERS;

use super::exact::hash_grid_scale::{color_bound, largest, transmittance_bound, unit};

/// The bounds as numbers; NaN counts as infinite.
fn numbers(found: &[Output]) -> Vec<Output> {
    let number = |bits| {
        let number = f32::from_bits(bits);
        if number.is_nan() { f32::INFINITY } else { number }
    };
    vec![Output::float("bound", found[0].words().into_iter().map(number))]
}

/// Values that must not get lost.
const NO_NUMBERS: [f32; 3] = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY];

case!(pub HashGridPeak(HashGridPeakInputs));

impl Parity for HashGridPeak {
    fn sets() -> Vec<(String, Self)> {
        let set = |pair_gradient, transmittance: Vec<f32>, color, power| {
            let pairs = transmittance.len() as u32;
            let params = HashGridPeakParams { pairs, color: u32::from(color), power, faint: 0.0 };
            Self(HashGridPeakInputs { params, pair_gradient, transmittance, bound: vec![0] })
        };
        let mut sets = Vec::new();
        for (kind, color) in [("transmittance", false), ("color", true)] {
            let random = inputs::sets(|pairs, fill, random| {
                let pair_gradient = fill.vectors(random, 3 * pairs as usize, [-1.0, 1.0], 1e30);
                set(pair_gradient, random.values(pairs as usize, 0.0, 1.0), color, 2.0)
            });
            sets.extend(random.into_iter().map(|(name, set)| (format!("{kind}, {name}"), set)));
            for bad in NO_NUMBERS {
                let random = &mut Random::new(16);
                let mut pair_gradient = Fill::Random.vectors(random, 3 * 100, [-1.0, 1.0], 1.0);
                pair_gradient[3 * 70] = Vec4::new(0.0, 0.0, 0.0, bad);
                pair_gradient[3 * 70 + 2] = Vec4::new(0.0, bad, 0.0, 0.0);
                let transmittance = random.values(100, 0.1, 1.0);
                sets.push((
                    format!("{kind}, {bad}"),
                    set(pair_gradient, transmittance, color, 1.0),
                ));
            }
        }
        // gradients that survive a roulette may be larger
        for faint in [0.5, 100.0] {
            let mut faint_set = set(vec![Vec4::splat(2.0); 300], vec![0.7; 100], false, 1.0);
            faint_set.params.faint = faint;
            sets.push((format!("faint below {faint}"), faint_set));
        }
        sets
    }

    fn convert(&self, outputs: Vec<Output>) -> Vec<Output> {
        numbers(&outputs)
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<Rounded>> {
        let HashGridPeakParams { power, faint, .. } = self.params;
        let of_pair = |(pair, &t): (&[Vec4], &f32)| match self.params.color == 1 {
            true => color_bound(pair[2].truncate().to_array().map(Rounded::from)),
            false => match transmittance_bound([pair[0].w, t, power].map(Rounded::from)) {
                bound if bound.value < faint.into() => faint.into(),
                bound => bound,
            },
        };
        listed([largest(self.pair_gradient.chunks_exact(3).zip(&self.transmittance).map(of_pair))])
    }
}

case!(pub HashGridNorm(HashGridNormInputs));

/// Parameters before the layer's.
const BEFORE: u32 = 5;

/// The layer's place in the bounds.
const SLOT: u32 = 2;

impl Parity for HashGridNorm {
    fn sets() -> Vec<(String, Self)> {
        let set = |inputs, columns, parameters| {
            let params = HashGridNormParams { inputs, columns, weight: BEFORE, slot: SLOT };
            Self(HashGridNormInputs { params, parameters, bound: vec![0; SLOT as usize + 1] })
        };
        let mut sets = inputs::sets(|inputs, fill, random| {
            let columns = 1 + random.below(32);
            let len = (BEFORE + inputs * columns) as usize;
            set(inputs, columns, fill.vectors(random, len, [-1.0, 1.0], 1e30))
        });
        for bad in NO_NUMBERS {
            let mut parameters =
                Fill::Random.vectors(&mut Random::new(18), 5 + 70 * 2, [-1.0, 1.0], 1.0);
            parameters[5 + 67 * 2 + 1].y = bad;
            sets.push((bad.to_string(), set(70, 2, parameters)));
        }
        sets
    }

    fn convert(&self, outputs: Vec<Output>) -> Vec<Output> {
        numbers(&outputs)
    }

    /// `max_i sum_o |W[o, i]|`; the bounds of other layers stay 0.
    fn exact(&self, _: &str, len: usize) -> Vec<Option<Rounded>> {
        let weights = self.parameters[BEFORE as usize..].chunks_exact(self.params.columns as usize);
        let sum = |input: &[Vec4]| {
            Rounded::sum(input.iter().flat_map(|vector| vector.abs().to_array()).map(Rounded::from))
        };
        let mut exact = vec![Some(Rounded::exact(0.0)); len];
        exact[SLOT as usize] = Some(largest(weights.map(sum)));
        exact
    }
}

case!(pub HashGridScale(HashGridScaleInputs));

impl Parity for HashGridScale {
    fn sets() -> Vec<(String, Self)> {
        let set = |bound: Vec<f32>, samples| {
            Self(HashGridScaleInputs {
                params: HashGridScaleParams { layers: bound.len() as u32 - 1, samples },
                bound: bound.into_iter().map(f32::to_bits).collect(),
                scale: unwritten(SCALE_VALUES as usize),
                status: vec![0],
            })
        };
        let mut random = Random::new(15);
        let fills = [Fill::Random].into_iter().chain(Fill::ADVERSARIAL);
        let mut sets: Vec<_> = fills
            .flat_map(|fill| (1..=MAX_LAYERS).map(move |layers| (fill, layers)))
            .map(|(fill, layers)| {
                let bound = fill.values(&mut random, 1 + layers as usize, [0.0, 20.0], 3e38);
                let bound = bound.into_iter().map(f32::abs).collect();
                // around a power of two
                let samples = (1 << random.below(32)) + random.below(3) - 1;
                (format!("{}, {layers} layers", fill.name()), set(bound, samples))
            })
            .collect();
        for samples in [0, u32::MAX] {
            sets.push((format!("{samples} samples"), set(vec![1.0, 3.0], samples)));
        }
        for bad in [f32::NAN, f32::INFINITY] {
            sets.push((format!("{bad}"), set(vec![1.0, bad, 2.0], 300)));
        }
        sets
    }

    fn convert(&self, mut outputs: Vec<Output>) -> Vec<Output> {
        let bits = outputs[1].values.iter().map(|&value| (value as f32).to_bits());
        outputs[1] = Output::exact("scale", bits);
        outputs
    }

    /// The bits of the unit, its inverse and the limit. If a bound is not finite, the limit is 0 and the unit is not used.
    fn exact(&self, output: &str, _: usize) -> Vec<Option<Rounded>> {
        let bound: Vec<_> = self.bound.iter().copied().map(f32::from_bits).collect();
        let is_finite = bound.iter().all(|bound| bound.is_finite());
        match output {
            "bound" => listed(vec![0; bound.len()]),
            "status" => listed([if is_finite { 0 } else { 2 }]),
            _ if is_finite => {
                let (exponent, limit) = unit(&bound, self.params.samples);
                listed([2_f32.powi(exponent), 2_f32.powi(-exponent), limit].map(f32::to_bits))
            }
            _ => listed([Rounded::UNKNOWN, Rounded::UNKNOWN, 0.into()]),
        }
    }
}
