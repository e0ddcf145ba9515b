//! The case of `composite_backward`.

use glam::{DVec4, Vec4};
use muslin_check::prelude::*;
use organza_shaders::composite::CompositeInputs;
use organza_shaders::composite_backward::{
    CompositeBackwardInputs, CompositeBackwardParams, band_rows,
};

use super::composite::{Composite, SIDES, extent, pixel, place, sets};
use super::exact::composite::{Splat, compensation, falloff};
use super::exact::numeric::{Dual, gradient};
use super::splat::blurred_conic;

case!(pub CompositeBackward(CompositeBackwardInputs));

impl CompositeBackward {
    fn new(Composite(forward): Composite) -> Self {
        let side = forward.params.side;
        let CompositeInputs { tile, tile_first, member, mut splat, sum, .. } = forward;
        // squares of distances are finite
        for placed in splat.iter_mut().step_by(3) {
            placed.x = placed.x.clamp(-1e15, 1e15);
            placed.y = placed.y.clamp(-1e15, 1e15);
        }
        let mut random = Random::new(8);
        let sum_gradient = random.values(sum.len(), -1.0, 1.0);
        let member_gradient = random.values(12 * member.len(), -1.0, 1.0);
        Self(CompositeBackwardInputs {
            params: CompositeBackwardParams {
                members: member.len() as u32,
                tiles: tile_first.len() as u32 - 1,
                side,
                first_row: 0,
                rows: side,
                colors: 1,
                compensated_blur: 0.0,
            },
            tile,
            tile_first,
            member,
            splat,
            sum_gradient,
            member_gradient: member_gradient.chunks(4).map(Vec4::from_slice).collect(),
        })
    }

    /// The sums over a band of rows.
    fn band(mut self, first_row: u32, rows: u32) -> Self {
        (self.params.first_row, self.params.rows) = (first_row, rows);
        self
    }

    /// The same with covariances that a blur has made larger, and weights that make up for it.
    fn compensated(mut self) -> Self {
        self.params.compensated_blur = 0.3;
        let mut random = Random::new(17);
        for [placed, conic, _] in self.splat.as_chunks_mut().0 {
            let shape = blurred_conic(&mut random, -2.0);
            let [width, height] = extent(shape.to_array());
            placed.w = width;
            *conic = shape.extend(height);
        }
        self
    }

    /// The factor of the weight of a conic, and the sizes of the rounding errors of its root and of its slope.
    fn compensation(&self, [xx, xy, yy]: [f64; 3]) -> [f64; 3] {
        if self.params.compensated_blur == 0.0 {
            return [1.0, 1.0, 0.0];
        }
        let blur = f64::from(self.params.compensated_blur);
        let factor = compensation([xx, xy, yy], blur);
        let quotient = factor * factor;
        // differences from 1
        [factor, factor + 1.0 / factor, blur / quotient * (1.0 + 1.0 / quotient)]
    }

    /// A member's splat.
    fn splat(&self, index: usize) -> &[Vec4; 3] {
        &self.splat.as_chunks().0[self.member[index] as usize]
    }

    /// The pixels of a band of a member's tile: their centers, and the gradients of their sums.
    fn pixels(&self, index: usize) -> impl Iterator<Item = ([f64; 2], DVec4)> {
        let CompositeBackwardParams { side, first_row, rows, tiles, .. } = self.params;
        let first = |tile: &u32| self.tile_first[*tile as usize] as usize <= index;
        let tile = (0..tiles).rev().find(first).unwrap_or(0) * side * side;
        let band = tile + first_row * side..tile + (first_row + rows) * side;
        let area = (side * side) as usize;
        band.map(move |at| {
            (place(side, at as usize).1, pixel(&self.sum_gradient, area, at as usize))
        })
    }

    /// The derivatives of the band's sums: center, weight, conic and color.
    fn derivatives(&self, index: usize) -> [f64; 9] {
        let Splat { mean: [x, y], weight, conic: [xx, xy, yy], color: [r, g, b] } =
            Splat::from_vectors(self.splat(index));
        let blur = f64::from(self.params.compensated_blur);
        let [factor, ..] = self.compensation([xx, xy, yy]);
        let bare = weight / factor;
        gradient([x, y, bare, xx, xy, yy, r, g, b], |[x, y, bare, xx, xy, yy, r, g, b]| {
            let weight = if blur > 0.0 { bare * compensation([xx, xy, yy], blur) } else { bare };
            let splat = Splat { mean: [x, y], weight, conic: [xx, xy, yy], color: [r, g, b] };
            let mut loss = Dual::from(0.0);
            for (place, slopes) in self.pixels(index) {
                for (term, slope) in splat.term(place).into_iter().zip(slopes.to_array()) {
                    loss = loss + term * Dual::from(slope);
                }
            }
            loss
        })
    }

    /// Sizes of the terms of a member's gradient, and by how much they may differ at the cutoff.
    fn sizes(&self, index: usize) -> [[DVec4; 3]; 2] {
        let [placed, conic, color] = self.splat(index).map(|vector| vector.as_dvec4());
        let [_, root, slope] = self.compensation([conic.x, conic.y, conic.z]);
        let mut sizes = [[DVec4::ZERO; 3]; 2];
        for ([x, y], slopes) in self.pixels(index) {
            let dx = (x - placed.x).abs();
            let dy = (y - placed.y).abs();
            let cross = 2.0 * conic.y * (x - placed.x) * (y - placed.y);
            let q = conic.x * dx * dx + cross + conic.z * dy * dy;
            let slack = 2e-6 * (conic.x * dx * dx + cross.abs() + conic.z * dy * dy);
            let c = slopes.truncate().abs().extend(0.0);
            let by_alpha = c.dot(color.abs()) + slopes.w.abs();
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
        let new = |side, members: &[u32], seed| {
            Self::new(Composite::new(side, members, Fill::Random, seed))
        };
        let mut sets = sets(SIDES, 9, |side, fill| Self::new(Composite::filled(side, fill, 11)));
        sets.push(("no members".into(), new(8, &[0], 13)));
        sets.push(("one member".into(), new(8, &[1], 13)));
        // whole blocks of lanes, and those with a rest
        for side in [16, 19, 33, 64] {
            sets.push((format!("few, side {side}"), new(side, &[9, 0, 7], 15)));
        }
        // more rows than a dispatch may sum over, and members that may reach all pixels
        let mut wide = new(260, &[5, 4], 16);
        wide.splat.iter_mut().for_each(|vector| vector.w = 1e9);
        let rows = band_rows(260);
        sets.push((format!("{rows} rows of 260"), wide.clone().band(0, rows)));
        sets.push((format!("the rest after {rows} rows"), wide.band(rows, 260 - rows)));
        let set = new(17, &[30, 33], 14);
        let mut without_colors = set.clone();
        without_colors.params.colors = 0;
        sets.push(("without colors".into(), without_colors));
        sets.push(("compensated".into(), set.clone().compensated()));
        sets.push(("rows 3 to 9".into(), set.band(3, 7)));
        sets
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        runner.run(&self.kernel(), self.params.members, 1)
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<f64>> {
        let of = |index: usize| {
            let [x, y, weight, xx, xy, yy, r, g, b] = self.derivatives(index);
            let [r, g, b] = if self.params.colors == 1 { [r, g, b] } else { [0.0; 3] };
            [x, y, weight, 0.0, xx, xy, yy, 0.0, r, g, b, 0.0]
        };
        let before = self.member_gradient.iter().flat_map(Vec4::to_array);
        let sums = (0..self.member.len()).flat_map(of);
        before.zip(sums).map(|(before, sum)| Some(f64::from(before) + sum)).collect()
    }

    fn bound(&self, _: &Output, index: usize, _: Rounding) -> Bound {
        let before = self.member_gradient[index / 4];
        let [scale, floor] = self.sizes(index / 12).map(|size| size[index / 4 % 3][index % 4]);
        let pixels = f64::from(self.params.rows * self.params.side);
        let scale = f64::from(before[index % 4].abs()) + scale * (1.0 + 0.03 * pixels);
        // a conic may be flushed, and what it is multiplied with is large where it is
        let flushed = f64::from(TINY) * (1.0 + pixels * 1e15);
        Bound { scale, floor: floor + flushed }
    }
}
