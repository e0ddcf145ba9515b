//! B3. The weighted sum over a tile's intersections (Eq. 12), for all tiles of a part at once: pixels along x and y, tiles
//! along z.

use glam::{UVec3, Vec3, Vec4};

use crate::limits::MAX_INTERSECTIONS;
use crate::project::{falloff, in_support, mahalanobis};
use crate::shape::shaped_falloff;
use crate::slope::SLOPE_VECTORS;
use crate::splat::VECTORS;
use crate::tile::Tile;
use crate::tile_cells::{Cells, touches};
use muslin::prelude::*;

/// Parameters of [`composite`].
#[params]
pub struct CompositeParams {
    /// S, in pixels.
    pub side: u32,
    /// Intersections of each tile that earlier dispatches have summed up.
    pub skip: u32,
    /// 1 where colors vary within a Gaussian.
    pub sloped: u32,
    /// See [`SplatParams::shaped`](crate::splat::SplatParams::shaped).
    pub shaped: u32,
}

/// Squared Mahalanobis distance of a pixel from a splat's center.
///
/// The shift of Eq. 15 cancels here: the distance is taken in the image, where pixel centers are exact in f32, so that
/// it does not depend on how the image was cut.
#[inline(always)]
pub fn splat_distance<L: Lane>(placed: Vec4, conic: Vec4, x: L, y: L) -> L {
    let dx = x - L::splat(placed.x);
    let dy = y - L::splat(placed.y);
    mahalanobis(Vec3::new(conic.x, conic.y, conic.z), dx, dy)
}

/// Alpha of a splat at a distance: `sigmoid(opacity) T falloff` (Eq. 12), where the falloff may have a [shape](crate::shape).
///
/// Where the pixel does not lie [in its support](in_support), add nothing: a weight or a color that is not finite makes NaN
/// even of a falloff of 0.
#[inline(always)]
pub fn alpha<L: Lane>(placed: Vec4, color: Vec4, is_shaped: bool, q: L) -> L {
    let f = if is_shaped { shaped_falloff(q, color.w) } else { falloff(q) };
    L::splat(placed.z) * f
}

/// Planes of a tile's sums: the channels of C, then S.
pub const SUM_PLANES: u32 = 4;

/// Intersections that [`composite`] copies to workgroup memory at once.
const SHARED_INTERSECTIONS: usize = 64;

/// Vectors of their splats.
const SHARED_VECTORS: usize = SHARED_INTERSECTIONS * VECTORS as usize;

/// The splats of a tile's intersections.
#[derive(Clone, Copy)]
struct IntersectionSplats<'a> {
    intersection: Read<'a, u32>,
    splat: Read<'a, Vec4>,
    /// The first intersection.
    first: u32,
}

impl Source<Vec4> for IntersectionSplats<'_> {
    const ELEMENTS: u32 = VECTORS;

    #[inline(always)]
    #[cfg_attr(not(target_arch = "spirv"), track_caller)]
    fn offset(self, item: u32) -> u32 {
        self.intersection.read(self.first + item) * VECTORS
    }

    #[inline(always)]
    #[cfg_attr(not(target_arch = "spirv"), track_caller)]
    fn element(self, offset: u32) -> Vec4 {
        self.splat.read(offset)
    }
}

/// The cells of a tile's intersections.
#[derive(Clone, Copy)]
struct IntersectionCells<'a> {
    cells: Read<'a, u32>,
    /// The first intersection.
    first: u32,
}

impl Source<u32> for IntersectionCells<'_> {
    const ELEMENTS: u32 = 1;

    #[inline(always)]
    fn offset(self, item: u32) -> u32 {
        self.first + item
    }

    #[inline(always)]
    #[cfg_attr(not(target_arch = "spirv"), track_caller)]
    fn element(self, offset: u32) -> u32 {
        self.cells.read(offset)
    }
}

/// Adds up to [`MAX_INTERSECTIONS`] intersections to `sum [tiles, 4, S, S]`, which holds (C, S) of Eq. 12.
///
/// The intersections of tile t are `tile_first[t] .. tile_first[t + 1]`, in ascending order; `cells [intersections]` as
/// [`tile_cells`](crate::tile_cells::tile_cells()) writes them; `slope [pairs, 4]` as [`slope`](crate::slope::slope()) does,
/// read only if colors vary.
#[kernel(threads(16, 4), over(params.side, params.side, tile.len() / 4), iterations = MAX_INTERSECTIONS + MAX_INTERSECTIONS / 8, lanes(side))]
pub fn composite<L: Lane>(
    id: Invocation,
    params: &CompositeParams,
    tile: Read<i32>,
    tile_first: Read<u32>,
    intersection: Read<u32>,
    cells: Read<u32>,
    splat: Read<Vec4>,
    slope: Read<Vec4>,
    sum: Write<f32>,
    shared_cells: &mut impl SharedTile<u32, SHARED_INTERSECTIONS>,
    shared_splats: &mut impl SharedTile<Vec4, SHARED_VECTORS>,
) {
    let place = id.global();
    let inside = place.x < params.side && place.y < params.side;
    if shared_cells.is_shared() || inside {
        let place = if inside { place } else { UVec3::ZERO };
        let t = id.workgroup.z;
        let first = Tile::read(tile, t).pixel_center(place.x, place.y);
        let last = first.x + (L::WIDTH - 1) as f32;
        let x = L::splat(first.x) + L::ramp();
        let y = L::splat(first.y);
        let begin = tile_first.read(t) + params.skip;
        let all = tile_first.read(t + 1);
        let end = if all < begin + MAX_INTERSECTIONS { all } else { begin + MAX_INTERSECTIONS };
        let area = params.side * params.side;
        let at = t * SUM_PLANES * area + place.y * params.side + place.x;
        let zero = L::splat(0.0);
        let mut red = zero;
        let mut green = zero;
        let mut blue = zero;
        let mut weight = zero;
        // an invocation without a pixel copies for the others, and has no sums
        if inside {
            red = L::read_written(sum, at);
            green = L::read_written(sum, at + area);
            blue = L::read_written(sum, at + 2 * area);
            weight = L::read_written(sum, at + 3 * area);
        }
        let cell = Cells::new(params.side).bit(place.x, place.y);
        let mut next = begin;
        while next < end {
            let cells = IntersectionCells { cells, first: next };
            let splats = IntersectionSplats { intersection, splat, first: next };
            let intersections = shared_cells.capacity(cells, end - next);
            shared_cells.wait(id);
            shared_cells.fill(id, intersections, cells);
            shared_splats.fill(id, intersections, splats);
            shared_cells.wait(id);
            let mut k = 0;
            while k < intersections {
                if shared_cells.element(shared_cells.offset(k, cells), cells) & cell != 0 {
                    let offset = shared_splats.offset(k, splats);
                    let placed = shared_splats.element(offset, splats);
                    let conic = shared_splats.element(offset + 1, splats);
                    if touches(placed, conic, first.x, last, first.y) {
                        let q = splat_distance(placed, conic, x, y);
                        let c = shared_splats.element(offset + 2, splats);
                        let a = alpha(placed, c, params.shaped != 0, q);
                        let mut r = L::splat(c.x);
                        let mut g = L::splat(c.y);
                        let mut b = L::splat(c.z);
                        if params.sloped != 0 {
                            let at = intersection.read(next + k) * SLOPE_VECTORS;
                            let along_x = slope.read(at);
                            let row = c + slope.read(at + 1) * (first.y - placed.y);
                            let dx = x - L::splat(placed.x);
                            r = L::splat(row.x) + L::splat(along_x.x) * dx;
                            g = L::splat(row.y) + L::splat(along_x.y) * dx;
                            b = L::splat(row.z) + L::splat(along_x.z) * dx;
                        }
                        red = red + L::select(in_support(q), a * r, zero);
                        green = green + L::select(in_support(q), a * g, zero);
                        blue = blue + L::select(in_support(q), a * b, zero);
                        weight = weight + L::select(in_support(q), a, zero);
                    }
                }
                k += 1;
            }
            next += intersections;
        }
        if inside {
            red.write(sum, at);
            green.write(sum, at + area);
            blue.write(sum, at + 2 * area);
            weight.write(sum, at + 3 * area);
        }
    }
}
