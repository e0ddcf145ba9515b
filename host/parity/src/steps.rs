//! Cases of `step_count` and `step_fill`, and the rays that samples lie on.

use glam::{DVec3, Vec4};
use muslin_check::prelude::*;
use organza_shaders::segment::SEGMENT_VECTORS;
use organza_shaders::steps::{StepCountInputs, StepFillInputs, StepsParams};
use organza_shaders::unit_cube::Split;

use super::exact::occupancy::OccupancyGrid;
use super::exact::segment::{ContractedRay, contracted_ray};
use super::exact::transmittance::midpoint;
use super::scan::prefix;

/// How far from the faces between cells' centers midpoints stay, in cells.
const AWAY: f64 = 1e-5;

/// How far from a decision of the roulette a step's chance stays.
const APART: f64 = 1e-3;

/// The last step of MurmurHash3, `fmix32`.
fn mix(mut bits: u32) -> u32 {
    for (shift, factor) in [(16, 0x85eb_ca6b), (13, 0xc2b2_ae35)] {
        bits ^= bits >> shift;
        bits = bits.wrapping_mul(factor);
    }
    bits ^ bits >> 16
}

/// A hash as a number in [0, 1).
fn fraction(hash: u32) -> f64 {
    f64::from(hash >> 8) / f64::from(1 << 24)
}

/// Rays as `segment` writes them. No sample lies outside the cube.
#[derive(Clone, Debug)]
pub(super) struct Rays {
    pub vectors: Vec<Vec4>,
    is_contracted: bool,
}

impl Rays {
    /// Rays with a number of steps each.
    pub fn new(steps: &[u32], fill: Fill, random: &mut Random) -> Self {
        let start = fill.values(random, 4 * steps.len(), [0.0, 1.0], 1.0);
        let w = fill.values(random, 3 * steps.len(), [-1.0, 1.0], 1.0);
        let vectors = steps.iter().enumerate().flat_map(|(pair, &steps)| {
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
            fine[1].w = steps as f32;
            coarse.into_iter().chain(fine)
        });
        Self { vectors: vectors.collect(), is_contracted: false }
    }

    /// Contracted rays with the same steps, with ends up to 300 cubes away.
    pub fn contracted(mut self, random: &mut Random) -> Self {
        self.is_contracted = true;
        for (pair, vectors) in self.vectors.chunks_mut(SEGMENT_VECTORS as usize).enumerate() {
            let far = [1.0, 1.0, 3.0, 300.0][pair % 4];
            let mut end = |far: f32| [0; 3].map(|_| f64::from(random.between(-far, far)));
            let ray = contracted_ray(end(far), end(1.0), 0.01);
            let [foot, direction] = [ray.foot, ray.direction].map(|x| DVec3::from(x).as_vec3());
            let [begin, end] = ray.ends.map(|r| r as f32);
            vectors.copy_from_slice(&[
                foot.extend(vectors[0].w),
                direction.extend(ray.radius as f32),
                Vec4::new(begin, end - begin, 0.0, 0.0),
                Vec4::new(0.0, 0.0, 0.0, vectors[3].w),
            ]);
        }
        self
    }

    /// A hash of a ray's first two vectors.
    fn hash(&self, pair: usize) -> u32 {
        let vectors = &self.vectors[4 * pair..][..2];
        let values = vectors.iter().flat_map(|vector| vector.truncate().to_array());
        values.fold(0, |hash, value| mix(hash ^ value.to_bits()))
    }

    /// The chance of a ray's gradient.
    pub fn gradient_chance(&self, pair: usize) -> f64 {
        fraction(mix(self.hash(pair)))
    }

    /// K of a ray.
    fn steps(&self, pair: usize) -> u32 {
        self.vectors[4 * pair + 3].w as u32
    }

    /// The midpoint of a ray's step.
    pub fn midpoint(&self, pair: usize, k: u32) -> [f64; 3] {
        let count = self.steps(pair);
        let vector = |part: usize| self.vectors[4 * pair + part].as_dvec4();
        if !self.is_contracted {
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

/// Rays through a grid with few Gaussians.
#[derive(Clone, Debug)]
struct Occupied {
    rays: Rays,
    params: StepsParams,
    /// `[entries^3]`
    table: Vec<f32>,
}

impl Occupied {
    fn new(steps: &[u32], is_contracted: bool, faint: f32, random: &mut Random) -> Self {
        let side = 7;
        let contracted = u32::from(is_contracted);
        let longest = steps.iter().max().map_or(0, |&steps| steps);
        let params = StepsParams {
            pairs: steps.len() as u32,
            side,
            contracted,
            faint,
            words: longest.div_ceil(u32::BITS),
        };
        let rays = Rays { vectors: Vec::new(), is_contracted };
        let mut set = Self { rays, params, table: Vec::new() };
        let entries = set.grid().entries().pow(3);
        // three of four corners of a place are empty, and a third of all places
        set.table = (0..entries).map(|_| random.between(-6.0, 1.0).max(0.0)).collect();
        for (pair, &steps) in steps.iter().enumerate() {
            loop {
                set.rays.vectors.truncate(4 * pair);
                let mut ray = Rays::new(&[steps], Fill::Random, random);
                if is_contracted {
                    ray = ray.contracted(random);
                }
                set.rays.vectors.extend(ray.vectors);
                if (0..steps).all(|k| !set.is_undecided(pair, k)) {
                    break;
                }
            }
        }
        set
    }

    fn grid(&self) -> OccupancyGrid {
        let is_contracted = self.rays.is_contracted;
        OccupancyGrid { side: self.params.side, aabb: [[0.0; 3], [1.0; 3]], is_contracted }
    }

    /// Whether rounding decides on the cells around a midpoint.
    fn is_undecided(&self, pair: usize, k: u32) -> bool {
        let away = if self.rays.is_contracted { 10.0 * AWAY } else { AWAY };
        let place = self.rays.midpoint(pair, k).map(|x| x * f64::from(self.params.side) + 0.5);
        let [chance, full] = [self.chance(pair, k), self.full(pair, k)];
        let faint = f64::from(self.params.faint);
        let is_close = |x: f64| faint > 0.0 && x.abs() < APART;
        place.iter().any(|x| (x - x.round()).abs() < away)
            || is_close(chance - chance.round())
            || is_close(chance - full / faint)
            || is_close(full - faint)
    }

    /// The golden sequence of a ray, from its hash on.
    fn chance(&self, pair: usize, k: u32) -> f64 {
        let seed = fraction(self.rays.hash(pair));
        (seed + f64::from(k) * (5_f64.sqrt() - 1.0) / 2.0).fract()
    }

    /// How full the grid is at a step.
    fn full(&self, pair: usize, k: u32) -> f64 {
        self.grid().occupied(&self.table, self.rays.midpoint(pair, k))
    }

    /// The steps that are samples.
    fn of(&self, pair: usize) -> Vec<u32> {
        let faint = f64::from(self.params.faint);
        let is_sample = |&k: &u32| match self.full(pair, k) {
            full if full >= faint => full > 0.0,
            full => self.chance(pair, k) * faint < full,
        };
        (0..self.rays.steps(pair)).filter(is_sample).collect()
    }

    /// A word of a ray's bits: step k is bit k % 32 of word k / 32.
    fn word(&self, pair: usize, word: usize) -> u32 {
        let of_word = self.of(pair).into_iter().filter(|&k| k as usize / 32 == word);
        of_word.map(|k| 1 << (k % 32)).sum()
    }

    /// Sets by name: rays with no step, with one, and with many.
    fn sets() -> Vec<(String, Self)> {
        let mut random = Random::new(41);
        let mut sets = Vec::new();
        for (name, is_contracted) in [("", false), (", contracted", true)] {
            for pairs in [1, 65, inputs::ITEMS / 4] {
                let steps: Vec<_> =
                    (0..pairs).map(|_| random.below(40).saturating_sub(3)).collect();
                for (more, faint) in [("", 0.0), (", roulette", 0.25)] {
                    let set = Self::new(&steps, is_contracted, faint, &mut random);
                    sets.push((format!("{pairs} rays{name}{more}"), set));
                }
            }
        }
        sets.push(("no rays".into(), Self::new(&[], false, 0.0, &mut random)));
        sets.push(("a long ray".into(), Self::new(&[0, 3000, 2], false, 0.0, &mut random)));
        sets
    }
}

case!(pub StepCount(StepCountInputs) { rays: Occupied });

impl Parity for StepCount {
    fn sets() -> Vec<(String, Self)> {
        let case = |(name, rays): (String, Occupied)| {
            let inputs = StepCountInputs {
                params: rays.params,
                segment: rays.rays.vectors.clone(),
                occupancy: rays.table.clone(),
                bits: unwritten((rays.params.pairs * rays.params.words) as usize),
                count: unwritten(rays.params.pairs as usize),
            };
            (name, Self { inputs, rays })
        };
        Occupied::sets().into_iter().map(case).collect()
    }

    fn exact_at(&self, output: &str, index: usize) -> Option<Rounded> {
        if output == "count" {
            return Some(Rounded::exact(self.rays.of(index).len() as f64));
        }
        let words = self.params.words as usize;
        let pair = index / words;
        let word = index % words;
        let is_written = word < self.rays.rays.steps(pair).div_ceil(u32::BITS) as usize;
        is_written.then(|| Rounded::exact(self.rays.word(pair, word).into()))
    }
}

case!(pub StepFill(StepFillInputs) { listed: Vec<u32> });

impl Parity for StepFill {
    fn sets() -> Vec<(String, Self)> {
        let case = |(name, rays): (String, Occupied)| {
            let pairs = 0..rays.params.pairs as usize;
            let of: Vec<_> = pairs.clone().map(|pair| rays.of(pair)).collect();
            let words = 0..rays.params.words as usize;
            let word = |pair| words.clone().map(move |word| (pair, word));
            let listed = of.concat();
            let inputs = StepFillInputs {
                params: rays.params,
                bits: pairs.flat_map(word).map(|(pair, word)| rays.word(pair, word)).collect(),
                first_sample: prefix(of.iter().map(|of| of.len() as u32)),
                step: unwritten(listed.len()),
            };
            (name, Self { inputs, listed })
        };
        Occupied::sets().into_iter().map(case).collect()
    }

    fn exact_at(&self, _: &str, sample: usize) -> Option<Rounded> {
        Some(Rounded::exact(self.listed[sample].into()))
    }
}
