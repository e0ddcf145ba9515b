//! The case of `composite_backward`.

use glam::Vec4;
use muslin_check::prelude::*;
use organza_shaders::composite::{CompositeInputs, CompositeParams};
use organza_shaders::composite_backward::{
    CompositeBackwardInputs, CompositeBackwardParams, band_rows,
};
use organza_shaders::slope::SLOPE_VECTORS;

use super::composite::{Composite, SIDES, extent, pixel, place};
use super::exact::composite::{Splat, compensation, flatness_slope};
use super::splat::blurred_conic;

case!(pub CompositeBackward(CompositeBackwardInputs));

impl CompositeBackward {
    fn new(Composite(forward): Composite) -> Self {
        let side = forward.params.side;
        let CompositeParams { sloped, shaped, .. } = forward.params;
        let CompositeInputs { tile, tile_first, intersection, mut splat, slope, sum, .. } = forward;
        // squares of distances are finite
        for placed in splat.iter_mut().step_by(3) {
            placed.x = placed.x.clamp(-1e15, 1e15);
            placed.y = placed.y.clamp(-1e15, 1e15);
        }
        let mut random = Random::new(8);
        let sum_gradient = random.values(sum.len(), -1.0, 1.0);
        let intersection_gradient =
            Fill::Random.vectors(&mut random, 3 * intersection.len(), [-1.0, 1.0], 0.0);
        let intersection_slope =
            Fill::Random.vectors(&mut random, 2 * intersection.len(), [-1.0, 1.0], 0.0);
        Self(CompositeBackwardInputs {
            params: CompositeBackwardParams {
                intersections: intersection.len() as u32,
                tiles: tile_first.len() as u32 - 1,
                side,
                first_row: 0,
                rows: side,
                compensated_blur: 0.0,
                sloped,
                shaped,
            },
            tile,
            tile_first,
            intersection,
            splat,
            slope,
            sum_gradient,
            intersection_gradient,
            intersection_slope,
        })
    }

    /// The sums over a band of rows.
    fn band(mut self, first_row: u32, rows: u32) -> Self {
        self.params.first_row = first_row;
        self.params.rows = rows;
        self
    }

    /// The same set with blurred covariances, and weights that compensate for the blur.
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

    /// An intersection's splat.
    fn splat(&self, index: usize) -> &[Vec4; 3] {
        &self.splat.as_chunks().0[self.intersection[index] as usize]
    }

    /// The pixels of a band of an intersection's tile: their centers, and the gradients of their sums.
    fn pixels(&self, index: usize) -> impl Iterator<Item = ([f64; 2], [Rounded; 4])> {
        let CompositeBackwardParams { side, first_row, rows, tiles, .. } = self.params;
        let first = |tile: &u32| self.tile_first[*tile as usize] as usize <= index;
        let tile = (0..tiles).rev().find(first).unwrap_or(0) * side * side;
        let band = tile + first_row * side..tile + (first_row + rows) * side;
        let area = (side * side) as usize;
        band.map(move |at| {
            (place(side, at as usize).1, pixel(&self.sum_gradient, area, at as usize))
        })
    }

    /// The derivatives of the band's sums: center, weight, conic, color, how the color grows, and flatness.
    fn derivatives(&self, index: usize) -> [Rounded; 16] {
        let slope = &self.slope[SLOPE_VECTORS as usize * self.intersection[index] as usize..];
        let splat = Splat::<Rounded>::from_vectors(self.splat(index)).growing(slope);
        let Splat { mean: [x, y], weight, conic, color: [r, g, b], growth, .. } = splat;
        let k = self.splat(index)[2].w.into();
        let [[rx, gx, bx], [ry, gy, by]] = growth.expect("it grows");
        let [grows, is_shaped] = [self.params.sloped, self.params.shaped].map(|on| on != 0);
        let blur = f64::from(self.params.compensated_blur);
        let [xx, xy, yy] = conic;
        let bare = if blur > 0.0 { weight / compensation(conic, blur) } else { weight };
        let pixels: Vec<_> = self.pixels(index).collect();
        let values = [x, y, bare, xx, xy, yy, r, g, b, rx, gx, bx, ry, gy, by, k];
        gradient(values, |[x, y, bare, xx, xy, yy, r, g, b, rx, gx, bx, ry, gy, by, k]| {
            let growth = grows.then_some([[rx, gx, bx], [ry, gy, by]]);
            let conic = [xx, xy, yy];
            let weight = if blur > 0.0 { bare * compensation(conic, blur) } else { bare };
            let flatness = is_shaped.then_some(k);
            let splat = Splat { mean: [x, y], weight, conic, color: [r, g, b], growth, flatness };
            Number::sum(pixels.iter().flat_map(|(place, slopes)| {
                let terms = splat.term(*place);
                [0, 1, 2, 3].map(|channel| terms[channel] * Dual::constant(slopes[channel]))
            }))
        })
    }
}

impl Parity for CompositeBackward {
    fn sets() -> Vec<(String, Self)> {
        let new = |side, intersections: &[u32], seed| {
            Self::new(Composite::new(side, intersections, Fill::Random, seed))
        };
        let mut sets =
            inputs::sets_of(SIDES, 9, |side, fill, _| Self::new(Composite::filled(side, fill, 11)));
        sets.push(("no intersections".into(), new(8, &[0], 13)));
        sets.push(("one intersection".into(), new(8, &[1], 13)));
        // whole blocks of lanes, and those with a rest
        for side in [16, 19, 33, 64] {
            sets.push((format!("few, side {side}"), new(side, &[9, 0, 7], 15)));
        }
        // more rows than a dispatch may sum over, and intersections that may reach all pixels
        let mut wide = new(260, &[5, 4], 16);
        wide.splat.iter_mut().for_each(|vector| vector.w = 1e9);
        let rows = band_rows(260);
        sets.push((format!("{rows} rows of 260"), wide.clone().band(0, rows)));
        sets.push((format!("the rest after {rows} rows"), wide.band(rows, 260 - rows)));
        let set = new(17, &[30, 33], 14);
        sets.push(("compensated".into(), set.clone().compensated()));
        sets.push(("rows 3 to 9".into(), set.band(3, 7)));
        for side in [1, 9, 16, 19, 33] {
            let set = Composite::filled(side, Fill::Random, 11).sloped();
            sets.push((format!("sloped, side {side}"), Self::new(set.clone())));
            let set = Self::new(set.shaped());
            sets.push((format!("sloped and shaped, side {side}"), set.clone()));
            sets.push((format!("sloped, shaped and compensated, side {side}"), set.compensated()));
            let set = Self::new(Composite::filled(side, Fill::Random, 12).shaped());
            sets.push((format!("shaped, side {side}"), set));
        }
        sets
    }

    fn exact(&self, output: &str, _: usize) -> Vec<Option<Rounded>> {
        let zero = Rounded::exact(0.0);
        let of = |index: usize| {
            let [x, y, weight, xx, xy, yy, r, g, b, rx, gx, bx, ry, gy, by, k] =
                self.derivatives(index);
            let by_shape = k * flatness_slope(self.splat(index)[2].w);
            match output {
                "intersection_slope" => vec![rx, gx, bx, zero, ry, gy, by, zero],
                _ => vec![x, y, weight, zero, xx, xy, yy, zero, r, g, b, by_shape],
            }
        };
        let before = match output {
            "intersection_slope" => &self.intersection_slope,
            _ => &self.intersection_gradient,
        };
        let before = before.iter().flat_map(Vec4::to_array);
        let sums = (0..self.intersection.len()).flat_map(of);
        listed(before.zip(sums).map(|(before, sum)| Rounded::from(before) + sum))
    }
}
