//! Cases of `transmittance_inputs`, `transmittance_head` and `segment_product`.

use glam::{DVec3, Vec4};
use muslin_check::prelude::*;
use organza_shaders::hash_grid::POINT_ROWS;
use organza_shaders::segment::SEGMENT_VECTORS;
use organza_shaders::transmittance::{
    SegmentProductInputs, SegmentProductParams, TransmittanceHeadInputs, TransmittanceInputsInputs,
    TransmittanceInputsParams,
};
use organza_shaders::unit_cube::Split;

use super::color::joined;
use super::dense::{Dense, head_sets};
use super::exact::occupancy::OccupancyGrid;
use super::exact::segment::{ContractedRay, contracted_ray};
use super::exact::transmittance::{log_rho, midpoint, transmittance};
use super::scan::prefix;

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

case!(pub TransmittanceInputs(TransmittanceInputsInputs));

impl TransmittanceInputs {
    /// Samples of a chunk; three others lie before them.
    fn new(samples: u32, first_sample: Vec<u32>, fill: Fill, random: &mut Random) -> Self {
        let gaussians = 29;
        let pairs = first_sample.len() - 1;
        // within the cube: no sample lies outside
        let start = fill.values(random, 4 * pairs, [0.0, 1.0], 1.0);
        let w = fill.values(random, 3 * pairs, [-1.0, 1.0], 1.0);
        let vectors = (0..pairs).flat_map(|pair| {
            let start = Vec4::from_slice(&start[4 * pair..]).abs();
            let [mut coarse, mut fine] = [[start, Vec4::ZERO], [Vec4::ZERO; 2]];
            for axis in 0..3 {
                let inside = (start[axis] + w[3 * pair + axis]).clamp(0.0, 1.0) - start[axis];
                // more digits than an f32 has
                for (vector, x) in [start[axis], inside].into_iter().enumerate() {
                    let x = Split::new(x, x * random.between(-6e-8, 0.0));
                    coarse[vector][axis] = x.coarse;
                    fine[vector][axis] = x.fine;
                }
            }
            coarse.into_iter().chain(fine)
        });
        let segment = vectors.collect();
        let stride = samples + 5;
        Self(TransmittanceInputsInputs {
            params: TransmittanceInputsParams {
                samples,
                first_sample: FIRST_SAMPLE,
                stride,
                pairs: pairs as u32,
                gaussians,
                extra: 2,
                extra_row: 1,
                contracted: 0,
                occupancy: 0,
            },
            pair: (0..pairs).map(|_| random.below(3 * gaussians)).collect(),
            first_sample,
            segment,
            extra: fill.values(random, 2 * gaussians as usize, [-1.0, 1.0], 3e38),
            occupancy: vec![0.0],
            point: unwritten(((POINT_ROWS + 1) * stride) as usize),
            input: unwritten(4 * stride as usize),
        })
    }

    /// The same samples, with full and empty cells.
    fn occupied(mut self, random: &mut Random) -> Self {
        self.params.occupancy = 7;
        let mut value = |_| (random.between(-0.5, 1.5)).clamp(0.0, 1.0);
        self.occupancy = (0..self.grid().entries().pow(3)).map(&mut value).collect();
        self
    }

    /// Its occupancy grid.
    fn grid(&self) -> OccupancyGrid {
        let side = self.params.occupancy;
        OccupancyGrid { side, aabb: [[0.0; 3], [1.0; 3]], is_contracted: false }
    }

    /// The same samples on contracted rays, with ends up to 300 cubes away.
    fn contracted(mut self, random: &mut Random) -> Self {
        self.params.contracted = 1;
        for (pair, vectors) in self.segment.chunks_mut(SEGMENT_VECTORS as usize).enumerate() {
            let far = [1.0, 1.0, 3.0, 300.0][pair % 4];
            let mut end = |far: f32| [0; 3].map(|_| f64::from(random.between(-far, far)));
            let ray = contracted_ray(end(far), end(1.0), 0.01);
            let [foot, direction] = [ray.foot, ray.direction].map(|x| DVec3::from(x).as_vec3());
            let [begin, end] = ray.ends.map(|r| r as f32);
            vectors.copy_from_slice(&[
                foot.extend(vectors[0].w),
                direction.extend(ray.radius as f32),
                Vec4::new(begin, end - begin, 0.0, 0.0),
                Vec4::ZERO,
            ]);
        }
        self
    }

    /// The midpoint of a pair's step.
    fn midpoint(&self, pair: usize, k: u32, count: u32) -> [f64; 3] {
        let vector = |part: usize| self.segment[4 * pair + part].as_dvec4();
        if self.params.contracted == 0 {
            let s = vector(0) + vector(2);
            let w = vector(1) + vector(3);
            return midpoint(s.truncate().to_array(), w.truncate().to_array(), k, count);
        }
        let [foot, direction, ends] = [0, 1, 2].map(vector);
        let ray = ContractedRay {
            foot: foot.truncate().to_array(),
            direction: direction.truncate().to_array(),
            radius: direction.w,
            ends: [ends.x, ends.x + ends.y],
            count: f64::from(count),
            factor: 0.0,
        };
        ray.midpoint(k, count)
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
            sets.push((format!("{samples} samples, occupied"), set.clone().occupied(&mut random)));
            sets.push((format!("{samples} samples, contracted"), set.contracted(&mut random)));
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
        if output == "s_factor" && self.params.occupancy == 0 {
            return Some(factor.into());
        }
        let k = FIRST_SAMPLE + column as u32 - self.first_sample[pair];
        let point = self.midpoint(pair, k, self.first_sample[pair + 1] - self.first_sample[pair]);
        let (value, error) = match output {
            // a place on the ray and a point in two parts: roundings, and a division of 3 ulp, of the second, below 1/1024
            "point" if self.params.contracted == 0 => (point[row], 1e-9),
            "point" => (point[row], 1e-6),
            // the weights of a cell's corners, as one f32 knows them
            _ => (f64::from(factor) * self.grid().occupied(&self.occupancy, point), 1e-6),
        };
        Some(Rounded::within(value, error + f64::from(TINY)))
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
