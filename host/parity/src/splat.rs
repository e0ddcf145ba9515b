//! The cases of `splat` and `splat_backward`.

use std::collections::BTreeMap;

use glam::{Vec3, Vec4};
use muslin_check::prelude::*;
use organza_shaders::splat::{
    SplatBackwardInputs, SplatBackwardParams, SplatInputs, SplatParams, VECTORS,
};

use super::exact::bits;
use super::exact::composite::{compensation, flatness, weight};
use super::pair::scanned;

case!(pub Splat(SplatInputs));

impl Splat {
    fn new(pairs: u32, fill: Fill, random: &mut Random) -> Self {
        let gaussians = 37;
        let slots = 2 * gaussians;
        let shapes = [0.0, -3e38, 3e38, -90.0, 90.0].into_iter();
        let others = Random::new(8).values(gaussians as usize, -9.0, 9.0);
        Self(SplatInputs {
            params: SplatParams { pairs, gaussians, compensated_blur: 0.0, shaped: 0 },
            pair: (0..pairs)
                .map(|i| if i % 5 == 4 { slots - 1 } else { random.below(slots) })
                .collect(),
            projection: fill.vectors(random, 2 * slots as usize, [-100.0, 100.0], 3e38),
            opacity: fill.values(random, gaussians as usize, [-12.0, 12.0], 3e38),
            transmittance: random.values(pairs as usize, 0.0, 1.0),
            color: random.values(3 * pairs as usize, 0.0, 1.0),
            shape: shapes.chain(others).take(gaussians as usize).collect(),
            splat: unwritten((VECTORS * pairs) as usize),
        })
    }

    /// Splats from thin to large, with weights that compensate for the blur.
    fn compensated() -> Self {
        let mut set = Self::new(inputs::ITEMS, Fill::Random, &mut Random::new(6));
        set.params.compensated_blur = 0.3;
        let mut random = Random::new(7);
        for conic in set.projection.iter_mut().skip(1).step_by(2) {
            *conic = blurred_conic(&mut random, -4.0).extend(conic.w);
        }
        set
    }
}

/// The conic of a covariance with a blur of 0.3, turned by any angle. Its variances are powers of 10, from `min` on up to 2.
pub(super) fn blurred_conic(random: &mut Random, min: f32) -> Vec3 {
    let axes = [0, 1].map(|_| 1.0 / (10f32.powf(random.between(min, 2.0)) + 0.3));
    let (sin, cos) = random.between(0.0, 3.2).sin_cos();
    let [a, b] = axes;
    Vec3::new(a * cos * cos + b * sin * sin, (a - b) * sin * cos, a * sin * sin + b * cos * cos)
}

impl Parity for Splat {
    fn sets() -> Vec<(String, Self)> {
        let mut sets = inputs::sets(Self::new);
        for size in [40.0, 80.0, 100.0] {
            let mut set = Self::new(inputs::ITEMS, Fill::Random, &mut Random::new(3));
            set.opacity.iter_mut().for_each(|opacity| *opacity *= size / 12.0);
            sets.push((format!("opacities of {size}"), set));
        }
        for edge in [0.0, 1.0] {
            let mut set = Self::new(inputs::ITEMS, Fill::Random, &mut Random::new(4));
            set.transmittance.fill(edge);
            sets.push((format!("transmittance {edge}"), set));
        }
        sets.push(("compensated".into(), Self::compensated()));
        let mut shaped = Self::new(inputs::ITEMS, Fill::Random, &mut Random::new(9));
        shaped.params.shaped = 1;
        sets.push(("shaped".into(), shaped));
        sets
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<Rounded>> {
        let of = |(pair, &slot): (usize, &u32)| {
            let gaussian = (slot % self.params.gaussians) as usize;
            let logit = Rounded::from(self.opacity[gaussian]);
            let [[x, y, _, width], conic] = [0, 1]
                .map(|at| self.projection[2 * slot as usize + at].to_array().map(Rounded::from));
            let weight = weight(logit, self.transmittance[pair].into());
            let weight = match self.params.compensated_blur {
                0.0 => weight,
                blur => weight * compensation([conic[0], conic[1], conic[2]], blur.into()),
            };
            let [r, g, b] = [0, 1, 2].map(|channel| self.color[3 * pair + channel].into());
            let k = match self.params.shaped {
                0 => Rounded::exact(0.0),
                _ => flatness(self.shape[gaussian].into()),
            };
            [[x, y, weight, width], conic, [r, g, b, k]].concat()
        };
        listed(self.pair.iter().enumerate().flat_map(of))
    }
}

/// The first tile of each of three cameras. The third has no tiles.
const FIRST_TILE: [u32; 4] = [0, 3, 5, 5];

case!(pub SplatBackward(SplatBackwardInputs));

impl SplatBackward {
    pub(super) fn new(gaussians: u32, fill: Fill, random: &mut Random) -> Self {
        let words = gaussians.div_ceil(32);
        let tiles = FIRST_TILE[3];
        let mut tile_mask: Vec<_> = (0..tiles * words)
            .map(|index| match (index / words, index % words) {
                (1, 0) => u32::MAX,
                (2, 0) => 0,
                _ => random.bits() & random.bits(),
            })
            .collect();
        // no bits behind the last Gaussian
        for row in tile_mask.chunks_exact_mut(words.max(1) as usize) {
            row[words as usize - 1] &= u32::MAX >> (32 * words - gaussians);
        }
        let mut first_intersection = scanned(&tile_mask);
        let intersections = first_intersection.pop().unwrap_or_default();
        let mut set = Self(SplatBackwardInputs {
            params: SplatBackwardParams { pairs: 0, gaussians, words },
            pair: Vec::new(),
            first_tile: FIRST_TILE.to_vec(),
            tile_mask,
            first_intersection,
            opacity: fill.values(random, gaussians as usize, [-12.0, 12.0], 3e38),
            transmittance: Vec::new(),
            intersection_gradient: Vec::new(),
            pair_gradient: Vec::new(),
        });
        set.intersection_gradient = vec![Vec4::ZERO; 3 * intersections as usize];
        set.pair = set.sums::<12>(&set.intersection_gradient).into_keys().collect();
        set.params.pairs = set.pair.len() as u32;
        set.pair_gradient = unwritten(VECTORS as usize * set.pair.len());
        set.transmittance = random.values(set.pair.len(), 0.0, 1.0);
        set.transmittance.iter_mut().step_by(7).for_each(|value| *value = 0.0);
        set.intersection_gradient =
            fill.vectors(random, 3 * intersections as usize, [-1.0, 1.0], 1e37);
        set
    }

    /// The sum over every pair's intersections of their N values, which are in the order of the masks' bits.
    pub(super) fn sums<const N: usize>(&self, values: &[Vec4]) -> BTreeMap<u32, [Rounded; N]> {
        let row = 32 * self.params.gaussians.div_ceil(32) as usize;
        let mut sums = BTreeMap::new();
        for (vectors, at) in values.chunks(N / 4).zip(bits(&self.tile_mask)) {
            let camera = FIRST_TILE.iter().rposition(|&first| first as usize <= at / row);
            let camera = camera.expect("the first is 0") as u32;
            let slot = camera * self.params.gaussians + (at % row) as u32;
            let sum = sums.entry(slot).or_insert([Rounded::exact(0.0); N]);
            let values = vectors.iter().flat_map(Vec4::to_array);
            sum.iter_mut().zip(values).for_each(|(sum, x)| *sum = *sum + x.into());
        }
        sums
    }
}

impl Parity for SplatBackward {
    fn sets() -> Vec<(String, Self)> {
        let mut sets = inputs::sets(Self::new);
        for size in [40.0, 80.0, 100.0] {
            let mut set = Self::new(inputs::ITEMS, Fill::Random, &mut Random::new(5));
            set.opacity.iter_mut().for_each(|opacity| *opacity *= size / 12.0);
            sets.push((format!("opacities of {size}"), set));
        }
        sets
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<Rounded>> {
        let sums = self.sums::<12>(&self.intersection_gradient);
        let of = |(pair, slot): (usize, &u32)| {
            let mut exact = sums[slot];
            let by_weight = Dual::constant(exact[2]);
            let logit = self.opacity[(slot % self.params.gaussians) as usize];
            let [x, t] = [logit, self.transmittance[pair]].map(Rounded::from);
            [exact[2], exact[3]] = gradient([x, t], |[x, t]| by_weight * weight(x, t));
            exact
        };
        listed(self.pair.iter().enumerate().flat_map(of))
    }
}
