//! Cases of `segment_product_backward`, `transmittance_head_backward` and `extra_backward`.

use glam::Vec4;
use muslin_check::prelude::*;
use organza_shaders::transmittance_backward::{
    ExtraBackwardKernel, ExtraBackwardParams, SegmentProductBackwardKernel,
    SegmentProductBackwardParams, TransmittanceHeadBackwardKernel,
};

use super::dense::Layer;
use super::exact::numeric::{Dual, gradient};
use super::exact::transmittance::{log_rho, transmittance};
use super::transmittance::{counts, head_params, head_sets, points, prefix};

/// Samples before the chunk.
pub(super) const FIRST_SAMPLE: u32 = 3;

/// Samples behind the chunk.
const AFTER: u32 = 2;

/// A chunk of samples and the pairs that own them.
#[derive(Clone, Debug)]
pub struct Chunk {
    /// `[pairs + 1]`
    pub first_sample: Vec<u32>,
    /// Samples of the chunk; three others lie before them and two behind.
    pub samples: u32,
}

impl Chunk {
    fn new(samples: u32, random: &mut Random) -> Self {
        let counts = counts(FIRST_SAMPLE + samples + AFTER, random);
        Self { first_sample: prefix(&counts), samples }
    }

    /// Chunks with long segments, by name.
    fn long() -> Vec<(&'static str, Self)> {
        [
            ("one pair has all", vec![16_384]),
            ("the last has all", vec![0, 0, 0, 0, 5000]),
            ("the first has all", vec![5000, 0, 0, 0, 0]),
            ("each has one", vec![1; 700]),
        ]
        .map(|(name, counts)| {
            let samples = counts.iter().sum::<u32>() - FIRST_SAMPLE - AFTER;
            (name, Self { first_sample: prefix(&counts), samples })
        })
        .into()
    }

    fn all_pairs(&self) -> usize {
        self.first_sample.len() - 1
    }

    /// The first pair of the chunk, and how many have samples in it or lie between such.
    fn pairs(&self) -> [u32; 2] {
        let end = FIRST_SAMPLE + self.samples;
        let first = self.first_sample.partition_point(|&begin| begin <= FIRST_SAMPLE) - 1;
        let end = self.first_sample.partition_point(|&begin| begin < end);
        [first as u32, end.saturating_sub(first) as u32]
    }

    /// The pair of a sample of the chunk.
    pub(super) fn owner(&self, sample: usize) -> usize {
        let sample = FIRST_SAMPLE + sample as u32;
        self.first_sample.partition_point(|&first| first <= sample) - 1
    }

    /// A pair's samples in the chunk.
    fn samples_of_pair(&self, pair: usize) -> std::ops::Range<usize> {
        let at = |sample: u32| sample.saturating_sub(FIRST_SAMPLE).min(self.samples) as usize;
        at(self.first_sample[pair])..at(self.first_sample[pair + 1])
    }
}

/// Inputs of `segment_product_backward`.
#[derive(Clone, Debug)]
pub struct SegmentProductBackward {
    /// The samples.
    pub chunk: Chunk,
    /// `[pairs]`
    pub transmittance: Vec<f32>,
    /// `[pairs, 3]`
    pub gradient: Vec<Vec4>,
    /// How many times as long as sigma the steps are.
    pub power: f32,
}

impl SegmentProductBackward {
    fn new(chunk: Chunk, fill: Fill, random: &mut Random) -> Self {
        let pairs = chunk.all_pairs();
        let transmittance = fill.values(random, pairs, [0.0, 1.0], 1.0);
        let gradient = fill.values(random, 12 * pairs, [-1.0, 1.0], 3e38);
        Self {
            chunk,
            transmittance: transmittance.into_iter().map(f32::abs).collect(),
            gradient: gradient.chunks_exact(4).map(Vec4::from_slice).collect(),
            power: 1.0,
        }
    }
}

impl Parity for SegmentProductBackward {
    const KERNEL: &'static str = "segment_product_backward";
    const TOLERANCE: f64 = 1.2e-7;
    const WHY: &'static str = "a product";

    fn sets() -> Vec<(String, Self)> {
        let mut sets = inputs::sets(|n, fill, random| {
            let chunk = Chunk::new(n, random);
            Self::new(chunk, fill, random)
        });
        for (name, chunk) in Chunk::long() {
            sets.push((name.into(), Self::new(chunk, Fill::Random, &mut Random::new(14))));
        }
        let mut random = Random::new(15);
        let set = Self::new(Chunk::new(900, &mut random), Fill::Random, &mut random);
        sets.push(("steps four times as long".into(), Self { power: 4.0, ..set }));
        sets
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let chunk = &self.chunk;
        let [first_pair, pairs] = chunk.pairs();
        let kernel = SegmentProductBackwardKernel {
            params: SegmentProductBackwardParams {
                pairs,
                first_pair,
                samples: chunk.samples,
                first_sample: FIRST_SAMPLE,
                power: self.power,
            },
            first_sample: &chunk.first_sample,
            transmittance: &self.transmittance,
            pair_gradient: &self.gradient,
            log_rho_gradient: &unwritten(chunk.samples as usize),
        };
        runner.run(&kernel, pairs, 1)
    }

    fn bound(&self, cpu: &Output, index: usize, _: Rounding) -> Bound {
        let gradient = f64::from(self.gradient[3 * self.chunk.owner(index)].w).abs();
        // a transmittance that may be flushed
        Bound { scale: cpu.floats()[index].abs(), floor: f64::from(TINY) * (1.0 + gradient) }
    }

    fn exact_at(&self, _: &str, sample: usize) -> Option<f64> {
        let pair = self.chunk.owner(sample);
        let of_pair = Dual::from(f64::from(self.gradient[3 * pair].w));
        // a sample's logarithm is a term of the sum
        let power = f64::from(self.power);
        let sum = f64::from(self.transmittance[pair]).ln().max(-745.0) / power;
        let [slope] = gradient([sum], |[sum]| of_pair * transmittance(Dual::from(power) * sum));
        Some(slope)
    }
}

/// Inputs of `transmittance_head_backward`.
#[derive(Clone, Debug)]
pub struct TransmittanceHeadBackward {
    /// The last layer: one column.
    pub layer: Layer,
    /// `[stride]`
    pub factor: Vec<f32>,
    /// `[stride]`: dL/dlog_rho
    pub gradient: Vec<f32>,
}

impl TransmittanceHeadBackward {
    fn new(layer: Layer, fill: Fill, random: &mut Random) -> Self {
        let len = layer.stride as usize;
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
            params: head_params(layer),
            parameters: &layer.parameters,
            point: &points(layer, &self.factor),
            input: &layer.input,
            log_rho_gradient: &self.gradient,
            logit_gradient: &unwritten(layer.samples as usize),
        };
        runner.run(&kernel, layer.samples, 1)
    }

    fn bound(&self, cpu: &Output, index: usize, _: Rounding) -> Bound {
        let Bound { scale: terms, floor } = self.layer.bound(index as u32, 0);
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
        let a = self.layer.exact(sample as u32, 0);
        Some(gradient([a], |[a]| Dual::from(g) * log_rho(a, factor))[0])
    }
}

/// Inputs of `extra_backward`.
#[derive(Clone, Debug)]
pub struct ExtraBackward {
    /// The samples.
    pub chunk: Chunk,
    /// Distance of two rows.
    pub stride: u32,
    /// `[1 + extra, stride]`
    pub gradient: Vec<f32>,
    /// `[pairs, extra]`, before
    pub pair_extra: Vec<f32>,
}

/// Values of an extra vector.
const EXTRA: usize = 3;

impl ExtraBackward {
    fn new(chunk: Chunk, fill: Fill, random: &mut Random) -> Self {
        let stride = chunk.samples + 5;
        let gradient = fill.values(random, (1 + EXTRA) * stride as usize, [-1.0, 1.0], 1e30);
        let pair_extra = fill.values(random, EXTRA * chunk.all_pairs(), [-1.0, 1.0], 1e30);
        Self { chunk, stride, gradient, pair_extra }
    }
}

impl Parity for ExtraBackward {
    const KERNEL: &'static str = "extra_backward";
    const TOLERANCE: f64 = 1.2e-7;
    const WHY: &'static str = "a rounding of both devices for each of the pair's samples, of the terms' sizes: lanes \
        are added up in another order";

    fn sets() -> Vec<(String, Self)> {
        let mut sets = inputs::sets(|n, fill, random| {
            let chunk = Chunk::new(n, random);
            Self::new(chunk, fill, random)
        });
        for (name, chunk) in Chunk::long() {
            sets.push((name.into(), Self::new(chunk, Fill::Random, &mut Random::new(15))));
        }
        sets
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let chunk = &self.chunk;
        let [first_pair, pairs] = chunk.pairs();
        let kernel = ExtraBackwardKernel {
            params: ExtraBackwardParams {
                pairs,
                first_pair,
                samples: chunk.samples,
                first_sample: FIRST_SAMPLE,
                stride: self.stride,
                extra: EXTRA as u32,
                extra_row: 1,
            },
            first_sample: &chunk.first_sample,
            input_gradient: &self.gradient,
            pair_extra: &self.pair_extra,
        };
        runner.run(&kernel, pairs, EXTRA as u32)
    }

    fn bound(&self, _: &Output, index: usize, _: Rounding) -> Bound {
        let before = self.pair_extra[index];
        let row = &self.gradient[(1 + index % EXTRA) * self.stride as usize..];
        let samples = &row[self.chunk.samples_of_pair(index / EXTRA)];
        let sum: f64 = samples.iter().chain([&before]).map(|x| f64::from(x.abs())).sum();
        let terms = 1.0 + samples.len() as f64;
        Bound { scale: sum * terms, floor: f64::from(TINY) * terms }
    }

    /// Every sample of a pair has a copy of its extra vector.
    fn exact_at(&self, _: &str, index: usize) -> Option<f64> {
        let before = f64::from(self.pair_extra[index]);
        let row = &self.gradient[(1 + index % EXTRA) * self.stride as usize..];
        let samples = &row[self.chunk.samples_of_pair(index / EXTRA)];
        Some(before + samples.iter().map(|&g| f64::from(g)).sum::<f64>())
    }
}
