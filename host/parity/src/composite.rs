//! The case of `composite`.

use glam::Vec4;
use muslin_check::prelude::*;
use organza_shaders::composite::{CompositeInputs, CompositeParams};
use organza_shaders::limits::MAX_INTERSECTIONS;
use organza_shaders::project::FALLOFF_CUTOFF;
use organza_shaders::slope::SLOPE_VECTORS;
use organza_shaders::tile::Tile;

use super::exact::composite::Splat;
use super::scan::prefix;
use super::tile::pack;

/// Sides around the workgroup's.
pub(super) const SIDES: [u32; 5] = [1, 7, 8, 9, 17];

/// Three tiles: at the origin, over the border, and far away.
pub(super) fn tiles() -> [Tile; 3] {
    let tile = |origin, output| Tile { camera: 0, origin, output };
    [tile([0, 0], 1), tile([-9, 5], 2), tile([4000, -30], 0)]
}

case!(pub Composite(CompositeInputs));

impl Composite {
    pub(super) fn new(side: u32, intersections: &[u32], fill: Fill, seed: u64) -> Self {
        let mut random = Random::new(seed);
        let splats = 300;
        let tiles: Vec<_> = tiles().into_iter().take(intersections.len()).collect();
        let far = 20_f32.max(side as f32 + 3.0);
        let mean = fill.values(&mut random, 2 * splats, [-12.0, far], 1e30);
        let conic = fill.values(&mut random, 2 * splats, [0.003, 0.4], 1e30);
        let splat = (0..splats).flat_map(|index| {
            let tile = &tiles[index % tiles.len()];
            let x = mean[2 * index];
            let y = mean[2 * index + 1];
            let near = [0, 1].map(|axis| tile.origin[axis] as f32);
            let xx = conic[2 * index].abs();
            let yy = conic[2 * index + 1].abs();
            // every tenth is a needle
            let slant = if index % 10 == 3 { 0.999_999 } else { random.between(-0.9, 0.9) };
            let xy = slant * xx.sqrt() * yy.sqrt();
            let [width, height] = extent([xx, xy, yy]);
            [
                Vec4::new(x + near[0], y + near[1], random.between(0.0, 1.0), width),
                Vec4::new(xx, xy, yy, height),
                Vec4::from_slice(&random.values(4, 0.0, 1.0)),
            ]
        });
        let splat = splat.collect();
        let tile_first = prefix(intersections.iter().copied());
        let all = tile_first[intersections.len()];
        let intersection = (0..all).map(|_| random.below(splats as u32)).collect();
        let area = (side * side) as usize;
        let sum = random.values(4 * tiles.len() * area, 0.0, 0.5);
        let sum = sum.as_chunks().0.iter().copied();
        Self(CompositeInputs {
            params: CompositeParams { side, skip: 0, sloped: 0, shaped: 0 },
            tile: pack(&tiles),
            tile_first,
            intersection,
            // all cells
            cells: vec![u32::MAX; all as usize],
            splat,
            slope: Fill::Random.vectors(
                &mut random,
                SLOPE_VECTORS as usize * splats,
                [-0.1, 0.1],
                0.0,
            ),
            sum: planes(sum, area),
        })
    }

    /// The same set with colors that vary.
    pub(super) fn sloped(mut self) -> Self {
        self.params.sloped = 1;
        self
    }

    /// The same set with falloffs from pointed to flat.
    pub(super) fn shaped(mut self) -> Self {
        self.params.shaped = 1;
        self.splat.iter_mut().skip(2).step_by(3).for_each(|color| color.w = 1.5 * color.w - 0.5);
        self
    }

    /// Three tiles; if they are not random, of the next seed.
    pub(super) fn filled(side: u32, fill: Fill, seed: u64) -> Self {
        match fill {
            Fill::Random => Self::new(side, &[40, 0, 90], fill, seed),
            _ => Self::new(side, &[1, 60, 60], fill, seed + 1),
        }
    }

    /// A tile with more intersections than a pass takes: faint ones, and then bright ones.
    fn crowded() -> Self {
        let mut set = Self::new(1, &[MAX_INTERSECTIONS + 5, 3], Fill::Random, 4);
        let [faint, bright] = [1e-6, 1.0].map(|weight| {
            let [width, height] = extent([0.1, 0.0, 0.1]);
            let center = Vec4::new(0.5, 0.5, weight, width);
            [center, Vec4::new(0.1, 0.0, 0.1, height), Vec4::splat(0.7)]
        });
        set.splat[..6].copy_from_slice([faint, bright].as_flattened());
        let (first, rest) = set.intersection.split_at_mut(MAX_INTERSECTIONS as usize);
        first.fill(0);
        rest.fill(1);
        set
    }

    /// The splats of a tile that this pass sums up.
    fn splats(&self, tile: usize) -> impl Iterator<Item = Splat<Rounded>> {
        let end = self.tile_first[tile + 1];
        let first = self.tile_first[tile] + self.params.skip;
        let end = end.min(first + MAX_INTERSECTIONS);
        let intersections = &self.intersection[first.min(end) as usize..end as usize];
        intersections.iter().map(|&pair| {
            let pair = pair as usize;
            let vectors: &[Vec4; 3] = &self.splat.as_chunks().0[pair];
            let mut splat = Splat::from_vectors(vectors);
            if self.params.sloped != 0 {
                splat = splat.growing(&self.slope[SLOPE_VECTORS as usize * pair..]);
            }
            splat.flatness = (self.params.shaped != 0).then_some(vectors[2].w.into());
            splat
        })
    }
}

/// Tile of a pixel, and its center in the image.
pub(super) fn place(side: u32, pixel: usize) -> (usize, [f64; 2]) {
    let side = side as usize;
    let tile = pixel / (side * side);
    let [x, y] = tiles()[tile].origin.map(f64::from);
    let row = pixel / side % side;
    let column = pixel % side;
    (tile, [x + column as f64 + 0.5, y + row as f64 + 0.5])
}

/// Half the size of the box around `q <= cutoff`, with `project`'s margin; all of f32 where the conic has no inverse.
pub fn extent(conic: [f32; 3]) -> [f32; 2] {
    let [xx, xy, yy] = conic.map(f64::from);
    let determinant = xx * yy - xy * xy;
    [yy, xx].map(|minor| {
        let half = (f64::from(FALLOFF_CUTOFF) * minor / determinant).sqrt() * 1.001 + 0.01;
        if half.is_finite() { half as f32 } else { f32::MAX }
    })
}

/// Pixels as the kernels keep them: a plane for each channel of a tile.
pub(super) fn planes<T: Copy>(pixels: impl Iterator<Item = [T; 4]>, area: usize) -> Vec<T> {
    let pixels: Vec<_> = pixels.collect();
    let tiles = pixels.chunks(area);
    let planes = tiles.flat_map(|tile| (0..4).map(move |channel| (tile, channel)));
    planes.flat_map(|(tile, channel)| tile.iter().map(move |pixel| pixel[channel])).collect()
}

/// A pixel of [`planes`].
pub(super) fn pixel(planes: &[f32], area: usize, pixel: usize) -> [Rounded; 4] {
    let first = pixel / area * 4 * area + pixel % area;
    [0, 1, 2, 3].map(|plane| planes[first + plane * area].into())
}

impl Parity for Composite {
    fn sets() -> Vec<(String, Self)> {
        let mut sets = inputs::sets_of(SIDES, 9, |side, fill, _| Self::filled(side, fill, 1));
        sets.push(("no intersections".into(), Self::new(8, &[0], Fill::Random, 3)));
        sets.push(("one intersection".into(), Self::new(8, &[1], Fill::Random, 3)));
        sets.push(("crowded".into(), Self::crowded()));
        let mut second = Self::new(8, &[25, 20], Fill::Random, 5);
        second.params.skip = 20;
        sets.push(("second pass".into(), second));
        for side in SIDES {
            let set = Self::filled(side, Fill::Random, 1).sloped();
            sets.push((format!("sloped, side {side}"), set.clone()));
            sets.push((format!("sloped and shaped, side {side}"), set.shaped()));
            let set = Self::filled(side, Fill::Random, 2).shaped();
            sets.push((format!("shaped, side {side}"), set));
        }
        sets
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<Rounded>> {
        let side = self.params.side;
        let area = (side * side) as usize;
        let of = |at: usize| {
            let (tile, place) = place(side, at);
            let terms = self.splats(tile).map(|splat| splat.term(place));
            terms.fold(pixel(&self.sum, area, at), |sum, term: [Rounded; 4]| {
                [0, 1, 2, 3].map(|channel| sum[channel] + term[channel])
            })
        };
        listed(planes((0..self.sum.len() / 4).map(of), area))
    }
}
