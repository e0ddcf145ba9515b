//! Cases of `segment_product_backward`, `transmittance_head_backward` and `extra_backward`.

use glam::Vec4;
use muslin_check::prelude::*;
use organza_shaders::transmittance_backward::{
    ExtraBackwardInputs, ExtraBackwardParams, SegmentProductBackwardInputs,
    SegmentProductBackwardParams, TransmittanceHeadBackwardKernel,
};

use super::dense::Dense;
use super::exact::numeric::{Dual, gradient};
use super::exact::transmittance::{log_rho, transmittance};
use super::transmittance::{FIRST_SAMPLE, head_sets, long_pairs, owner, points, some_pairs};

/// Samples behind the chunk.
const AFTER: u32 = 2;

/// The first samples of pairs, and the number of those in the chunk: three others lie before them and two behind.
type Chunk = (Vec<u32>, u32);

/// The chunks of all sizes, and those with long segments.
fn sets<T>(seed: u64, new: impl Fn(Chunk, Fill, &mut Random) -> T) -> Vec<(String, T)> {
    let mut sets = inputs::sets(|n, fill, random| new(chunk(n, random), fill, random));
    for (name, pairs) in long_pairs() {
        let samples = pairs[pairs.len() - 1] - FIRST_SAMPLE - AFTER;
        let set = new((pairs, samples), Fill::Random, &mut Random::new(seed));
        sets.push((name.into(), set));
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

case!(pub SegmentProductBackward(SegmentProductBackwardInputs));

impl SegmentProductBackward {
    fn new(chunk: Chunk, fill: Fill, random: &mut Random) -> Self {
        let [first_pair, pairs] = pairs(&chunk);
        let (first_sample, samples) = chunk;
        let all_pairs = first_sample.len() - 1;
        let transmittance = fill.values(random, all_pairs, [0.0, 1.0], 1.0);
        let gradient = fill.values(random, 12 * all_pairs, [-1.0, 1.0], 3e38);
        Self(SegmentProductBackwardInputs {
            params: SegmentProductBackwardParams {
                pairs,
                first_pair,
                samples,
                first_sample: FIRST_SAMPLE,
                power: 1.0,
            },
            first_sample,
            transmittance: transmittance.into_iter().map(f32::abs).collect(),
            pair_gradient: gradient.chunks_exact(4).map(Vec4::from_slice).collect(),
            log_rho_gradient: unwritten(samples as usize),
        })
    }

    /// The pair of a sample, and the gradient of its transmittance.
    fn gradient(&self, sample: usize) -> (usize, f64) {
        let pair = owner(&self.first_sample, sample);
        (pair, f64::from(self.pair_gradient[3 * pair].w))
    }
}

impl Parity for SegmentProductBackward {
    const KERNEL: &'static str = "segment_product_backward";
    const TOLERANCE: f64 = 1.2e-7;
    const WHY: &'static str = "a product";

    fn sets() -> Vec<(String, Self)> {
        let mut sets = sets(14, Self::new);
        let mut random = Random::new(15);
        let mut set = Self::new(chunk(900, &mut random), Fill::Random, &mut random);
        set.params.power = 4.0;
        sets.push(("steps four times as long".into(), set));
        sets
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        runner.run(&self.kernel(), self.params.pairs, 1)
    }

    fn bound(&self, cpu: &Output, index: usize, _: Rounding) -> Bound {
        let (_, gradient) = self.gradient(index);
        // a transmittance that may be flushed
        Bound { scale: cpu.floats()[index].abs(), floor: f64::from(TINY) * (1.0 + gradient.abs()) }
    }

    fn exact_at(&self, _: &str, sample: usize) -> Option<f64> {
        let (pair, of_pair) = self.gradient(sample);
        let of_pair = Dual::from(of_pair);
        // a sample's logarithm is a term of the sum
        let power = f64::from(self.params.power);
        let sum = f64::from(self.transmittance[pair]).ln().max(-745.0) / power;
        let [slope] = gradient([sum], |[sum]| of_pair * transmittance(Dual::from(power) * sum));
        Some(slope)
    }
}

/// The last layer has one column.
#[derive(Clone)]
pub struct TransmittanceHeadBackward {
    layer: Dense,
    factor: Vec<f32>,
    gradient: Vec<f32>,
}

impl TransmittanceHeadBackward {
    fn new(layer: Dense, fill: Fill, random: &mut Random) -> Self {
        let len = layer.params.stride as usize;
        let factor = fill.values(random, len, [0.0, 1.0], 1.0);
        let gradient = fill.values(random, len, [-1.0, 1.0], 1e30);
        Self { layer, factor: factor.into_iter().map(f32::abs).collect(), gradient }
    }
}

impl Parity for TransmittanceHeadBackward {
    const KERNEL: &'static str = "transmittance_head_backward";
    const TOLERANCE: f64 = 4e-7;
    const WHY: &'static str = "a_k is off by roundings of its terms' sizes M, a sigmoid by as much relatively, and by \
        exp's 3 + 2 abs(x) ulp";

    fn sets() -> Vec<(String, Self)> {
        head_sets(Self::new)
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let layer = &self.layer;
        let kernel = TransmittanceHeadBackwardKernel {
            params: layer.head_params(FIRST_SAMPLE),
            parameters: &layer.parameters,
            point: &points(layer, &self.factor),
            input: &layer.input,
            log_rho_gradient: &self.gradient,
            logit_gradient: &unwritten(layer.params.samples as usize),
        };
        runner.run(&kernel, layer.params.samples, 1)
    }

    fn bound(&self, cpu: &Output, index: usize, _: Rounding) -> Bound {
        let Bound { scale: terms, floor } = self.layer.sum_bound(index as u32, 0);
        let gradient = f64::from(self.gradient[index]).abs();
        let most = gradient * f64::from(self.factor[index]);
        // where a_k itself is lost, so is the sigmoid
        let is_lost = terms * Self::TOLERANCE > 0.1;
        let found = cpu.floats()[index].abs();
        let scale =
            if is_lost { 1.1 * most / Self::TOLERANCE } else { found * (1.0 + 3.0 * terms) };
        // a factor and a sigmoid that may be flushed
        Bound { scale, floor: (floor + f64::from(TINY)) * (1.0 + gradient) }
    }

    fn exact_at(&self, _: &str, sample: usize) -> Option<f64> {
        let [g, factor] = [&self.gradient, &self.factor].map(|of| f64::from(of[sample]));
        let a = self.layer.sum(sample as u32, 0);
        Some(gradient([a], |[a]| Dual::from(g) * log_rho(a, factor))[0])
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

    /// What was there before, and the gradients of the pair's samples in the chunk.
    fn terms(&self, index: usize) -> (f64, Vec<f64>) {
        let ExtraBackwardParams { samples, stride, .. } = self.params;
        let row = &self.input_gradient[(1 + index % EXTRA) * stride as usize..];
        let [begin, end] = [0, 1].map(|next| {
            let sample = self.first_sample[index / EXTRA + next];
            sample.saturating_sub(FIRST_SAMPLE).min(samples) as usize
        });
        let samples = row[begin..end].iter().copied().map(f64::from);
        (self.pair_extra[index].into(), samples.collect())
    }
}

impl Parity for ExtraBackward {
    const KERNEL: &'static str = "extra_backward";
    const TOLERANCE: f64 = 1.2e-7;
    const WHY: &'static str = "a rounding of both devices for each of the pair's samples, of the terms' sizes: lanes \
        are added up in another order";

    fn sets() -> Vec<(String, Self)> {
        sets(15, Self::new)
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        runner.run(&self.kernel(), self.params.pairs, EXTRA as u32)
    }

    fn bound(&self, _: &Output, index: usize, _: Rounding) -> Bound {
        let (before, samples) = self.terms(index);
        let terms = 1.0 + samples.len() as f64;
        let sum: f64 = samples.into_iter().chain([before]).map(f64::abs).sum();
        Bound { scale: sum * terms, floor: f64::from(TINY) * terms }
    }

    /// Every sample of a pair has a copy of its extra vector.
    fn exact_at(&self, _: &str, index: usize) -> Option<f64> {
        let (before, samples) = self.terms(index);
        Some(before + samples.iter().sum::<f64>())
    }
}
