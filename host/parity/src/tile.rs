//! Cases of `tile_mask`, `tile_fill` and `tile_range`.

use glam::Vec4;
use organza_check::{
    KernelRunner, Output, Parity,
    inputs::{Fill, Random, SIZES},
};
use organza_shaders::project::{BEHIND, DEGENERATE};
use organza_shaders::tile::{
    Tile, TileFillKernel, TileFillParams, TileMaskKernel, TileMaskParams, TileRangeKernel,
    TileRangeParams,
};

use super::exact::tile::reaches;
use super::exact::{bits, listed};
use super::pair::{mask_sets, scanned};
use organza_device::Result;

/// Tiles as they lie in a buffer.
pub fn pack(tiles: &[Tile]) -> Vec<i32> {
    tiles.iter().flat_map(Tile::pack).collect()
}

/// Tiles of two cameras: within the image, over its corner, far outside.
fn tiles() -> Vec<Tile> {
    let tile = |camera, origin, output| Tile { camera, origin, output };
    vec![
        tile(0, [0, 0], 2),
        tile(0, [-17, 30], 0),
        tile(0, [1 << 20, -(1 << 20)], 1),
        tile(1, [100, 75], 3),
    ]
}

/// Inputs of `tile_mask`.
#[derive(Clone, Debug)]
pub struct TileMask {
    /// Gaussians of the scene.
    pub gaussians: u32,
    /// S
    pub side: u32,
    /// The tiles.
    pub tiles: Vec<Tile>,
    /// `[cameras, gaussians, 2]`
    pub projection: Vec<Vec4>,
}

impl TileMask {
    fn new(gaussians: u32, side: u32, fill: Fill) -> Self {
        let mut random = Random::new(u64::from(gaussians * 1000 + side));
        let slots = 2 * gaussians as usize;
        let x = fill.values(&mut random, slots, [-60.0, 200.0], 1e30);
        let y = fill.values(&mut random, slots, [-60.0, 200.0], 1e30);
        let r = fill.values(&mut random, slots, [0.0, 60.0], 1e30);
        let mut projection = Vec::with_capacity(2 * slots);
        for slot in 0..slots {
            let radius = match random.below(8) {
                0 => BEHIND,
                1 => DEGENERATE,
                _ => r[slot].abs(),
            };
            projection.push(Vec4::new(x[slot], y[slot], radius, 0.0));
            // nothing may depend on the conic
            projection.push(Vec4::splat(f32::NAN));
        }
        let mut set = Self { gaussians, side, tiles: tiles(), projection };
        set.leave_the_margin();
        set
    }

    /// A Gaussian within rounding of a tile's margin may be a member or not: it is moved into the tile.
    fn leave_the_margin(&mut self) {
        for tile in &self.tiles {
            let first = (tile.camera * self.gaussians) as usize;
            for p in
                self.projection.iter_mut().skip(2 * first).step_by(2).take(self.gaussians as usize)
            {
                let outside = |x: f32, low: i32| {
                    let low = f64::from(low);
                    f64::from(x) - f64::from(x).clamp(low, low + f64::from(self.side))
                };
                let distance = outside(p.x, tile.origin[0]).hypot(outside(p.y, tile.origin[1]));
                let reach = f64::from(p.z) * 1.001 + 0.01;
                let apart = (distance - reach).abs();
                // and squares of 1e19 and more overflow
                if p.z >= 0.0
                    && apart <= 1e-5 * (reach + distance + f64::from(p.x.abs().max(p.y.abs())))
                {
                    p.z = BEHIND;
                }
            }
        }
    }
}

impl Parity for TileMask {
    const KERNEL: &'static str = "tile_mask";
    const TOLERANCE: f64 = 0.0;
    const WHY: &'static str =
        "integers; no Gaussian within 1e-5 of a tile's margin, where rounding decides";

    fn sets() -> Vec<(String, Self)> {
        // words around the workgroup's size, and a last word that is not full
        let sized = [0, 1, 31, 32, 33, 63 * 32, 64 * 32 - 1, 64 * 32, 64 * 32 + 1, 129 * 32];
        let sized =
            sized.map(|n| (format!("random, {n} Gaussians"), Self::new(n, 16, Fill::Random)));
        let sides = [1, 8, 17, 4096]
            .map(|s| (format!("random, side {s}"), Self::new(300, s, Fill::Random)));
        let filled = Fill::ADVERSARIAL
            .map(|fill| (format!("{}, 129 Gaussians", fill.name()), Self::new(129, 16, fill)));
        sized.into_iter().chain(sides).chain(filled).collect()
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let words = self.gaussians.div_ceil(32);
        let len = self.tiles.len() * words as usize;
        let kernel = TileMaskKernel {
            params: TileMaskParams { gaussians: self.gaussians, words, side: self.side },
            tile: &pack(&self.tiles),
            projection: &self.projection,
            mask: &runner.unwritten(len),
            count: &runner.unwritten(len),
        };
        runner.run(&kernel, words, self.tiles.len() as u32)
    }

    /// The Gaussians within reach.
    fn exact(&self, output: &str, _: usize) -> Vec<Option<f64>> {
        let words = self.gaussians.div_ceil(32);
        let word = |tile: &Tile, word: u32| {
            let mut mask = 0_u32;
            for bit in 0..32.min(self.gaussians - 32 * word) {
                let slot = tile.camera * self.gaussians + 32 * word + bit;
                let p = self.projection[2 * slot as usize].as_dvec4();
                // squares of more are no f32: such a Gaussian may be a member of any tile
                if p.truncate().abs().max_element() >= 1e18 {
                    return None;
                }
                let is_member = reaches([p.x, p.y], p.z, tile.origin, self.side);
                mask |= u32::from(is_member) << bit;
            }
            Some(f64::from(if output == "mask" { mask } else { mask.count_ones() }))
        };
        let tiles = self.tiles.iter();
        let exact = tiles.flat_map(|tile| (0..words).map(move |at| word(tile, at)));
        exact.collect()
    }
}

/// Inputs of `tile_fill`.
#[derive(Clone, Debug)]
pub struct TileFill {
    /// Words of a mask.
    pub words: u32,
    /// The tiles.
    pub tiles: Vec<Tile>,
    /// `[tiles, words]`
    pub tile_mask: Vec<u32>,
    /// `[cameras, words]`: the union of the camera's tiles, and more.
    pub pair_mask: Vec<u32>,
}

impl Parity for TileFill {
    const KERNEL: &'static str = "tile_fill";

    fn sets() -> Vec<(String, Self)> {
        mask_sets(|words, bits, random| {
            let tiles = tiles();
            let tile_mask = bits.words(random, tiles.len() as u32 * words);
            let mut pair_mask = vec![0; 2 * words as usize];
            for (tile, masks) in tiles.iter().zip(tile_mask.chunks(words.max(1) as usize)) {
                let first = (tile.camera * words) as usize;
                pair_mask[first..].iter_mut().zip(masks).for_each(|(pair, mask)| *pair |= mask);
            }
            Self { words, tiles, tile_mask, pair_mask }
        })
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let first_member = scanned(&self.tile_mask);
        let kernel = TileFillKernel {
            params: TileFillParams { words: self.words },
            tile: &pack(&self.tiles),
            tile_mask: &self.tile_mask,
            first_member: &first_member,
            pair_mask: &self.pair_mask,
            first_pair: &scanned(&self.pair_mask),
            member: &runner.unwritten(*first_member.last().unwrap_or(&0) as usize),
        };
        runner.run(&kernel, self.words, self.tiles.len() as u32)
    }

    /// A pair's number is its place among those of its camera, behind those of the cameras before.
    fn exact(&self, _: &str, _: usize) -> Vec<Option<f64>> {
        let (words, gaussians) = (self.words as usize, 32 * self.words as usize);
        let pairs: Vec<_> = bits(&self.pair_mask).collect();
        let members = self.tiles.iter().enumerate().flat_map(|(t, tile)| {
            let members = bits(&self.tile_mask[t * words..][..words]);
            let slots: Vec<_> =
                members.map(|gaussian| tile.camera as usize * gaussians + gaussian).collect();
            slots.into_iter().map(|slot| pairs.binary_search(&slot).expect("members are pairs"))
        });
        listed(members.map(|pair| pair as u32))
    }
}

/// Inputs of `tile_range`.
#[derive(Clone, Debug)]
pub struct TileRange {
    /// Tiles of the batch.
    pub tiles: u32,
    /// Words of a mask.
    pub words: u32,
    /// `[tiles * words + 1]`
    pub first_member: Vec<u32>,
}

impl Parity for TileRange {
    const KERNEL: &'static str = "tile_range";

    fn sets() -> Vec<(String, Self)> {
        let of = |(tiles, words): (u32, u32)| {
            let mut random = Random::new(u64::from(tiles));
            let first_member = (0..=tiles * words).map(|_| random.bits()).collect();
            (format!("{tiles} tiles of {words} words"), Self { tiles, words, first_member })
        };
        SIZES.into_iter().flat_map(|tiles| [1, 7].map(|words| (tiles, words))).map(of).collect()
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let kernel = TileRangeKernel {
            params: TileRangeParams { tiles: self.tiles, words: self.words },
            first_member: &self.first_member,
            tile_first: &runner.unwritten(self.tiles as usize + 1),
        };
        runner.run(&kernel, self.tiles + 1, 1)
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<f64>> {
        // the sums end with the total, where a tile more would begin
        listed(self.first_member.iter().copied().step_by(self.words as usize))
    }
}
