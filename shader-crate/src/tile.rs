//! C. Which Gaussians reach which tiles (Eq. 14-15).
//!
//! Intersections are bits: word w of a tile holds the Gaussians 32 w .. 32 w + 31. Counting the bits, scanning
//! the counts and writing out the bits gives every tile's intersections in ascending order by construction, with
//! no atomics and no sorting.

use glam::{Vec2, Vec4};

use muslin::math::clamp;
use muslin::prelude::*;

/// A tile as kernels see it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tile {
    /// Index of the camera in the part.
    pub camera: u32,
    /// `o_t`, in pixels.
    pub origin: [i32; 2],
    /// Index in the rendered batch: kernels see tiles ordered by camera.
    pub output: u32,
}

impl Tile {
    /// Integers that a tile takes in a buffer.
    pub const INTEGERS: usize = 4;

    /// The tile as it lies in a buffer; [`Tile::read`] is its counterpart.
    pub fn pack(&self) -> [i32; Self::INTEGERS] {
        [self.camera as i32, self.origin[0], self.origin[1], self.output as i32]
    }

    /// The tile at `index` of a buffer of packed tiles.
    #[inline(always)]
    pub fn read(tiles: Read<i32>, index: u32) -> Self {
        let first = index * Self::INTEGERS as u32;
        Self {
            camera: tiles.read(first) as u32,
            origin: [tiles.read(first + 1), tiles.read(first + 2)],
            output: tiles.read(first + 3) as u32,
        }
    }

    /// Center of a pixel of the tile, in the image.
    #[inline(always)]
    pub fn pixel_center(&self, column: u32, row: u32) -> Vec2 {
        let [x, y] = self.origin;
        Vec2::new((x + column as i32) as f32 + 0.5, (y + row as i32) as f32 + 0.5)
    }
}

/// `dist(x, B_t)` squared, to the closed box `[low, low + side]`.
#[inline(always)]
pub fn distance_squared(x: Vec2, low: Vec2, side: f32) -> f32 {
    let d = Vec2::new(x.x - clamp(x.x, low.x, low.x + side), x.y - clamp(x.y, low.y, low.y + side));
    d.x * d.x + d.y * d.y
}

/// Eq. 15, with a margin for the rounding of f32.
///
/// Where q is at most the cutoff, the falloff is not zero. In any tiling, the Gaussian must then intersect the
/// pixel's tile. An intersection that is not needed adds exact zeros.
#[inline(always)]
pub fn reaches(mean2d: Vec2, radius: f32, low: Vec2, side: f32) -> bool {
    let r = radius * 1.001 + 0.01;
    radius >= 0.0 && distance_squared(mean2d, low, side) <= r * r
}

/// Parameters of [`tile_mask`].
#[params]
pub struct TileMaskParams {
    /// Gaussians of the scene.
    pub gaussians: u32,
    /// Words of a tile's mask: a bit for each Gaussian.
    pub words: u32,
    /// S, in pixels.
    pub side: u32,
}

/// `mask [tiles, words]` and the number of bits in each of its words, `count [tiles, words]`: words along x and y,
/// tiles along z.
#[kernel(threads(64), over(params.words, tile.len() / 4), iterations = u32::BITS)]
pub fn tile_mask(
    id: Invocation,
    params: &TileMaskParams,
    tile: Read<i32>,
    projection: Read<Vec4>,
    mask: Write<u32>,
    count: Write<u32>,
) {
    let word = id.index();
    if word < params.words {
        let t = id.workgroup.z;
        let tile = Tile::read(tile, t);
        let low = Vec2::new(tile.origin[0] as f32, tile.origin[1] as f32);
        let side = params.side as f32;
        let slot = tile.camera * params.gaussians;
        let mut bits = 0;
        let mut bit = 0;
        while bit < 32 {
            let gaussian = word * 32 + bit;
            if gaussian < params.gaussians {
                let p = projection.read(2 * (slot + gaussian));
                if reaches(Vec2::new(p.x, p.y), p.z, low, side) {
                    bits |= 1 << bit;
                }
            }
            bit += 1;
        }
        mask.write(t * params.words + word, bits);
        count.write(t * params.words + word, bits.count_ones());
    }
}

/// Parameters of [`tile_fill`].
#[params]
pub struct TileFillParams {
    /// Words of a tile's mask.
    pub words: u32,
}

/// Writes the intersections of every tile, as indices of pairs: words along x and y, tiles along z.
///
/// `first_intersection [tiles, words]` and `first_pair [cameras, words]` are the scans of the counts.
#[kernel(threads(64), over(params.words, tile.len() / 4), iterations = u32::BITS)]
pub fn tile_fill(
    id: Invocation,
    params: &TileFillParams,
    tile: Read<i32>,
    tile_mask: Read<u32>,
    first_intersection: Read<u32>,
    pair_mask: Read<u32>,
    first_pair: Read<u32>,
    intersection: Write<u32>,
) {
    let word = id.index();
    if word < params.words {
        let t = id.workgroup.z;
        let bits = tile_mask.read(t * params.words + word);
        let camera_word = Tile::read(tile, t).camera * params.words + word;
        let camera_bits = pair_mask.read(camera_word);
        let pair = first_pair.read(camera_word);
        let mut next = first_intersection.read(t * params.words + word);
        let mut bit = 0;
        while bit < 32 {
            if (bits >> bit) & 1 != 0 {
                let below = camera_bits & ((1 << bit) - 1);
                intersection.write(next, pair + below.count_ones());
                next += 1;
            }
            bit += 1;
        }
    }
}

/// Parameters of [`tile_range`].
#[params]
pub struct TileRangeParams {
    /// Tiles of the part.
    pub tiles: u32,
    /// Words of a tile's mask.
    pub words: u32,
}

/// Where the intersections of every tile begin: `tile_first [tiles + 1]`, from `first_intersection [tiles * words + 1]`, whose last
/// value is the total.
#[kernel(threads(64), over(params.tiles + 1))]
pub fn tile_range(
    id: Invocation,
    params: &TileRangeParams,
    first_intersection: Read<u32>,
    tile_first: Write<u32>,
) {
    let tile = id.index();
    if tile <= params.tiles {
        tile_first.write(tile, first_intersection.read(tile * params.words));
    }
}
