//! B3. The weighted sum over a tile's members (Eq. 12), for all tiles of a batch at once: pixels along x and y, tiles
//! along z.

use glam::{UVec3, Vec2, Vec3, Vec4};

use crate::limits::MAX_MEMBERS;
use crate::project::{falloff, mahalanobis};
#[cfg(not(target_arch = "spirv"))]
use crate::splat::SPLAT;
use crate::splat::VECTORS;
use crate::tile::Tile;
use crate::tile_cells::Cells;
use organza_kernel::math::abs;
use organza_kernel::prelude::*;
#[cfg(not(target_arch = "spirv"))]
use organza_kernel::work::{NUMBER, Shape, VECTOR, Work};

/// Parameters of [`composite`].
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct CompositeParams {
    /// S, in pixels.
    pub side: u32,
    /// Members of each tile that earlier dispatches have summed up.
    pub skip: u32,
}

/// Alpha of a splat at a pixel: `sigmoid(opacity) T falloff` (Eq. 12).
///
/// The shift of Eq. 15 cancels here: the distance is taken in the image, where pixel centers are exact in f32, so that
/// it does not depend on how the image was cut.
#[inline(always)]
pub fn alpha<L: Lane>(placed: Vec4, conic: Vec4, x: L, y: L) -> L {
    let (dx, dy) = (x - L::splat(placed.x), y - L::splat(placed.y));
    let conic = Vec3::new(conic.x, conic.y, conic.z);
    L::splat(placed.z) * falloff(mahalanobis(conic, dx, dy))
}

/// Whether a splat's support may reach pixels of a row, whose centers lie in `[first, last]` and at height `y`.
#[inline(always)]
pub fn touches(placed: Vec4, conic: Vec4, first: f32, last: f32, y: f32) -> bool {
    let beside = first - placed.x > placed.w || placed.x - last > placed.w;
    !(beside || abs(y - placed.y) > conic.w)
}

/// Center of a tile's pixel, in the image.
#[inline(always)]
pub fn pixel_center(tile: &Tile, column: u32, row: u32) -> Vec2 {
    Vec2::new(
        (tile.origin[0] + column as i32) as f32 + 0.5,
        (tile.origin[1] + row as i32) as f32 + 0.5,
    )
}

/// Planes of a tile's sums: the channels of C, then S.
pub const SUM_PLANES: u32 = 4;

/// Members that a stage of [`composite`] holds.
const STAGED: usize = 64;

/// Their vectors.
const STAGED_VECTORS: usize = STAGED * VECTORS as usize;

/// The vectors of a stage's members.
#[derive(Clone, Copy)]
struct MemberSplats<'a> {
    member: Read<'a, u32>,
    splat: Read<'a, Vec4>,
    /// The first one.
    first: u32,
}

impl Source<Vec4> for MemberSplats<'_> {
    #[inline(always)]
    fn element(self, k: u32) -> Vec4 {
        self.splat.read(self.member.read(self.first + k / VECTORS) * VECTORS + k % VECTORS)
    }
}

/// The cells of a stage's members.
#[derive(Clone, Copy)]
struct MemberCells<'a> {
    cells: Read<'a, u32>,
    /// The first one.
    first: u32,
}

impl Source<u32> for MemberCells<'_> {
    #[inline(always)]
    fn element(self, k: u32) -> u32 {
        self.cells.read(self.first + k)
    }
}

/// What [`composite`] computes and moves. At most: every member at every pixel of its tile.
#[cfg(not(target_arch = "spirv"))]
fn composite_work(params: &CompositeParams, shape: Shape<'_>) -> Work {
    /// The binding of the members, among the storage buffers.
    const MEMBER: usize = 2;
    /// Operations of a member at a pixel.
    const COMPOSITE: u64 = 20;
    let area = u64::from(params.side).pow(2);
    // a fuller tile takes more dispatches: the first one stands for all of its members
    let members = if params.skip == 0 { shape.elements[MEMBER] } else { 0 };
    let sums = shape.layers * area * VECTOR;
    // a member's pair, cells and splat
    Work { flops: COMPOSITE * members * area, bytes: members * (2 * NUMBER + SPLAT) + 2 * sums }
}

/// Adds up to [`MAX_MEMBERS`] members to `sum [tiles, 4, S, S]`, which holds (C, S) of Eq. 12.
///
/// The members of tile t are `tile_first[t] .. tile_first[t + 1]`, in ascending order; `cells [members]` as
/// [`tile_cells`](crate::tile_cells::tile_cells()) writes them.
#[kernel(threads(16, 4), iterations = MAX_MEMBERS + MAX_MEMBERS / 8, lanes(side), work(composite_work))]
pub fn composite<L: Lane>(
    id: Invocation,
    params: &CompositeParams,
    tile: Read<i32>,
    tile_first: Read<u32>,
    member: Read<u32>,
    cells: Read<u32>,
    splat: Read<Vec4>,
    sum: Write<f32>,
    near_cells: &mut impl Stage<u32, STAGED>,
    near_splats: &mut impl Stage<Vec4, STAGED_VECTORS>,
) {
    let place = id.global();
    let inside = place.x < params.side && place.y < params.side;
    if near_cells.is_shared() || inside {
        let place = if inside { place } else { UVec3::ZERO };
        let t = id.workgroup.z;
        let first = pixel_center(&Tile::read(tile, t), place.x, place.y);
        let last = first.x + (L::WIDTH - 1) as f32;
        let (x, y) = (L::splat(first.x) + L::ramp(), L::splat(first.y));
        let begin = tile_first.read(t) + params.skip;
        let all = tile_first.read(t + 1);
        let end = if all < begin + MAX_MEMBERS { all } else { begin + MAX_MEMBERS };
        let area = params.side * params.side;
        let at = t * SUM_PLANES * area + place.y * params.side + place.x;
        let mut red = L::read_written(sum, at);
        let mut green = L::read_written(sum, at + area);
        let mut blue = L::read_written(sum, at + 2 * area);
        let mut weight = L::read_written(sum, at + 3 * area);
        let cell = Cells::of(params.side).bit(place.x, place.y);
        let mut next = begin;
        while next < end {
            let pass_end = near_cells.end(next, end, 1);
            near_cells.wait(id);
            near_cells.fill(id, pass_end - next, MemberCells { cells, first: next });
            let source = MemberSplats { member, splat, first: next };
            near_splats.fill(id, (pass_end - next) * VECTORS, source);
            near_cells.wait(id);
            let mut k = 0;
            while next < pass_end {
                if near_cells.at(k, cells, next) & cell != 0 {
                    let (near, far) = (k * VECTORS, member.read(next) * VECTORS);
                    let placed = near_splats.at(near, splat, far);
                    let conic = near_splats.at(near + 1, splat, far + 1);
                    if touches(placed, conic, first.x, last, first.y) {
                        let a = alpha(placed, conic, x, y);
                        let c = near_splats.at(near + 2, splat, far + 2);
                        red = red + a * L::splat(c.x);
                        green = green + a * L::splat(c.y);
                        blue = blue + a * L::splat(c.z);
                        weight = weight + a;
                    }
                }
                k += 1;
                next += 1;
            }
        }
        if inside {
            red.write(sum, at);
            green.write(sum, at + area);
            blue.write(sum, at + 2 * area);
            weight.write(sum, at + 3 * area);
        }
    }
}
