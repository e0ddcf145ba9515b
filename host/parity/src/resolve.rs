//! Cases of `resolve` and `resolve_backward`.

use muslin_check::prelude::*;
use organza_shaders::resolve::{DIVIDE_ABOVE, ResolveBackwardInputs, ResolveInputs, ResolveParams};

use super::composite::{SIDES, pixel, planes, tiles};
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
        let sum = color.as_chunks().0.iter().zip(weight);
        let sum = sum.map(|(&[r, g, b], weight)| [r, g, b, weight].map(f32::abs));
        Self(ResolveInputs {
            params: ResolveParams {
                side,
                background_r: 0.2,
                background_g: 1.0,
                background_b: 0.0,
                divide_above: DIVIDE_ABOVE,
            },
            tile: pack(&tiles),
            sum: planes(sum, area),
            image: unwritten(3 * pixels),
        })
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
    fn sets() -> Vec<(String, Self)> {
        let mut sets = inputs::sets_of(SIDES, 9, |side, fill, _| Self::new(side, fill, [0.0, 3.0]));
        let edge = [1.0 - 3.0 * f32::EPSILON, 1.0 + 3.0 * f32::EPSILON];
        sets.push(("weights about 1".into(), Self::new(17, Fill::Random, edge)));
        sets
    }

    /// Each tile has its own place in `[K, 3, S, S]`.
    fn exact_at(&self, _: &str, index: usize) -> Option<Rounded> {
        let area = area(&self.params);
        let channel = index / area % 3;
        let tile = tiles().iter().position(|tile| tile.output as usize == index / (3 * area))?;
        let sum = pixel(&self.sum, area, tile * area + index % area);
        Some(resolve::pixel(sum[channel], sum[3], background(&self.params)[channel]))
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
    fn sets() -> Vec<(String, Self)> {
        Resolve::sets().into_iter().map(|(name, set)| (name, Self::new(set))).collect()
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<Rounded>> {
        let area = area(&self.params);
        let tiles = tiles();
        let background = background(&self.params);
        let of = |index: usize| {
            let first = 3 * tiles[index / area].output as usize * area + index % area;
            gradient(pixel(&self.sum, area, index), |[r, g, b, weight]| {
                Number::sum([r, g, b].into_iter().enumerate().map(|(channel, color)| {
                    let slope = self.image_gradient[first + channel * area];
                    let pixel = resolve::pixel(color, weight, background[channel]);
                    pixel * Dual::constant(slope.into())
                }))
            })
        };
        listed(planes((0..self.sum.len() / 4).map(of), area))
    }
}
