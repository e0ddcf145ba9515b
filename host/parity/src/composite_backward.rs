//! The case of `composite_backward`.

use glam::{DVec4, Vec4};
use muslin_check::prelude::*;
use organza_shaders::composite_backward::{
    CompositeBackwardKernel, CompositeBackwardParams, band_rows,
};

use super::composite::{Composite, SIDES, extent};
use super::exact::composite::{Splat, compensation, falloff};
use super::exact::numeric::{Dual, gradient};
use super::splat::blurred_conic;
use super::tile::pack;

/// Inputs of `composite_backward`.
#[derive(Clone, Debug)]
pub struct CompositeBackward {
    /// Those of `composite`.
    pub forward: Composite,
    /// First row that is summed over.
    pub first_row: u32,
    /// Rows that are.
    pub rows: u32,
    /// `[tiles, 4, S, S]`
    pub sum_gradient: Vec<f32>,
    /// Whether the gradient of the colors is wanted.
    pub colors: bool,
    /// The blur that weights make up for.
    pub compensated_blur: f32,
    /// `[members, 3]`: what other bands have left.
    pub member_gradient: Vec<Vec4>,
}

impl CompositeBackward {
    fn new(mut forward: Composite) -> Self {
        // squares of distances are finite
        for [placed, ..] in &mut forward.splat {
            placed.x = placed.x.clamp(-1e15, 1e15);
            placed.y = placed.y.clamp(-1e15, 1e15);
        }
        let mut random = Random::new(8);
        let sum_gradient = random.values(4 * forward.sum.len(), -1.0, 1.0);
        let vectors = 12 * forward.member.len();
        let member_gradient = random.values(vectors, -1.0, 1.0);
        let member_gradient = member_gradient.chunks(4).map(Vec4::from_slice).collect();
        let rows = forward.side;
        Self {
            forward,
            first_row: 0,
            rows,
            colors: true,
            compensated_blur: 0.0,
            sum_gradient,
            member_gradient,
        }
    }

    /// The same with covariances that a blur has made larger, and weights that make up for it.
    fn compensated(mut self) -> Self {
        self.compensated_blur = 0.3;
        let mut random = Random::new(17);
        for [placed, conic, _] in &mut self.forward.splat {
            let shape = blurred_conic(&mut random, -2.0);
            let [width, height] = extent(shape.to_array());
            placed.w = width;
            *conic = shape.extend(height);
        }
        self
    }

    /// The factor of the weight of a conic, and the sizes of the rounding errors of its root and of its slope.
    fn compensation(&self, [xx, xy, yy]: [f64; 3]) -> [f64; 3] {
        if self.compensated_blur == 0.0 {
            return [1.0, 1.0, 0.0];
        }
        let blur = f64::from(self.compensated_blur);
        let factor = compensation([xx, xy, yy], blur);
        let quotient = factor * factor;
        // differences from 1
        [factor, factor + 1.0 / factor, blur / quotient * (1.0 + 1.0 / quotient)]
    }

    /// Tile of a member.
    fn tile(&self, index: usize) -> usize {
        let first = |tile: &usize| self.forward.tile_first[*tile] as usize <= index;
        (0..self.forward.tiles.len()).rev().find(first).unwrap_or(0)
    }

    /// The derivatives of the band's sums: center, weight, conic and color.
    fn derivatives(&self, index: usize) -> [f64; 9] {
        let set = &self.forward;
        let tile = self.tile(index);
        let area = (set.side * set.side) as usize;
        let Splat { mean: [x, y], weight, conic: [xx, xy, yy], color: [r, g, b] } =
            Splat::from_vectors(&set.splat[set.member[index] as usize]);
        let blur = f64::from(self.compensated_blur);
        let [factor, ..] = self.compensation([xx, xy, yy]);
        let bare = weight / factor;
        gradient([x, y, bare, xx, xy, yy, r, g, b], |[x, y, bare, xx, xy, yy, r, g, b]| {
            let weight = if blur > 0.0 { bare * compensation([xx, xy, yy], blur) } else { bare };
            let splat = Splat { mean: [x, y], weight, conic: [xx, xy, yy], color: [r, g, b] };
            let band = self.first_row * set.side..(self.first_row + self.rows) * set.side;
            let mut loss = Dual::from(0.0);
            for at in band.map(|at| at as usize) {
                let (_, place) = set.pixel(tile * area + at);
                for (plane, term) in splat.term(place).into_iter().enumerate() {
                    let slope = self.sum_gradient[(4 * tile + plane) * area + at];
                    loss = loss + term * Dual::from(f64::from(slope));
                }
            }
            loss
        })
    }

    /// Sizes of the terms of a member's gradient, and by how much they may differ at the cutoff.
    fn sizes(&self, index: usize) -> [[DVec4; 3]; 2] {
        let set = &self.forward;
        let tile = self.tile(index);
        let [placed, conic, color] =
            set.splat[set.member[index] as usize].map(|vector| vector.as_dvec4());
        let area = (set.side * set.side) as usize;
        let band = self.first_row * set.side..(self.first_row + self.rows) * set.side;
        let [_, root, slope] = self.compensation([conic.x, conic.y, conic.z]);
        let mut sizes = [[DVec4::ZERO; 3]; 2];
        for at in band {
            let (_, [x, y]) = set.pixel(tile * area + at as usize);
            let dx = (x - placed.x).abs();
            let dy = (y - placed.y).abs();
            let cross = 2.0 * conic.y * (x - placed.x) * (y - placed.y);
            let q = conic.x * dx * dx + cross + conic.z * dy * dy;
            let slack = 2e-6 * (conic.x * dx * dx + cross.abs() + conic.z * dy * dy);
            let plane = |plane: usize| {
                f64::from(self.sum_gradient[(4 * tile + plane) * area + at as usize].abs())
            };
            let c = DVec4::new(plane(0), plane(1), plane(2), 0.0);
            let by_alpha = c.dot(color.abs()) + plane(3);
            let weights = [falloff(q), falloff(q - slack) - falloff(q + slack)];
            for (size, f) in sizes.iter_mut().zip(weights) {
                let h = f * by_alpha;
                let along_x = conic.x * dx + conic.y.abs() * dy;
                let along_y = conic.y.abs() * dx + conic.z * dy;
                size[0] += DVec4::new(placed.z * along_x, placed.z * along_y, root, 0.0) * h;
                let by_falloff = DVec4::new(0.5 * dx * dx, dx * dy, 0.5 * dy * dy, 0.0);
                size[1] += (by_falloff + DVec4::new(slope, slope, slope, 0.0)) * placed.z * h;
                size[2] += c * placed.z * f;
            }
        }
        sizes
    }
}

impl Parity for CompositeBackward {
    const KERNEL: &'static str = "composite_backward";
    const TOLERANCE: f64 = 2e-6;
    const WHY: &'static str = "as composite's terms; a rounding of both devices for each pixel, as lanes sum in \
        another order; at the cutoff a pixel may come out on either side";

    fn sets() -> Vec<(String, Self)> {
        let mut sets: Vec<_> = SIDES
            .iter()
            .map(|&side| {
                let forward = Composite::new(side, &[40, 0, 90], Fill::Random, 11);
                (format!("random, side {side}"), Self::new(forward))
            })
            .collect();
        for fill in Fill::ADVERSARIAL {
            let forward = Composite::new(9, &[1, 60, 60], fill, 12);
            sets.push((format!("{}, side 9", fill.name()), Self::new(forward)));
        }
        let members = |count: u32| Self::new(Composite::new(8, &[count], Fill::Random, 13));
        sets.push(("no members".into(), members(0)));
        sets.push(("one member".into(), members(1)));
        // whole blocks of lanes, and those with a rest
        for side in [16, 19, 33, 64] {
            let forward = Composite::new(side, &[9, 0, 7], Fill::Random, 15);
            sets.push((format!("few, side {side}"), Self::new(forward)));
        }
        // more rows than a dispatch may sum over
        let wide = Self::new(Composite::new(260, &[5, 4], Fill::Random, 16));
        let rows = band_rows(260);
        sets.push((format!("{rows} rows of 260"), Self { rows, ..wide.clone() }));
        let rest = Self { first_row: rows, rows: 260 - rows, ..wide };
        sets.push((format!("the rest after {rows} rows"), rest));
        let band = Self::new(Composite::new(17, &[30, 33], Fill::Random, 14));
        let colors = Self { colors: false, ..band.clone() };
        sets.push(("without colors".into(), colors));
        sets.push(("compensated".into(), band.clone().compensated()));
        sets.push(("rows 3 to 9".into(), Self { first_row: 3, rows: 7, ..band }));
        sets
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let set = &self.forward;
        let members = set.member.len() as u32;
        let kernel = CompositeBackwardKernel {
            params: CompositeBackwardParams {
                members,
                tiles: set.tiles.len() as u32,
                side: set.side,
                first_row: self.first_row,
                rows: self.rows,
                colors: self.colors.into(),
                compensated_blur: self.compensated_blur,
            },
            tile: &pack(&set.tiles),
            tile_first: &set.tile_first,
            member: &set.member,
            splat: &set.splat.as_flattened().to_vec(),
            sum_gradient: &self.sum_gradient,
            member_gradient: &self.member_gradient,
        };
        runner.run(&kernel, members, 1)
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<f64>> {
        let of = |index: usize| {
            let [x, y, weight, xx, xy, yy, r, g, b] = self.derivatives(index);
            let [r, g, b] = if self.colors { [r, g, b] } else { [0.0; 3] };
            [x, y, weight, 0.0, xx, xy, yy, 0.0, r, g, b, 0.0]
        };
        let before = self.member_gradient.iter().flat_map(Vec4::to_array);
        let exact = before
            .zip((0..self.forward.member.len()).flat_map(of))
            .map(|(before, sum)| Some(f64::from(before) + sum));
        exact.collect()
    }

    fn bound(&self, _: &Output, index: usize, _: Rounding) -> Bound {
        let before = self.member_gradient[index / 4];
        let [scale, floor] = self.sizes(index / 12).map(|size| size[index / 4 % 3][index % 4]);
        let pixels = f64::from(self.rows * self.forward.side);
        let scale = f64::from(before[index % 4].abs()) + scale * (1.0 + 0.03 * pixels);
        // a conic may be flushed, and what it is multiplied with is large where it is
        let flushed = f64::from(TINY) * (1.0 + pixels * 1e15);
        Bound { scale, floor: floor + flushed }
    }
}
