//! The case of `splat`.

use glam::Vec4;
use organza_kernels::splat::{SplatKernel, SplatParams, VECTORS};

use super::bench::Bench;
use super::case::{Parity, Rounding};
use super::inputs::{self, Fill, Random};
use super::measure::{Bound, Output};
use crate::error::Result;

/// Inputs of `splat`.
#[derive(Clone, Debug)]
pub struct Splat {
    /// Gaussians of the scene.
    pub gaussians: u32,
    /// `camera * gaussians + gaussian`
    pub pair: Vec<u32>,
    /// `[2 cameras, gaussians, 2]`
    pub projection: Vec<Vec4>,
    /// `[gaussians]`
    pub opacity: Vec<f32>,
    /// `[pairs]`
    pub transmittance: Vec<f32>,
    /// `[pairs, 3]`
    pub color: Vec<f32>,
}

impl Splat {
    fn new(pairs: u32, fill: Fill, random: &mut Random) -> Self {
        let gaussians = 37;
        let slots = 2 * gaussians;
        let numbers = fill.values(random, 8 * slots as usize, [-100.0, 100.0], 3e38);
        Self {
            gaussians,
            pair: (0..pairs)
                .map(|i| if i % 5 == 4 { slots - 1 } else { random.below(slots) })
                .collect(),
            projection: numbers.as_chunks::<4>().0.iter().copied().map(Vec4::from_array).collect(),
            opacity: fill.values(random, gaussians as usize, [-12.0, 12.0], 3e38),
            transmittance: random.values(pairs as usize, 0.0, 1.0),
            color: random.values(3 * pairs as usize, 0.0, 1.0),
        }
    }
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
        sets
    }

    fn run(&self, bench: &Bench<'_>) -> Result<Vec<Output>> {
        let pairs = self.pair.len() as u32;
        let splat = bench.output::<Vec4>((VECTORS * pairs) as usize)?;
        let kernel = SplatKernel {
            params: SplatParams { pairs, gaussians: self.gaussians },
            pair: &bench.upload(&self.pair)?,
            projection: &bench.upload(&self.projection)?,
            opacity: &bench.upload(&self.opacity)?,
            transmittance: &bench.upload(&self.transmittance)?,
            color: &bench.upload(&self.color)?,
            splat: &splat,
        };
        bench.items(&kernel, pairs, 1)?;
        let splat = bench.read(&splat)?;
        Ok(vec![Output::float("splat", splat.iter().flat_map(|v| v.to_array()))])
    }

    fn bound(&self, cpu: &Output, index: usize, _: Rounding) -> Bound {
        let vectors = (4 * VECTORS) as usize;
        let is_weight = index % vectors == 2 && index / vectors < self.pair.len();
        if !is_weight {
            return Bound::of(0.0);
        }
        let gaussian = self.pair[index / vectors] % self.gaussians;
        let size = f64::from(self.opacity[gaussian as usize].abs());
        Bound::of(cpu.floats()[index].abs() * (1.0 + size))
    }
}
