//! B3. The derivative of the weighted sums (Eq. 12): the gradient of each intersection's splat, summed over its tile's pixels.

use glam::{Vec3, Vec4};

use crate::composite::SUM_PLANES;
use crate::limits::MAX_BAND;
use crate::project::{falloff, in_support, mahalanobis};
use crate::splat::{Compensation, VECTORS};
use crate::tile::Tile;
use crate::transmittance::owner;
use muslin::math::{ceil, clamp};
use muslin::prelude::*;

/// Parameters of [`composite_backward`].
#[params]
pub struct CompositeBackwardParams {
    /// Intersections of all tiles.
    pub intersections: u32,
    /// Tiles of the part.
    pub tiles: u32,
    /// S, in pixels.
    pub side: u32,
    /// First row of the tiles that this dispatch sums over.
    pub first_row: u32,
    /// Rows that it sums over: at most [`band_rows`].
    pub rows: u32,
    /// See [`SplatParams::compensated_blur`](crate::splat::SplatParams::compensated_blur).
    pub compensated_blur: f32,
}

/// Rows that one dispatch of [`composite_backward`] may sum over, for tiles of a side: an invocation takes a step for
/// each of their pixels at most, and one for each row.
#[inline(always)]
pub fn band_rows(side: u32) -> u32 {
    MAX_BAND / (side + 1)
}

/// Pixels along one axis of a tile, from its first on.
#[derive(Clone, Copy)]
struct Span {
    begin: u32,
    end: u32,
}

impl Span {
    /// The pixels of `begin .. end` whose centers lie within `extent` of `center`; the extent's margin is wider than
    /// the rounding here.
    #[inline(always)]
    fn new(center: f32, extent: f32, origin: i32, begin: u32, end: u32) -> Self {
        let low = begin as f32;
        let high = end as f32;
        let first = clamp(ceil(center - extent - origin as f32 - 0.5), low, high);
        let last = clamp(center + extent - origin as f32 + 0.5, low, high);
        Self { begin: first as u32, end: last as u32 }
    }
}

/// The sums over an intersection's pixels.
///
/// With h = falloff dL/dalpha, sums of h, of `h d` and of `h d d^T` for the distances d of pixels from the center.
#[derive(Clone, Copy)]
struct Moments {
    /// h, h dx, h dy
    first: Vec3,
    /// h dx dx, h dx dy, h dy dy
    second: Vec3,
    /// falloff dL/dC
    color: Vec3,
}

/// Sums over `blocks` of `L::WIDTH` columns from `column` on, of the rows of a span; `at` is the tile's first value
/// of `gradient [tiles, 4, S, S]`.
#[loops]
#[inline(always)]
#[allow(clippy::too_many_arguments)]
fn moments<L: Lane>(
    gradient: Read<f32>,
    at: u32,
    side: u32,
    rows: Span,
    column: u32,
    blocks: u32,
    origin: [i32; 2],
    splat: [Vec4; 3],
) -> Moments {
    let [placed, conic, color] = splat;
    let conic = Vec3::new(conic.x, conic.y, conic.z);
    let area = side * side;
    let zero = L::splat(0.0);
    let step = L::splat(L::WIDTH as f32);
    let left = L::splat((origin[0] + column as i32) as f32 + 0.5) + L::ramp();
    let mut red = zero;
    let mut green = zero;
    let mut blue = zero;
    let mut h = zero;
    let mut hx = zero;
    let mut hy = zero;
    let mut hxx = zero;
    let mut hxy = zero;
    let mut hyy = zero;
    let mut row = rows.begin;
    while row < rows.end {
        let dy = L::splat((origin[1] + row as i32) as f32 + 0.5 - placed.y);
        let mut row_h = zero;
        let mut row_hx = zero;
        let mut next = at + row * side + column;
        let end = next + blocks * L::WIDTH;
        let mut x = left;
        while next < end {
            let dx = x - L::splat(placed.x);
            let q = mahalanobis(conic, dx, dy);
            let f = falloff(q);
            let reached = in_support(q);
            let r = L::read(gradient, next);
            let g = L::read(gradient, next + area);
            let b = L::read(gradient, next + 2 * area);
            let s = L::read(gradient, next + 3 * area);
            let by_alpha =
                r * L::splat(color.x) + g * L::splat(color.y) + b * L::splat(color.z) + s;
            // a falloff of 0 makes NaN of what is not finite
            let by_weight = L::select(reached, f * by_alpha, zero);
            let by_x = by_weight * dx;
            red = L::select(reached, red + f * r, red);
            green = L::select(reached, green + f * g, green);
            blue = L::select(reached, blue + f * b, blue);
            row_h = row_h + by_weight;
            row_hx = row_hx + by_x;
            hxx = hxx + by_x * dx;
            x = x + step;
            next += L::WIDTH;
        }
        h = h + row_h;
        hx = hx + row_hx;
        hy = hy + row_h * dy;
        hxy = hxy + row_hx * dy;
        hyy = hyy + row_h * dy * dy;
        row += 1;
    }
    Moments {
        first: Vec3::new(h.sum(), hx.sum(), hy.sum()),
        second: Vec3::new(hxx.sum(), hxy.sum(), hyy.sum()),
        color: Vec3::new(red.sum(), green.sum(), blue.sum()),
    }
}

/// Sums over the pixels that an intersection's support may reach, and over their neighbors in the same rows, which add nothing.
#[inline(always)]
fn all_moments<L: Lane>(
    gradient: Read<f32>,
    at: u32,
    side: u32,
    rows: Span,
    columns: Span,
    origin: [i32; 2],
    splat: [Vec4; 3],
) -> Moments {
    // whole blocks, moved to the left where they would end past the row
    let wanted = (columns.end - columns.begin).div_ceil(L::WIDTH);
    let fitting = side / L::WIDTH;
    let blocks = if wanted < fitting { wanted } else { fitting };
    let max = side - blocks * L::WIDTH;
    let begin = if columns.begin < max { columns.begin } else { max };
    let mut sum = moments::<L>(gradient, at, side, rows, begin, blocks, origin, splat);
    let end = begin + blocks * L::WIDTH;
    if L::WIDTH > 1 && end < columns.end {
        let rest = columns.end - end;
        let more = moments::<L::One>(gradient, at, side, rows, end, rest, origin, splat);
        sum = Moments {
            first: sum.first + more.first,
            second: sum.second + more.second,
            color: sum.color + more.color,
        };
    }
    sum
}

/// Adds to `intersection_gradient [intersections, 3]` the gradient of each intersection's splat from some rows of its tile, given
/// `sum_gradient [tiles, 4, S, S]`, dL/dC and dL/dS: `(d mean2d x, y, d weight, 0), (d conic xx, xy, yy, 0),
/// (d color, 0)`.
///
/// The derivative of Eq. 12: with `alpha = weight falloff(q)`, `dL/dalpha = dL/dC . c + dL/dS`, and
/// `dL/dq = -alpha/2 dL/dalpha` where the falloff is not 0. The weight is the one before its [`Compensation`], which depends on
/// the conic. One invocation for each intersection of a tile: pixels are summed
/// in an order that nothing changes.
#[kernel(threads(64), over(params.intersections), iterations = u32::BITS + MAX_BAND, lanes, counts(intersections))]
pub fn composite_backward<L: Lane>(
    id: Invocation,
    params: &CompositeBackwardParams,
    tile: Read<i32>,
    tile_first: Read<u32>,
    intersection: Read<u32>,
    splat: Read<Vec4>,
    sum_gradient: Read<f32>,
    intersection_gradient: Write<Vec4>,
) {
    let index = id.index();
    if index < params.intersections {
        let t = owner(tile_first, params.tiles, index);
        let [x, y] = Tile::read(tile, t).origin;
        let vector = intersection.read(index) * VECTORS;
        let placed = splat.read(vector);
        let conic = splat.read(vector + 1);
        let color = splat.read(vector + 2);
        let side = params.side;
        let columns = Span::new(placed.x, placed.w, x, 0, side);
        let last_row = params.first_row + params.rows;
        let rows = Span::new(placed.y, conic.w, y, params.first_row, last_row);
        if columns.begin < columns.end && rows.begin < rows.end {
            let at = t * SUM_PLANES * side * side;
            let splat = [placed, conic, color];
            let sum = all_moments::<L>(sum_gradient, at, side, rows, columns, [x, y], splat);
            // dq/dmean2d = -2 conic d
            let hx = sum.first.y;
            let hy = sum.first.z;
            let weight = placed.z;
            let conic = Vec3::new(conic.x, conic.y, conic.z);
            let compensation = Compensation::new(conic, params.compensated_blur);
            let geometry = Vec4::new(
                weight * (conic.x * hx + conic.y * hy),
                weight * (conic.y * hx + conic.z * hy),
                sum.first.x * compensation.factor,
                0.0,
            );
            let mut shape = Vec3::new(-0.5, -1.0, -0.5) * sum.second * weight;
            if params.compensated_blur > 0.0 {
                shape += compensation.log_slope * (sum.first.x * weight);
            }
            let first = index * VECTORS;
            let before = intersection_gradient.read(first);
            intersection_gradient.write(first, before + geometry);
            let before = intersection_gradient.read(first + 1);
            intersection_gradient.write(first + 1, before + shape.extend(0.0));
            let before = intersection_gradient.read(first + 2);
            intersection_gradient.write(first + 2, before + (sum.color * weight).extend(0.0));
        }
    }
}
