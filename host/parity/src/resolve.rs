//! Cases of `resolve` and `resolve_backward`.

use glam::Vec4;
use muslin_check::prelude::*;
use organza_shaders::resolve::{DIVIDE_ABOVE, ResolveBackwardInputs, ResolveInputs, ResolveParams};

use super::composite::{SIDES, pixel, pixels, planes, sets, tiles};
use super::exact::numeric::{Dual, gradient};
use super::exact::resolve;
use super::tile::pack;

case!(pub Resolve(ResolveInputs));

impl Resolve {
    fn new(side: u32, fill: Fill, weights: [f32; 2]) -> Self {
        let mut random = Random::new(u64::from(side));
        let tiles = tiles();
        let area = (side * side) as usize;
        let pixels = tiles.len() * area;
        let color = fill.values(&mut random, 3 * pixels, [0.0, 2.0], 1e30);
        let weight = fill.values(&mut random, pixels, weights, 1e30);
        let sum = (0..pixels).map(|i| {
            let [r, g, b] = [0, 1, 2].map(|channel| color[3 * i + channel].abs());
            Vec4::new(r, g, b, weight[i].abs())
        });
        Self(ResolveInputs {
            params: ResolveParams {
                side,
                background_r: 0.2,
                background_g: 1.0,
                background_b: 0.0,
                divide_above: DIVIDE_ABOVE,
            },
            tile: pack(&tiles),
            sum: planes(&sum.collect::<Vec<_>>(), area),
            image: unwritten(3 * pixels),
        })
    }
}

impl Resolve {
    /// C, S and the background of a value of Y `[K, 3, S, S]`, in which each tile has its own place.
    fn at(&self, index: usize) -> Option<[f64; 3]> {
        let area = area(&self.params);
        let channel = index / area % 3;
        let tile = tiles().iter().position(|tile| tile.output as usize == index / (3 * area))?;
        let sum = pixel(&self.sum, area, tile * area + index % area);
        Some([sum[channel], sum.w, background(&self.params)[channel]])
    }
}

/// Pixels of a tile.
fn area(params: &ResolveParams) -> usize {
    (params.side * params.side) as usize
}

/// The background's color.
fn background(params: &ResolveParams) -> [f64; 3] {
    [params.background_r, params.background_g, params.background_b].map(f64::from)
}

impl Parity for Resolve {
    const KERNEL: &'static str = "resolve";
    const TOLERANCE: f64 = 5e-7;
    const WHY: &'static str =
        "a division of 3 ulp and three roundings; the branches agree at S = 1";

    fn sets() -> Vec<(String, Self)> {
        let mut sets = sets(SIDES, 9, |side, fill| Self::new(side, fill, [0.0, 3.0]));
        let edge = [1.0 - 3.0 * f32::EPSILON, 1.0 + 3.0 * f32::EPSILON];
        sets.push(("weights about 1".into(), Self::new(17, Fill::Random, edge)));
        sets
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        runner.run_over(&self.kernel(), [self.params.side, self.params.side, tiles().len() as u32])
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<f64> {
        let [color, weight, background] = self.at(index)?;
        Some(resolve::pixel(color, weight, background))
    }

    fn bound(&self, _: &Output, index: usize, _: Rounding) -> Bound {
        let Some([color, weight, background]) = self.at(index) else { return Bound::EXACT };
        let color = color.abs();
        Bound::relative_to(if weight > 1.0 { color / weight } else { color + background })
    }
}

case!(pub ResolveBackward(ResolveBackwardInputs));

impl ResolveBackward {
    fn new(Resolve(ResolveInputs { params, tile, sum, image }): Resolve) -> Self {
        let mut image_gradient = Random::new(7).values(image.len(), -1.0, 1.0);
        image_gradient.iter_mut().step_by(5).for_each(|value| *value = 0.0);
        let sum_gradient = unwritten(sum.len());
        Self(ResolveBackwardInputs { params, tile, sum, image_gradient, sum_gradient })
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
        let outputs = runner
            .run_over(&self.kernel(), [self.params.side, self.params.side, tiles().len() as u32])?;
        Ok(pixels(outputs, area(&self.params)))
    }

    /// Of the branch that was taken.
    fn exact(&self, _: &str, _: usize) -> Vec<Option<f64>> {
        let area = area(&self.params);
        let tiles = tiles();
        let of = |index: usize| {
            let first = 3 * tiles[index / area].output as usize * area + index % area;
            let sum = pixel(&self.sum, area, index);
            gradient(sum.to_array(), |[r, g, b, weight]| {
                let channels = [r, g, b].into_iter().enumerate();
                channels.fold(Dual::from(0.0), |loss, (channel, color)| {
                    let slope = f64::from(self.image_gradient[first + channel * area]);
                    let background = background(&self.params)[channel];
                    loss + resolve::pixel(color, weight, background) * Dual::from(slope)
                })
            })
        };
        (0..self.sum.len() / 4).flat_map(of).map(Some).collect()
    }

    fn bound(&self, _: &Output, index: usize, _: Rounding) -> Bound {
        let at = index / 4;
        let channel = index % 4;
        let area = area(&self.params);
        let sum = pixel(&self.sum, area, at);
        let output = tiles()[at / area].output as usize;
        let gradient = |channel: usize| {
            let at = (3 * output + channel) * area + at % area;
            f64::from(self.image_gradient[at].abs())
        };
        let background = |channel: usize| background(&self.params)[channel];
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
            (true, _) => Bound::relative_to(gradient(channel) / sum.w),
            (false, 3) => Bound::relative_to(by_weight(&background)),
            (false, _) => Bound::relative_to(gradient(channel)),
        }
    }
}
