//! Cases of `tile_mask`, `tile_fill` and `tile_range`.

use glam::Vec4;
use muslin_check::prelude::*;
use organza_shaders::project::{BEHIND, DEGENERATE};
use organza_shaders::tile::{
    Tile, TileFillInputs, TileFillParams, TileMaskInputs, TileMaskParams, TileRangeInputs,
    TileRangeParams,
};

use super::exact::bits;
use super::exact::tile::reaches;
use super::pair::{mask, mask_sets, scanned};

/// Tiles as they lie in a buffer.
pub fn pack(tiles: &[Tile]) -> Vec<i32> {
    tiles.iter().flat_map(Tile::pack).collect()
}

/// Tiles of two cameras: within the image, over its corner, far outside.
fn tiles() -> [Tile; 4] {
    let tile = |camera, origin, output| Tile { camera, origin, output };
    [
        tile(0, [0, 0], 2),
        tile(0, [-17, 30], 0),
        tile(0, [1 << 20, -(1 << 20)], 1),
        tile(1, [100, 75], 3),
    ]
}

case!(pub TileMask(TileMaskInputs));

impl TileMask {
    fn new(gaussians: u32, side: u32, fill: Fill) -> Self {
        let mut random = Random::new(u64::from(gaussians * 1000 + side));
        let slots = 2 * gaussians as usize;
        let x = fill.values(&mut random, slots, [-60.0, 200.0], 1e30);
        let y = fill.values(&mut random, slots, [-60.0, 200.0], 1e30);
        let r = fill.values(&mut random, slots, [0.0, 60.0], 1e30);
        let tiles = tiles();
        let mut projection = Vec::with_capacity(2 * slots);
        for slot in 0..slots {
            let radius = match random.below(8) {
                0 => BEHIND,
                1 => DEGENERATE,
                _ => r[slot].abs(),
            };
            let mut place = Vec4::new(x[slot], y[slot], radius, 0.0);
            let camera = slot as u32 / gaussians;
            let mut of_camera = tiles.iter().filter(|tile| tile.camera == camera);
            // rounding must not decide whether it is an intersection
            if of_camera.any(|tile| reaches(place, tile, side).is_none()) {
                place.z = BEHIND;
            }
            // nothing may depend on the conic
            projection.extend([place, Vec4::splat(f32::NAN)]);
        }
        let words = gaussians.div_ceil(32);
        let len = tiles.len() * words as usize;
        Self(TileMaskInputs {
            params: TileMaskParams { gaussians, words, side },
            tile: pack(&tiles),
            projection,
            mask: unwritten(len),
            count: unwritten(len),
        })
    }
}

impl Parity for TileMask {
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

    /// The Gaussians within reach.
    fn exact(&self, output: &str, _: usize) -> Vec<Option<Rounded>> {
        let word = |tile: &Tile, word: u32| {
            let mut mask = 0_u32;
            for bit in 0..32.min(self.params.gaussians - 32 * word) {
                let slot = tile.camera * self.params.gaussians + 32 * word + bit;
                let p = self.projection[2 * slot as usize];
                // squares of more are no f32: such a Gaussian may intersect any tile
                if p.truncate().abs().max_element() >= 1e18 {
                    return Rounded::UNKNOWN;
                }
                let intersects = reaches(p, tile, self.params.side);
                mask |= u32::from(intersects.expect("it leaves the margin")) << bit;
            }
            Rounded::from(if output == "mask" { mask } else { mask.count_ones() })
        };
        let words = 0..self.params.words;
        listed(tiles().iter().flat_map(|tile| words.clone().map(|at| word(tile, at))))
    }
}

case!(pub TileFill(TileFillInputs));

impl Parity for TileFill {
    fn sets() -> Vec<(String, Self)> {
        mask_sets(|words, bits, random| {
            let tiles = tiles();
            let tile_mask = mask(tiles.len() as u32 * words, bits, random);
            let mut pair_mask = vec![0; 2 * words as usize];
            for (tile, masks) in tiles.iter().zip(tile_mask.chunks(words.max(1) as usize)) {
                let first = (tile.camera * words) as usize;
                pair_mask[first..].iter_mut().zip(masks).for_each(|(pair, mask)| *pair |= mask);
            }
            let first_intersection = scanned(&tile_mask);
            Self(TileFillInputs {
                params: TileFillParams { words },
                tile: pack(&tiles),
                tile_mask,
                intersection: unwritten(first_intersection[first_intersection.len() - 1] as usize),
                first_intersection,
                first_pair: scanned(&pair_mask),
                pair_mask,
            })
        })
    }

    /// Pairs are numbered camera by camera.
    fn exact(&self, _: &str, _: usize) -> Vec<Option<Rounded>> {
        let words = self.params.words as usize;
        let gaussians = 32 * self.params.words as usize;
        let pairs: Vec<_> = bits(&self.pair_mask).collect();
        let slots = tiles().into_iter().enumerate().flat_map(|(t, tile)| {
            let first = tile.camera as usize * gaussians;
            bits(&self.tile_mask[t * words..][..words]).map(move |gaussian| first + gaussian)
        });
        let pair = |slot| pairs.binary_search(&slot).expect("intersections are pairs") as u32;
        listed(slots.map(pair))
    }
}

case!(pub TileRange(TileRangeInputs));

impl Parity for TileRange {
    fn sets() -> Vec<(String, Self)> {
        let of = |(tiles, words): (u32, u32)| {
            let mut random = Random::new(u64::from(tiles));
            let set = Self(TileRangeInputs {
                params: TileRangeParams { tiles, words },
                first_intersection: (0..=tiles * words).map(|_| random.bits()).collect(),
                tile_first: unwritten(tiles as usize + 1),
            });
            (format!("{tiles} tiles of {words} words"), set)
        };
        SIZES.into_iter().flat_map(|tiles| [1, 7].map(|words| (tiles, words))).map(of).collect()
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<Rounded>> {
        // the sums end with the total, where a tile more would begin
        listed(self.first_intersection.iter().copied().step_by(self.params.words as usize))
    }
}
