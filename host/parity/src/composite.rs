//! The case of `composite`.

use glam::Vec4;
use muslin_check::prelude::*;
use organza_shaders::composite::{CompositeKernel, CompositeParams};
use organza_shaders::limits::MAX_MEMBERS;
use organza_shaders::project::FALLOFF_CUTOFF;
use organza_shaders::tile::Tile;

use super::exact::composite::{Splat, falloff};
use super::tile::pack;

/// Sides around the workgroup's.
pub(super) const SIDES: [u32; 5] = [1, 7, 8, 9, 17];

/// Three tiles: at the origin, over the border, and far away.
pub(super) fn tiles() -> Vec<Tile> {
    let tile = |origin, output| Tile { camera: 0, origin, output };
    vec![tile([0, 0], 1), tile([-9, 5], 2), tile([4000, -30], 0)]
}

/// Inputs of `composite`.
#[derive(Clone, Debug)]
pub struct Composite {
    /// S
    pub side: u32,
    /// Members that earlier passes have summed up.
    pub skip: u32,
    /// The tiles.
    pub tiles: Vec<Tile>,
    /// `[tiles + 1]`
    pub tile_first: Vec<u32>,
    /// Indices of splats.
    pub member: Vec<u32>,
    /// `[splats, 3]`
    pub splat: Vec<[Vec4; 3]>,
    /// `[tiles, S, S]`: what earlier passes have left.
    pub sum: Vec<Vec4>,
}

impl Composite {
    pub(super) fn new(side: u32, members: &[u32], fill: Fill, seed: u64) -> Self {
        let mut random = Random::new(seed);
        let splats = 300;
        let tiles: Vec<_> = tiles().into_iter().take(members.len()).collect();
        let far = 20_f32.max(side as f32 + 3.0);
        let mean = fill.values(&mut random, 2 * splats, [-12.0, far], 1e30);
        let conic = fill.values(&mut random, 2 * splats, [0.003, 0.4], 1e30);
        let splat = (0..splats).map(|index| {
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
        let splat: Vec<_> = splat.collect();
        let mut tile_first = vec![0];
        members.iter().for_each(|count| tile_first.push(tile_first[tile_first.len() - 1] + count));
        let all = tile_first[members.len()];
        let member = (0..all).map(|_| random.below(splats as u32)).collect();
        let pixels = tiles.len() * (side * side) as usize;
        let sum = (0..pixels).map(|_| Vec4::from_slice(&random.values(4, 0.0, 0.5))).collect();
        Self { side, skip: 0, tiles, tile_first, member, splat, sum }
    }

    /// A tile with more members than a pass takes: faint ones, and then bright ones.
    fn crowded() -> Self {
        let mut set = Self::new(1, &[MAX_MEMBERS + 5, 3], Fill::Random, 4);
        let [faint, bright] = [1e-6, 1.0].map(|weight| {
            let [width, height] = extent([0.1, 0.0, 0.1]);
            let center = Vec4::new(0.5, 0.5, weight, width);
            [center, Vec4::new(0.1, 0.0, 0.1, height), Vec4::splat(0.7)]
        });
        set.splat[..2].copy_from_slice(&[faint, bright]);
        let (first, rest) = set.member.split_at_mut(MAX_MEMBERS as usize);
        first.fill(0);
        rest.fill(1);
        set
    }

    /// The members of a tile that this pass sums up.
    pub fn members(&self, tile: usize) -> &[u32] {
        let end = self.tile_first[tile + 1].min(self.tile_first[tile] + self.skip + MAX_MEMBERS);
        &self.member[(self.tile_first[tile] + self.skip).min(end) as usize..end as usize]
    }

    /// Tile, and the pixel's center in the image.
    pub fn pixel(&self, index: usize) -> (usize, [f64; 2]) {
        let side = self.side as usize;
        let tile = index / (side * side);
        let [x, y] = self.tiles[tile].origin.map(f64::from);
        let row = index / side % side;
        let column = index % side;
        (tile, [x + column as f64 + 0.5, y + row as f64 + 0.5])
    }
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
        let mut sets: Vec<_> = SIDES
            .iter()
            .map(|&side| {
                (format!("random, side {side}"), Self::new(side, &[40, 0, 90], Fill::Random, 1))
            })
            .collect();
        for fill in Fill::ADVERSARIAL {
            let set = Self::new(9, &[1, 60, 60], fill, 2);
            sets.push((format!("{}, side 9", fill.name()), set));
        }
        sets.push(("no members".into(), Self::new(8, &[0], Fill::Random, 3)));
        sets.push(("one member".into(), Self::new(8, &[1], Fill::Random, 3)));
        sets.push(("crowded".into(), Self::crowded()));
        let skip = 20;
        sets.push((
            "second pass".into(),
            Self { skip, ..Self::new(8, &[25, 20], Fill::Random, 5) },
        ));
        sets
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let area = (self.side * self.side) as usize;
        let kernel = CompositeKernel {
            params: CompositeParams { side: self.side, skip: self.skip },
            tile: &pack(&self.tiles),
            tile_first: &self.tile_first,
            member: &self.member,
            // everywhere
            cells: &vec![u32::MAX; self.member.len()],
            splat: &self.splat.as_flattened().to_vec(),
            sum: &planes(&self.sum, area),
        };
        Ok(pixels(runner.run_over(&kernel, [self.side, self.side, self.tiles.len() as u32])?, area))
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<f64>> {
        let pixel = |(at, before): (usize, &Vec4)| {
            let (tile, place) = self.pixel(at);
            let mut sum = before.as_dvec4().to_array();
            for &member in self.members(tile) {
                let term = Splat::from_vectors(&self.splat[member as usize]).term(place);
                sum.iter_mut().zip(term).for_each(|(sum, term)| *sum += term);
            }
            sum
        };
        let exact = self.sum.iter().enumerate().flat_map(pixel).map(Some);
        exact.collect()
    }

    /// A pixel of thousands of members adds up their roundings, and so do drivers that regroup.
    fn exact_bound(&self, exact: &Output, index: usize, _: Rounding) -> Bound {
        self.bound(exact, index, Rounding::Regrouped)
    }

    fn bound(&self, _: &Output, index: usize, rounding: Rounding) -> Bound {
        let at = index / 4;
        let channel = index % 4;
        let (tile, pixel) = self.pixel(at);
        let members = self.members(tile);
        let mut scale = f64::from(self.sum[at][channel].abs());
        let mut floor = f64::from(TINY) * (1.0 + members.len() as f64);
        for &member in members {
            let [placed, conic, color] = self.splat[member as usize].map(|v| v.as_dvec4());
            let dx = pixel[0] - placed.x;
            let dy = pixel[1] - placed.y;
            let terms = [conic.x * dx * dx, 2.0 * conic.y * dx * dy, conic.z * dy * dy];
            // the difference itself is rounded too: to 1e-7 of the pixel's and the center's size
            let d = |d: f64, x: f64| 1.0 + 0.2 * x.abs() / d.abs().max(1e-3);
            let slack = 1e-6
                * terms.iter().map(|t| t.abs()).sum::<f64>()
                * d(dx, pixel[0]).max(d(dy, pixel[1]));
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
            Rounding::Regrouped => 1.0 + 0.03 * members.len() as f64,
        };
        Bound { scale: scale * roundings, floor }
    }
}
