//! Cases of `transmittance_inputs`, `transmittance_head` and `segment_product`.

use muslin_check::prelude::*;
use organza_shaders::hash_grid::POINT_ROWS;
use organza_shaders::segment::SEGMENT_VECTORS;
use organza_shaders::transmittance::{
    SegmentProductInputs, SegmentProductParams, TransmittanceHeadInputs, TransmittanceInputsInputs,
    TransmittanceInputsParams,
};

use super::color::joined;
use super::dense::{Dense, head_sets};
use super::exact::occupancy::OccupancyGrid;
use super::exact::transmittance::{log_rho, transmittance};
use super::scan::prefix;
use super::steps::Rays;

/// Samples before the chunk.
pub(super) const FIRST_SAMPLE: u32 = 3;

/// The first samples of pairs with about `samples` samples in all: most pairs have some, some have none.
pub(super) fn some_pairs(samples: u32, random: &mut Random) -> Vec<u32> {
    let mut counts = vec![0];
    let mut left = samples;
    while left > 0 {
        let count = random.below(9).saturating_sub(2).min(left);
        counts.push(count);
        left -= count;
    }
    counts.extend([0, 0]);
    prefix(counts)
}

/// First samples of pairs, some with many samples, by name.
pub(super) fn long_pairs() -> [(&'static str, Vec<u32>); 4] {
    [
        ("one pair has all", prefix([16_384])),
        ("the last has all", prefix([0, 0, 0, 0, 5000])),
        ("the first has all", prefix([5000, 0, 0, 0, 0])),
        ("each has one", prefix([1; 700])),
    ]
}

/// The pair of a sample of the chunk.
pub(super) fn owner(first_sample: &[u32], sample: usize) -> usize {
    first_sample.partition_point(|&first| first <= FIRST_SAMPLE + sample as u32) - 1
}

case!(pub TransmittanceInputs(TransmittanceInputsInputs) { rays: Rays });

impl TransmittanceInputs {
    /// Samples of a chunk; three others lie before them.
    fn new(samples: u32, first_sample: Vec<u32>, fill: Fill, random: &mut Random) -> Self {
        let gaussians = 29;
        let pairs = first_sample.len() - 1;
        let steps: Vec<_> = first_sample.windows(2).map(|range| range[1] - range[0]).collect();
        let rays = Rays::new(&steps, fill, random);
        let stride = samples + 5;
        let inputs = TransmittanceInputsInputs {
            params: TransmittanceInputsParams {
                samples,
                first_sample: FIRST_SAMPLE,
                stride,
                pairs: pairs as u32,
                gaussians,
                extra: 2,
                extra_row: 1,
                contracted: 0,
                side: 0,
                faint: 0.0,
            },
            pair: (0..pairs).map(|_| random.below(3 * gaussians)).collect(),
            first_sample,
            segment: rays.vectors.clone(),
            extra: fill.values(random, 2 * gaussians as usize, [-1.0, 1.0], 3e38),
            step: vec![0.0],
            occupancy: vec![0.0],
            point: unwritten(((POINT_ROWS + 1) * stride) as usize),
            input: unwritten(4 * stride as usize),
        };
        Self { inputs, rays }
    }

    /// The same samples as some of more steps, through a grid.
    fn listed(mut self, faint: f32, random: &mut Random) -> Self {
        let all = self.first_sample[self.first_sample.len() - 1] as usize;
        self.params.side = 7;
        self.params.faint = faint;
        let entries = self.grid().entries().pow(3);
        self.occupancy = (0..entries).map(|_| random.between(-0.5, 1.0).max(0.0)).collect();
        self.step = vec![0.0; all];
        for (pair, vectors) in self.rays.vectors.chunks_mut(SEGMENT_VECTORS as usize).enumerate() {
            vectors[3].w = vectors[3].w * 3.0 + 2.0;
            let samples = self.inputs.first_sample[pair]..self.inputs.first_sample[pair + 1];
            for (rank, sample) in samples.enumerate() {
                self.inputs.step[sample as usize] = (3 * rank as u32 + random.below(5)) as f32;
            }
        }
        self.inputs.segment = self.rays.vectors.clone();
        self
    }

    fn grid(&self) -> OccupancyGrid {
        let is_contracted = self.params.contracted == 1;
        OccupancyGrid { side: self.params.side, aabb: [[0.0; 3], [1.0; 3]], is_contracted }
    }

    /// The same samples on contracted rays, with ends up to 300 cubes away.
    fn contracted(mut self, random: &mut Random) -> Self {
        self.params.contracted = 1;
        self.rays = self.rays.contracted(random);
        self.inputs.segment = self.rays.vectors.clone();
        self
    }
}

impl Parity for TransmittanceInputs {
    fn sets() -> Vec<(String, Self)> {
        let mut sets = inputs::sets(|n, fill, random| {
            let pairs = some_pairs(n + FIRST_SAMPLE, random);
            Self::new(n, pairs, fill, random)
        });
        let mut random = Random::new(21);
        for samples in [3 * inputs::ITEMS, 5] {
            let pairs = some_pairs(samples + FIRST_SAMPLE, &mut random);
            let set = Self::new(samples, pairs, Fill::Random, &mut random);
            let contracted = set.clone().contracted(&mut random);
            for (name, set) in
                [("listed", set.clone()), ("contracted and listed", contracted.clone())]
            {
                for (more, faint) in [("", 0.0), (", roulette", 0.25)] {
                    let set = set.clone().listed(faint, &mut random);
                    sets.push((format!("{samples} samples, {name}{more}"), set));
                }
            }
            sets.push((format!("{samples} samples, contracted"), contracted));
        }
        for (name, pairs) in long_pairs() {
            let samples = pairs[pairs.len() - 1] - FIRST_SAMPLE;
            sets.push((name.into(), Self::new(samples, pairs, Fill::Random, &mut random)));
        }
        sets
    }

    fn convert(&self, mut outputs: Vec<Output>) -> Vec<Output> {
        let factor = joined(&mut outputs[0], self.params.stride as usize);
        outputs.push(Output::float("s_factor", factor));
        outputs
    }

    fn exact_at(&self, output: &str, index: usize) -> Option<Rounded> {
        let TransmittanceInputsParams { stride, samples, gaussians, .. } = self.params;
        let [row, column] = [index / stride as usize, index % stride as usize];
        if column >= samples as usize {
            return None;
        }
        let pair = owner(&self.first_sample, column);
        if output == "input" {
            let gaussian = (self.pair[pair] % gaussians) as usize;
            let at = row.checked_sub(1).filter(|&at| at < 2)?;
            return Some(self.extra[2 * gaussian + at].into());
        }
        let factor = self.segment[4 * pair].w;
        let sample = FIRST_SAMPLE as usize + column;
        let is_listed = self.params.side != 0;
        let k = if is_listed {
            self.step[sample] as u32
        } else {
            sample as u32 - self.first_sample[pair]
        };
        let place = self.rays.midpoint(pair, k);
        // a place on the ray and a point in two parts: roundings, and a division of 3 ulp, of the second, below 1/1024
        let error = if self.params.contracted == 0 { 1e-9 } else { 1e-6 };
        if output == "s_factor" {
            if !is_listed {
                return Some(factor.into());
            }
            let full = self.grid().occupied(&self.occupancy, place);
            // the weights of a cell's corners, as one f32 knows them, and the steepest slope of the grid
            let error = 2e-6 + 3.0 * f64::from(self.params.side) * error;
            let full = Rounded::within(full.max(self.params.faint.into()), error);
            return Some(Rounded::from(factor) * full);
        }
        Some(Rounded::within(place[row], error + f64::from(TINY)))
    }
}

/// Points `[7, stride]`. The heads read only the factors.
pub(super) fn points(layer: &Dense, fill: Fill, random: &mut Random) -> Vec<f32> {
    let stride = layer.params.stride as usize;
    let factors = fill.values(random, stride, [0.0, 1.0], 1.0);
    let mut points = vec![f32::NAN; POINT_ROWS as usize * stride];
    points.extend(factors.into_iter().map(f32::abs));
    points
}

/// A sample's factor in [`points`].
pub(super) fn factor(layer: &Dense, point: &[f32], sample: u32) -> Rounded {
    layer.at(point, POINT_ROWS, sample)
}

// the last layer has one column
case!(pub TransmittanceHead(TransmittanceHeadInputs) { layer: Dense });

impl Parity for TransmittanceHead {
    fn sets() -> Vec<(String, Self)> {
        head_sets(|layer, fill, random| {
            let inputs = TransmittanceHeadInputs {
                params: layer.head_params(FIRST_SAMPLE),
                parameters: layer.parameters.clone(),
                point: points(&layer, fill, random),
                input: layer.input.clone(),
                log_rho: unwritten((FIRST_SAMPLE + layer.params.samples) as usize),
            };
            Self { inputs, layer }
        })
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<Rounded> {
        let sample = index.checked_sub(FIRST_SAMPLE as usize)? as u32;
        Some(log_rho(self.layer.sum(sample, 0), factor(&self.layer, &self.point, sample)))
    }
}

case!(pub SegmentProduct(SegmentProductInputs));

impl Parity for SegmentProduct {
    fn sets() -> Vec<(String, Self)> {
        let set = |power, first_sample: Vec<u32>, log_rho| {
            let pairs = first_sample.len() as u32 - 1;
            Self(SegmentProductInputs {
                params: SegmentProductParams { pairs, power, onto: 0 },
                first_sample,
                log_rho,
                transmittance: unwritten(pairs as usize),
            })
        };
        let mut sets = inputs::sets(|pairs, fill, random| {
            let first_sample = prefix((0..pairs).map(|_| random.below(9).saturating_sub(2)));
            let samples = first_sample[pairs as usize] as usize;
            let log_rho = fill.values(random, samples, [0.0, 3.0], 1e30);
            let log_rho = log_rho.into_iter().map(|x| -x.abs()).collect();
            set(1.0, first_sample, log_rho)
        });
        for (name, size) in [("a long segment", 1e-3), ("a long segment down to zero", 0.1)] {
            let log_rho = Random::new(8).values(16_384, -size, 0.0);
            sets.push((name.into(), set(1.0, vec![0, 0, 16_384, 16_384], log_rho)));
        }
        let log_rho = Random::new(9).values(900, -0.1, 0.0);
        let first_sample = (0..=100).map(|pair| 9 * pair).collect();
        let mut onto = set(4.0, first_sample, log_rho);
        sets.push(("steps four times as long".into(), Self(onto.0.clone())));
        onto.0.params.onto = 1;
        onto.0.transmittance = Random::new(10).values(100, 0.0, 1.0);
        sets.push(("T of another scene".into(), onto));
        sets
    }

    fn exact_at(&self, _: &str, pair: usize) -> Option<Rounded> {
        let samples = self.first_sample[pair] as usize..self.first_sample[pair + 1] as usize;
        let sum = Rounded::sum(self.log_rho[samples].iter().copied().map(Rounded::from));
        let product = transmittance(Rounded::from(self.params.power) * sum);
        match self.params.onto {
            0 => Some(product),
            _ => Some(Rounded::from(self.transmittance[pair]) * product),
        }
    }
}
