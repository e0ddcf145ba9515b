//! The case of `composite`.

use glam::{DVec4, Vec4};
use muslin_check::prelude::*;
use organza_shaders::composite::{CompositeInputs, CompositeParams};
use organza_shaders::limits::MAX_MEMBERS;
use organza_shaders::project::FALLOFF_CUTOFF;
use organza_shaders::tile::Tile;

use super::exact::composite::{Splat, falloff};
use super::scan::prefix;
use super::tile::pack;

/// Sides around the workgroup's.
pub(super) const SIDES: [u32; 5] = [1, 7, 8, 9, 17];

/// A random set of each side, and one of each other filling.
pub(super) fn sets<T>(
    sides: impl IntoIterator<Item = u32>,
    filled: u32,
    new: impl Fn(u32, Fill) -> T,
) -> Vec<(String, T)> {
    let sized = sides.into_iter().map(|side| (side, Fill::Random));
    let all = sized.chain(Fill::ADVERSARIAL.map(|fill| (filled, fill)));
    all.map(|(side, fill)| (format!("{}, side {side}", fill.name()), new(side, fill))).collect()
}

/// Three tiles: at the origin, over the border, and far away.
pub(super) fn tiles() -> [Tile; 3] {
    let tile = |origin, output| Tile { camera: 0, origin, output };
    [tile([0, 0], 1), tile([-9, 5], 2), tile([4000, -30], 0)]
}

case!(pub Composite(CompositeInputs));

impl Composite {
    pub(super) fn new(side: u32, members: &[u32], fill: Fill, seed: u64) -> Self {
        let mut random = Random::new(seed);
        let splats = 300;
        let tiles: Vec<_> = tiles().into_iter().take(members.len()).collect();
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
        let tile_first = prefix(members.iter().copied());
        let all = tile_first[members.len()];
        let member = (0..all).map(|_| random.below(splats as u32)).collect();
        let area = (side * side) as usize;
        let pixels = (0..tiles.len() * area).map(|_| random.values(4, 0.0, 0.5));
        let pixels: Vec<_> = pixels.map(|values| Vec4::from_slice(&values)).collect();
        Self(CompositeInputs {
            params: CompositeParams { side, skip: 0 },
            tile: pack(&tiles),
            tile_first,
            member,
            // everywhere
            cells: vec![u32::MAX; all as usize],
            splat,
            sum: planes(&pixels, area),
        })
    }

    /// Three tiles; if they are not random, of the next seed.
    pub(super) fn filled(side: u32, fill: Fill, seed: u64) -> Self {
        match fill {
            Fill::Random => Self::new(side, &[40, 0, 90], fill, seed),
            _ => Self::new(side, &[1, 60, 60], fill, seed + 1),
        }
    }

    /// A tile with more members than a pass takes: faint ones, and then bright ones.
    fn crowded() -> Self {
        let mut set = Self::new(1, &[MAX_MEMBERS + 5, 3], Fill::Random, 4);
        let [faint, bright] = [1e-6, 1.0].map(|weight| {
            let [width, height] = extent([0.1, 0.0, 0.1]);
            let center = Vec4::new(0.5, 0.5, weight, width);
            [center, Vec4::new(0.1, 0.0, 0.1, height), Vec4::splat(0.7)]
        });
        set.splat[..6].copy_from_slice([faint, bright].as_flattened());
        let (first, rest) = set.member.split_at_mut(MAX_MEMBERS as usize);
        first.fill(0);
        rest.fill(1);
        set
    }

    /// The splats of a tile that this pass sums up.
    fn splats(&self, tile: usize) -> impl Iterator<Item = &[Vec4; 3]> {
        let end = self.tile_first[tile + 1];
        let first = self.tile_first[tile] + self.params.skip;
        let end = end.min(first + MAX_MEMBERS);
        let members = &self.member[first.min(end) as usize..end as usize];
        members.iter().map(|&member| &self.splat.as_chunks().0[member as usize])
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
pub(super) fn planes(sum: &[Vec4], area: usize) -> Vec<f32> {
    let plane = |tile: &[Vec4], channel: usize| -> Vec<f32> {
        tile.iter().map(|pixel| pixel[channel]).collect()
    };
    let tiles = sum.chunks(area);
    tiles.flat_map(|tile| (0..4).flat_map(move |channel| plane(tile, channel))).collect()
}

/// A pixel of [`planes`].
pub(super) fn pixel(planes: &[f32], area: usize, pixel: usize) -> DVec4 {
    let first = pixel / area * 4 * area + pixel % area;
    DVec4::from_array([0, 1, 2, 3].map(|plane| f64::from(planes[first + plane * area])))
}

/// The inverse of [`planes`].
pub(super) fn pixels(mut outputs: Vec<Output>, area: usize) -> Vec<Output> {
    let planes = outputs[0].floats();
    let (tiles, tail) = planes.split_at(planes.len() / (4 * area) * (4 * area));
    let pixel = |tile: &[f64], at: usize| -> Vec<f64> {
        (0..4).map(|channel| tile[channel * area + at]).collect()
    };
    let tiles = tiles.chunks(4 * area);
    let pixels = tiles.flat_map(|tile| (0..area).flat_map(move |at| pixel(tile, at)));
    outputs[0].values = Values::Float(pixels.chain(tail.iter().copied()).collect());
    outputs
}

impl Parity for Composite {
    const KERNEL: &'static str = "composite";
    const TOLERANCE: f64 = 2e-6;
    const WHY: &'static str = "exp's 3 + 2 abs(x) ulp of every term; q is good to 1e-6 of its terms' \
        sizes, and at the cutoff a member within that may come out on either side (1/255)";

    fn sets() -> Vec<(String, Self)> {
        let mut sets = sets(SIDES, 9, |side, fill| Self::filled(side, fill, 1));
        sets.push(("no members".into(), Self::new(8, &[0], Fill::Random, 3)));
        sets.push(("one member".into(), Self::new(8, &[1], Fill::Random, 3)));
        sets.push(("crowded".into(), Self::crowded()));
        let mut second = Self::new(8, &[25, 20], Fill::Random, 5);
        second.params.skip = 20;
        sets.push(("second pass".into(), second));
        sets
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let side = self.params.side;
        let outputs = runner.run_over(&self.kernel(), [side, side, self.tile.len() as u32 / 4])?;
        Ok(pixels(outputs, (side * side) as usize))
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<f64>> {
        let side = self.params.side;
        let of = |at: usize| {
            let (tile, place) = place(side, at);
            let mut sum = pixel(&self.sum, (side * side) as usize, at).to_array();
            for splat in self.splats(tile) {
                let term = Splat::from_vectors(splat).term(place);
                sum.iter_mut().zip(term).for_each(|(sum, term)| *sum += term);
            }
            sum
        };
        (0..self.sum.len() / 4).flat_map(of).map(Some).collect()
    }

    /// A pixel of thousands of members adds up their roundings, and so do drivers that regroup.
    fn exact_bound(&self, exact: &Output, index: usize, _: Rounding) -> Bound {
        self.bound(exact, index, Rounding::Regrouped)
    }

    fn bound(&self, _: &Output, index: usize, rounding: Rounding) -> Bound {
        let channel = index % 4;
        let side = self.params.side;
        let (tile, place) = place(side, index / 4);
        let splats: Vec<_> = self.splats(tile).collect();
        let members = splats.len() as f64;
        let mut scale = pixel(&self.sum, (side * side) as usize, index / 4)[channel].abs();
        let mut floor = f64::from(TINY) * (1.0 + members);
        for splat in splats {
            let [placed, conic, color] = splat.map(|v| v.as_dvec4());
            let dx = place[0] - placed.x;
            let dy = place[1] - placed.y;
            let terms = [conic.x * dx * dx, 2.0 * conic.y * dx * dy, conic.z * dy * dy];
            // the difference itself is rounded too: to 1e-7 of the pixel's and the center's size
            let d = |d: f64, x: f64| 1.0 + 0.2 * x.abs() / d.abs().max(1e-3);
            let slack = 1e-6
                * terms.iter().map(|t| t.abs()).sum::<f64>()
                * d(dx, place[0]).max(d(dy, place[1]));
            // a conic may be flushed, and what it is multiplied with is large where it is
            let [xx, xy, yy] = [conic.x, conic.y, conic.z].map(|c| c.abs().min(TINY.into()));
            let slack = slack + xx * dx * dx + 2.0 * xy * (dx * dy).abs() + yy * dy * dy;
            let q: f64 = terms.iter().sum();
            let weight = placed.z * if channel == 3 { 1.0 } else { color[channel].abs() };
            scale += weight * falloff(q);
            floor += weight * (falloff(q - slack) - falloff(q + slack));
            // NVIDIA's driver squares a distance first: beyond the square root of f32, it is infinite, and times zero no number
            let overflows = dx.abs().max(dy.abs()) > f64::from(f32::MAX).sqrt();
            if overflows && rounding == Rounding::Regrouped {
                floor += weight;
            }
        }
        let roundings = match rounding {
            Rounding::AsWritten => 1.0,
            Rounding::Regrouped => 1.0 + 0.03 * members,
        };
        Bound { scale: scale * roundings, floor }
    }
}
