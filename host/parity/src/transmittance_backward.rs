//! Cases of `gradient_count`, `segment_product_backward`, `transmittance_head_backward` and `extra_backward`.

use glam::Vec4;
use muslin_check::prelude::*;
use organza_shaders::transmittance_backward::{
    ExtraBackwardInputs, ExtraBackwardParams, GradientCountInputs, GradientCountParams, NOTHING,
    SegmentProductBackwardInputs, SegmentProductBackwardParams, TransmittanceHeadBackwardInputs,
};

use super::dense::{Dense, head_sets};
use super::exact::transmittance::log_rho;
use super::scan::prefix;
use super::steps::Rays;
use super::transmittance::{FIRST_SAMPLE, factor, long_pairs, owner, points, some_pairs};

/// Samples behind the chunk.
const AFTER: u32 = 2;

/// The first samples of pairs, and the number of samples in the chunk. Three more samples lie before the chunk, two behind.
type Chunk = (Vec<u32>, u32);

/// Chunks of all sizes, and chunks with long segments.
fn sets<T>(seed: u64, new: impl Fn(Chunk, Fill, &mut Random) -> T) -> Vec<(String, T)> {
    let mut sets = inputs::sets(|n, fill, random| new(chunk(n, random), fill, random));
    for (name, pairs) in long_pairs() {
        let samples = pairs[pairs.len() - 1] - FIRST_SAMPLE - AFTER;
        sets.push((name.into(), new((pairs, samples), Fill::Random, &mut Random::new(seed))));
    }
    sets
}

fn chunk(samples: u32, random: &mut Random) -> Chunk {
    (some_pairs(FIRST_SAMPLE + samples + AFTER, random), samples)
}

/// The first pair of the chunk, and how many have samples in it or lie between such.
fn pairs((first_sample, samples): &Chunk) -> [u32; 2] {
    let first = owner(first_sample, 0);
    let end = first_sample.partition_point(|&begin| begin < FIRST_SAMPLE + samples);
    [first as u32, end.saturating_sub(first) as u32]
}

/// The gradient of each sample's logarithm in a pair: a logarithm is a term of the sum.
fn log_rho_gradient(
    power: f32,
    pair_gradient: &[Vec4],
    transmittance: &[f32],
    pair: usize,
) -> Rounded {
    let slope = Rounded::from(pair_gradient[3 * pair].w);
    // the slope of an exponential, of its value
    Rounded::from(power) * (slope * transmittance[pair].into())
}

case!(pub GradientCount(GradientCountInputs) { rays: Rays });

impl GradientCount {
    fn new(pairs: u32, faint: f32, fill: Fill, random: &mut Random) -> Self {
        let all = pairs as usize;
        let steps: Vec<_> = (0..pairs).map(|_| random.below(40)).collect();
        let rays = Rays::new(&steps, fill, random);
        let inputs = GradientCountInputs {
            params: GradientCountParams { pairs, power: 2.0, faint },
            segment: rays.vectors.clone(),
            first_sample: prefix((0..pairs).map(|_| random.below(9).saturating_sub(2))),
            transmittance: random.values(all, 0.0, 1.0),
            pair_gradient: fill.vectors(random, 3 * all, [-1.0, 1.0], 3e38),
            count: unwritten(all),
        };
        Self { inputs, rays }
    }
}

impl Parity for GradientCount {
    fn sets() -> Vec<(String, Self)> {
        let mut sets = Vec::new();
        for faint in [0.0, 0.3, 3.0] {
            let of = inputs::sets(|pairs, fill, random| Self::new(pairs, faint, fill, random));
            sets.extend(of.into_iter().map(|(name, set)| (format!("{name}, {faint}"), set)));
        }
        sets
    }

    fn exact_at(&self, _: &str, pair: usize) -> Option<Rounded> {
        let GradientCountParams { power, faint, .. } = self.params;
        let gradient = log_rho_gradient(power, &self.pair_gradient, &self.transmittance, pair);
        let bound = self.rays.gradient_chance(pair) * f64::from(faint);
        let bound = bound.max(NOTHING.into());
        // one rounding of the bound
        let is_close = (gradient.value.abs() - bound).abs() <= gradient.error + 1e-7 * bound;
        if is_close && gradient.value != 0.0 {
            return Some(Rounded::UNKNOWN);
        }
        let samples = self.first_sample[pair + 1] - self.first_sample[pair];
        Some(Rounded::exact(if gradient.value.abs() > bound { samples.into() } else { 0.0 }))
    }
}

case!(pub SegmentProductBackward(SegmentProductBackwardInputs));

impl SegmentProductBackward {
    fn new(chunk: Chunk, fill: Fill, random: &mut Random) -> Self {
        let [first_pair, pairs] = pairs(&chunk);
        let (first_sample, samples) = chunk;
        let all_pairs = first_sample.len() - 1;
        let transmittance = fill.values(random, all_pairs, [0.0, 1.0], 1.0);
        Self(SegmentProductBackwardInputs {
            params: SegmentProductBackwardParams {
                pairs,
                first_pair,
                samples,
                first_sample: FIRST_SAMPLE,
                power: 1.0,
                faint: 0.0,
            },
            first_sample,
            transmittance: transmittance.into_iter().map(f32::abs).collect(),
            pair_gradient: fill.vectors(random, 3 * all_pairs, [-1.0, 1.0], 3e38),
            log_rho_gradient: unwritten(samples as usize),
        })
    }
}

impl Parity for SegmentProductBackward {
    fn sets() -> Vec<(String, Self)> {
        let mut sets = sets(14, Self::new);
        let mut random = Random::new(15);
        let mut set = Self::new(chunk(900, &mut random), Fill::Random, &mut random);
        set.params.power = 4.0;
        sets.push(("steps four times as long".into(), set.clone()));
        set.params.faint = 0.5;
        sets.push(("roulette".into(), set));
        sets
    }

    fn exact_at(&self, _: &str, sample: usize) -> Option<Rounded> {
        let pair = owner(&self.first_sample, sample);
        let SegmentProductBackwardParams { power, faint, .. } = self.params;
        let gradient = log_rho_gradient(power, &self.pair_gradient, &self.transmittance, pair);
        let is_faint = gradient.value.abs() < f64::from(faint);
        let survivor = if gradient.value < 0.0 { -faint } else { faint };
        Some(if is_faint { survivor.into() } else { gradient })
    }
}

// the last layer has one column
case!(pub TransmittanceHeadBackward(TransmittanceHeadBackwardInputs) { layer: Dense });

impl Parity for TransmittanceHeadBackward {
    fn sets() -> Vec<(String, Self)> {
        head_sets(|layer, fill, random| {
            let len = layer.params.stride as usize;
            let inputs = TransmittanceHeadBackwardInputs {
                params: layer.head_params(FIRST_SAMPLE),
                parameters: layer.parameters.clone(),
                point: points(&layer, fill, random),
                input: layer.input.clone(),
                log_rho_gradient: fill.values(random, len, [-1.0, 1.0], 1e30),
                logit_gradient: unwritten(layer.params.samples as usize),
            };
            Self { inputs, layer }
        })
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<Rounded> {
        let slope = Rounded::from(self.log_rho_gradient[index]);
        let factor = factor(&self.layer, &self.point, index as u32);
        let a = self.layer.sum(index as u32, 0);
        Some(gradient([a], |[a]| Dual::constant(slope) * log_rho(a, Dual::constant(factor)))[0])
    }
}

/// Values of an extra vector.
const EXTRA: usize = 3;

case!(pub ExtraBackward(ExtraBackwardInputs));

impl ExtraBackward {
    fn new(chunk: Chunk, fill: Fill, random: &mut Random) -> Self {
        let [first_pair, pairs] = pairs(&chunk);
        let (first_sample, samples) = chunk;
        let stride = samples + 5;
        let gradients = (1 + EXTRA) * stride as usize;
        Self(ExtraBackwardInputs {
            params: ExtraBackwardParams {
                pairs,
                first_pair,
                samples,
                first_sample: FIRST_SAMPLE,
                stride,
                extra: EXTRA as u32,
                extra_row: 1,
            },
            input_gradient: fill.values(random, gradients, [-1.0, 1.0], 1e30),
            pair_extra: fill.values(random, EXTRA * (first_sample.len() - 1), [-1.0, 1.0], 1e30),
            first_sample,
        })
    }
}

impl Parity for ExtraBackward {
    fn sets() -> Vec<(String, Self)> {
        sets(15, Self::new)
    }

    /// Every sample of a pair has a copy of its extra vector. The gradients of the copies in the chunk are added to the sum.
    fn exact_at(&self, _: &str, index: usize) -> Option<Rounded> {
        let ExtraBackwardParams { samples, stride, .. } = self.params;
        let row = &self.input_gradient[(1 + index % EXTRA) * stride as usize..];
        let [begin, end] = [0, 1].map(|next| {
            let sample = self.first_sample[index / EXTRA + next];
            sample.saturating_sub(FIRST_SAMPLE).min(samples) as usize
        });
        let terms = self.pair_extra[index..][..1].iter().chain(&row[begin..end]);
        Some(Number::sum(terms.copied().map(Rounded::from)))
    }
}
