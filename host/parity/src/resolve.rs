//! Cases of `resolve` and `resolve_backward`.

use glam::Vec4;
use organza_check::prelude::*;
use organza_shaders::resolve::{DIVIDE_ABOVE, ResolveBackwardKernel, ResolveKernel, ResolveParams};
use organza_shaders::tile::Tile;

use super::composite::{SIDES, pixels, planes, tiles};
use super::exact::numeric::{Dual, gradient};
use super::exact::resolve::pixel;
use super::tile::pack;

/// Inputs of `resolve`.
#[derive(Clone, Debug)]
pub struct Resolve {
    /// S
    pub side: u32,
    /// The tiles.
    pub tiles: Vec<Tile>,
    /// `[tiles, S, S]`
    pub sum: Vec<Vec4>,
    /// The background.
    pub background: [f32; 3],
}

impl Resolve {
    fn new(side: u32, fill: Fill, weights: [f32; 2]) -> Self {
        let mut random = Random::new(u64::from(side));
        let tiles = tiles();
        let pixels = tiles.len() * (side * side) as usize;
        let color = fill.values(&mut random, 3 * pixels, [0.0, 2.0], 1e30);
        let weight = fill.values(&mut random, pixels, weights, 1e30);
        let sum = (0..pixels).map(|i| {
            let [r, g, b] = [0, 1, 2].map(|channel| color[3 * i + channel].abs());
            Vec4::new(r, g, b, weight[i].abs())
        });
        Self { side, tiles, sum: sum.collect(), background: [0.2, 1.0, 0.0] }
    }
}

impl Parity for Resolve {
    const KERNEL: &'static str = "resolve";
    const TOLERANCE: f64 = 5e-7;
    const WHY: &'static str =
        "a division of 3 ulp and three roundings; the branches agree at S = 1";

    fn sets() -> Vec<(String, Self)> {
        let mut sets: Vec<_> = SIDES
            .iter()
            .map(|&side| {
                (format!("random, side {side}"), Self::new(side, Fill::Random, [0.0, 3.0]))
            })
            .collect();
        for fill in Fill::ADVERSARIAL {
            sets.push((format!("{}, side 9", fill.name()), Self::new(9, fill, [0.0, 3.0])));
        }
        let edge = [1.0 - 3.0 * f32::EPSILON, 1.0 + 3.0 * f32::EPSILON];
        sets.push(("weights about 1".into(), Self::new(17, Fill::Random, edge)));
        sets
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let [background_r, background_g, background_b] = self.background;
        let side = self.side;
        let kernel = ResolveKernel {
            params: ResolveParams {
                side,
                background_r,
                background_g,
                background_b,
                divide_above: DIVIDE_ABOVE,
            },
            tile: &pack(&self.tiles),
            sum: &planes(&self.sum, (side * side) as usize),
            image: &unwritten(3 * self.sum.len()),
        };
        runner.run_over(&kernel, side, self.tiles.len() as u32)
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<f64> {
        let area = (self.side * self.side) as usize;
        // Y [K, 3, S, S], each tile at its own place of the batch
        let (place, channel, at) = (index / (3 * area), index / area % 3, index % area);
        let tile = self.tiles.iter().position(|tile| tile.output as usize == place)?;
        let sum = self.sum[tile * area + at].as_dvec4();
        Some(pixel(sum[channel], sum.w, f64::from(self.background[channel])))
    }

    fn bound(&self, _: &Output, index: usize, _: Rounding) -> Bound {
        let area = (self.side * self.side) as usize;
        let (output, channel, at) = (index / 3 / area, index / area % 3, index % area);
        let Some(tile) = self.tiles.iter().position(|tile| tile.output as usize == output) else {
            return Bound::EXACT;
        };
        let sum = self.sum[tile * area + at].as_dvec4();
        let color = sum[channel].abs();
        let background = f64::from(self.background[channel]);
        if sum.w > 1.0 { Bound::of(color / sum.w) } else { Bound::of(color + background) }
    }
}

/// Inputs of `resolve_backward`.
#[derive(Clone, Debug)]
pub struct ResolveBackward {
    /// Those of `resolve`.
    pub forward: Resolve,
    /// `[tiles, 3, S, S]`, in the batch's order.
    pub image_gradient: Vec<f32>,
}

impl ResolveBackward {
    fn new(forward: Resolve) -> Self {
        let mut image_gradient = Random::new(7).values(3 * forward.sum.len(), -1.0, 1.0);
        image_gradient.iter_mut().step_by(5).for_each(|value| *value = 0.0);
        Self { forward, image_gradient }
    }

    fn area(&self) -> usize {
        (self.forward.side * self.forward.side) as usize
    }
}

impl Parity for ResolveBackward {
    const KERNEL: &'static str = "resolve_backward";
    const TOLERANCE: f64 = 1e-6;
    const WHY: &'static str =
        "a division of 3 ulp, twice, and roundings of three products and their sum";

    fn sets() -> Vec<(String, Self)> {
        Resolve::sets().into_iter().map(|(name, set)| (name, Self::new(set))).collect()
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let set = &self.forward;
        let [background_r, background_g, background_b] = set.background;
        let side = set.side;
        let kernel = ResolveBackwardKernel {
            params: ResolveParams {
                side,
                background_r,
                background_g,
                background_b,
                divide_above: DIVIDE_ABOVE,
            },
            tile: &pack(&set.tiles),
            sum: &planes(&set.sum, self.area()),
            image_gradient: &self.image_gradient,
            sum_gradient: &unwritten(4 * set.sum.len()),
        };
        Ok(pixels(runner.run_over(&kernel, side, set.tiles.len() as u32)?, self.area()))
    }

    /// Of the branch that was taken.
    fn exact(&self, _: &str, _: usize) -> Vec<Option<f64>> {
        let (set, area) = (&self.forward, self.area());
        let of = |(index, sum): (usize, &Vec4)| {
            let first = 3 * set.tiles[index / area].output as usize * area + index % area;
            gradient(sum.as_dvec4().to_array(), |[r, g, b, weight]| {
                let channels = [r, g, b].into_iter().enumerate();
                channels.fold(Dual::from(0.0), |loss, (channel, color)| {
                    let slope = f64::from(self.image_gradient[first + channel * area]);
                    let background = f64::from(set.background[channel]);
                    loss + pixel(color, weight, background) * Dual::from(slope)
                })
            })
        };
        let exact = set.sum.iter().enumerate().flat_map(of).map(Some);
        exact.collect()
    }

    fn bound(&self, _: &Output, index: usize, _: Rounding) -> Bound {
        let (at, channel) = (index / 4, index % 4);
        let sum = self.forward.sum[at].as_dvec4();
        let area = self.area();
        let output = self.forward.tiles[at / area].output as usize;
        let gradient = |channel: usize| {
            let at = (3 * output + channel) * area + at % area;
            f64::from(self.image_gradient[at].abs())
        };
        let background = |channel: usize| f64::from(self.forward.background[channel]);
        let by_weight = |c: &dyn Fn(usize) -> f64| -> f64 {
            (0..3).map(|channel| gradient(channel) * c(channel)).sum()
        };
        let tiny = f64::from(TINY);
        match (sum.w > 1.0, channel) {
            (true, 3) => Bound {
                scale: by_weight(&|channel| sum[channel]) / (sum.w * sum.w),
                // dL/dC may be flushed
                floor: tiny * (1.0 + (sum.x + sum.y + sum.z) / sum.w),
            },
            (true, _) => Bound::of(gradient(channel) / sum.w),
            (false, 3) => Bound::of(by_weight(&background)),
            (false, _) => Bound::of(gradient(channel)),
        }
    }
}
