//! The cases of `splat` and `splat_backward`.

use std::collections::BTreeMap;

use glam::{Vec3, Vec4};
use muslin_check::prelude::*;
use organza_shaders::splat::{
    SplatBackwardInputs, SplatBackwardParams, SplatInputs, SplatParams, VECTORS,
};

use super::exact::bits;
use super::exact::composite::{compensation, weight};
use super::exact::numeric::{Dual, gradient};
use super::pair::scanned;

case!(pub Splat(SplatInputs));

impl Splat {
    fn new(pairs: u32, fill: Fill, random: &mut Random) -> Self {
        let gaussians = 37;
        let slots = 2 * gaussians;
        let numbers = fill.values(random, 8 * slots as usize, [-100.0, 100.0], 3e38);
        Self(SplatInputs {
            params: SplatParams { pairs, gaussians, compensated_blur: 0.0 },
            pair: (0..pairs)
                .map(|i| if i % 5 == 4 { slots - 1 } else { random.below(slots) })
                .collect(),
            projection: numbers.chunks(4).map(Vec4::from_slice).collect(),
            opacity: fill.values(random, gaussians as usize, [-12.0, 12.0], 3e38),
            transmittance: random.values(pairs as usize, 0.0, 1.0),
            color: random.values(3 * pairs as usize, 0.0, 1.0),
            splat: unwritten((VECTORS * pairs) as usize),
        })
    }

    /// Of covariances from thin to large, whose weights make up for the blur.
    fn compensated() -> Self {
        let mut set = Self::new(inputs::ITEMS, Fill::Random, &mut Random::new(6));
        set.params.compensated_blur = 0.3;
        let mut random = Random::new(7);
        for conic in set.projection.iter_mut().skip(1).step_by(2) {
            *conic = blurred_conic(&mut random, -4.0).extend(conic.w);
        }
        set
    }

    /// What a slot's weight is multiplied with.
    fn factor(&self, slot: usize) -> f64 {
        let conic = self.projection[2 * slot + 1].as_dvec4();
        match self.params.compensated_blur {
            0.0 => 1.0,
            blur => compensation([conic.x, conic.y, conic.z], f64::from(blur)),
        }
    }
}

/// The conic of a covariance with a blur of 0.3, turned by any angle. Its variances are powers of 10, from `least` on up to 2.
pub(super) fn blurred_conic(random: &mut Random, least: f32) -> Vec3 {
    let axes = [0, 1].map(|_| 1.0 / (10f32.powf(random.between(least, 2.0)) + 0.3));
    let (sin, cos) = random.between(0.0, 3.2).sin_cos();
    let [a, b] = axes;
    Vec3::new(a * cos * cos + b * sin * sin, (a - b) * sin * cos, a * sin * sin + b * cos * cos)
}

impl Parity for Splat {
    const KERNEL: &'static str = "splat";
    const TOLERANCE: f64 = 4e-7;
    const WHY: &'static str =
        "a sigmoid: exp's 3 + 2 abs(x) ulp and a division; all else is copied";

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
        sets
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        runner.run(&self.kernel(), self.params.pairs, 1)
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<f64>> {
        let of = |(pair, &slot): (usize, &u32)| {
            let slot = slot as usize;
            let logit = f64::from(self.opacity[slot % self.params.gaussians as usize]);
            let [placed, conic] = [0, 1].map(|at| self.projection[2 * slot + at].as_dvec4());
            let weight = weight(logit, f64::from(self.transmittance[pair])) * self.factor(slot);
            let [r, g, b] = [0, 1, 2].map(|channel| f64::from(self.color[3 * pair + channel]));
            let geometry = [placed.x, placed.y, weight, placed.w];
            [geometry, conic.to_array(), [r, g, b, 0.0]].concat()
        };
        self.pair.iter().enumerate().flat_map(of).map(Some).collect()
    }

    fn bound(&self, cpu: &Output, index: usize, _: Rounding) -> Bound {
        let vectors = (4 * VECTORS) as usize;
        if index % vectors != 2 {
            return Bound::relative_to(0.0);
        }
        let gaussian = self.pair[index / vectors] % self.params.gaussians;
        let size = f64::from(self.opacity[gaussian as usize].abs());
        // the root of a difference from 1
        let factor = self.factor(self.pair[index / vectors] as usize);
        let rounded = if self.params.compensated_blur > 0.0 { factor.powi(-2) } else { 0.0 };
        Bound::relative_to(cpu.floats()[index].abs() * (1.0 + size + rounded))
    }
}

/// Where the tiles of two cameras begin, and those of a third, which has none.
const FIRST_TILE: [u32; 4] = [0, 3, 5, 5];

case!(pub SplatBackward(SplatBackwardInputs));

impl SplatBackward {
    fn new(gaussians: u32, fill: Fill, random: &mut Random) -> Self {
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
        let mut first_member = scanned(&tile_mask);
        let members = first_member.pop().unwrap_or_default();
        let mut set = Self(SplatBackwardInputs {
            params: SplatBackwardParams { pairs: 0, gaussians, words },
            pair: Vec::new(),
            first_tile: FIRST_TILE.to_vec(),
            tile_mask,
            first_member,
            opacity: fill.values(random, gaussians as usize, [-12.0, 12.0], 3e38),
            transmittance: Vec::new(),
            member_gradient: Vec::new(),
            pair_gradient: Vec::new(),
        });
        let needed = |slot: &u32| !set.members(*slot).is_empty();
        set.pair = (0..2 * gaussians).filter(needed).collect();
        set.params.pairs = set.pair.len() as u32;
        set.pair_gradient = unwritten(VECTORS as usize * set.pair.len());
        set.transmittance = random.values(set.pair.len(), 0.0, 1.0);
        set.transmittance.iter_mut().step_by(7).for_each(|value| *value = 0.0);
        let numbers = fill.values(random, 12 * members as usize, [-1.0, 1.0], 1e37);
        set.member_gradient = numbers.chunks(4).map(Vec4::from_slice).collect();
        set
    }

    /// The sums of every pair's members: those lie in the order of the masks' bits.
    fn sums(&self) -> BTreeMap<u32, [f64; 12]> {
        let row = 32 * self.params.gaussians.div_ceil(32) as usize;
        let mut sums = BTreeMap::new();
        for (vectors, at) in self.member_gradient.chunks(3).zip(bits(&self.tile_mask)) {
            let tile = at / row;
            let gaussian = at % row;
            let camera = FIRST_TILE.iter().rposition(|&first| first as usize <= tile);
            let slot =
                camera.expect("the first is 0") as u32 * self.params.gaussians + gaussian as u32;
            let sum = sums.entry(slot).or_insert([0.0; 12]);
            let values = vectors.iter().flat_map(Vec4::to_array);
            sum.iter_mut().zip(values).for_each(|(sum, x)| *sum += f64::from(x));
        }
        sums
    }

    /// Members that a pair is.
    pub(super) fn members(&self, slot: u32) -> Vec<usize> {
        let words = self.params.gaussians.div_ceil(32);
        let camera = (slot / self.params.gaussians) as usize;
        let gaussian = slot % self.params.gaussians;
        let of = |tile: u32| {
            let word = (tile * words + gaussian / 32) as usize;
            let bits = self.tile_mask[word];
            let bit = gaussian % 32;
            let below = (bits & ((1 << bit) - 1)).count_ones();
            (bits >> bit & 1 == 1).then_some((self.first_member[word] + below) as usize)
        };
        (FIRST_TILE[camera]..FIRST_TILE[camera + 1]).filter_map(of).collect()
    }
}

impl Parity for SplatBackward {
    const KERNEL: &'static str = "splat_backward";
    const TOLERANCE: f64 = 8e-7;
    const WHY: &'static str = "a rounding for each tile, of the terms' sizes, and two sigmoids: exp's 3 + 2 abs(x) ulp and a division";

    fn sets() -> Vec<(String, Self)> {
        let mut sets = inputs::sets(Self::new);
        for size in [40.0, 80.0, 100.0] {
            let mut set = Self::new(inputs::ITEMS, Fill::Random, &mut Random::new(5));
            set.opacity.iter_mut().for_each(|opacity| *opacity *= size / 12.0);
            sets.push((format!("opacities of {size}"), set));
        }
        sets
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        runner.run(&self.kernel(), self.params.pairs, 1)
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<f64>> {
        let sums = self.sums();
        let of = |(pair, slot): (usize, &u32)| {
            let mut exact = sums[slot];
            let by_weight = Dual::from(exact[2]);
            let logit = f64::from(self.opacity[(slot % self.params.gaussians) as usize]);
            let transmittance = f64::from(self.transmittance[pair]);
            [exact[2], exact[3]] =
                gradient([logit, transmittance], |[x, t]| by_weight * weight(x, t));
            exact
        };
        self.pair.iter().enumerate().flat_map(of).map(Some).collect()
    }

    fn bound(&self, _: &Output, index: usize, _: Rounding) -> Bound {
        let pair = index / 12;
        let part = index % 12;
        let slot = self.pair[pair];
        let sum = |part: usize| -> f64 {
            let terms = self.members(slot).into_iter();
            let term = |member: usize| self.member_gradient[3 * member + part / 4][part % 4];
            terms.map(|member| f64::from(term(member).abs())).sum()
        };
        let opacity = f64::from(self.opacity[(slot % self.params.gaussians) as usize]);
        let [s, rest] = [-opacity, opacity].map(|x| 1.0 / (1.0 + x.exp()));
        let size = 1.0 + opacity.abs().min(100.0);
        // what may be flushed: each term, and a sigmoid
        let floor = f64::from(TINY) * (self.members(slot).len() as f64 + sum(2));
        let scale = match part {
            2 => sum(2) * f64::from(self.transmittance[pair]) * s * rest * 2.0 * size,
            3 => sum(2) * s * size,
            _ => sum(part),
        };
        Bound { scale, floor }
    }
}
