//! B3. The derivative of the weighted sums (Eq. 12): the gradient of each intersection's splat, summed over its tile's pixels.

use glam::{Vec3, Vec4};

use crate::composite::SUM_PLANES;
use crate::limits::MAX_BAND;
use crate::project::{falloff, in_support, mahalanobis};
use crate::shape::{Shaped, flatness_slope};
use crate::slope::{SLOPE_GRADIENT_VECTORS, SLOPE_VECTORS};
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
    /// See [`CompositeParams::sloped`](crate::composite::CompositeParams::sloped).
    pub sloped: u32,
    /// See [`SplatParams::shaped`](crate::splat::SplatParams::shaped).
    pub shaped: u32,
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
/// With h = falloff dL/dalpha, sums of h, and of `h d` and `h d d^T` for the distances d of pixels from the center; where falloffs have
/// shapes, the latter times `d ln(falloff) / d ln(f)`, f the falloff without a shape.
#[derive(Clone, Copy)]
struct Moments {
    /// h, h dx, h dy
    first: Vec3,
    /// h dx dx, h dx dy, h dy dy
    second: Vec3,
    /// falloff dL/dC, and `dfalloff/dk dL/dalpha`, k the flatness
    color: Vec4,
    /// falloff dL/dC dx; 0 where colors do not vary
    along_x: Vec3,
    /// falloff dL/dC dy, likewise
    along_y: Vec3,
}

/// An intersection's splat, and how its color grows along x and y: 0 where it does not. Likewise its flatness.
type Varied = [Vec4; 5];

/// Sums over `blocks` of `L::WIDTH` columns from `column` on, of the rows of a span; `at` is the tile's first value
/// of `gradient [tiles, 4, S, S]`.
#[loops]
#[inline(always)]
#[allow(clippy::too_many_arguments)]
fn moments<L: Lane, const VARIED: bool>(
    gradient: Read<f32>,
    at: u32,
    side: u32,
    rows: Span,
    column: u32,
    blocks: u32,
    origin: [i32; 2],
    splat: Varied,
) -> Moments {
    let [placed, conic, color, along_x, along_y] = splat;
    let conic = Vec3::new(conic.x, conic.y, conic.z);
    let area = side * side;
    let zero = L::splat(0.0);
    let step = L::splat(L::WIDTH as f32);
    let left = L::splat((origin[0] + column as i32) as f32 + 0.5) + L::ramp();
    let mut red = zero;
    let mut green = zero;
    let mut blue = zero;
    let mut flatness = zero;
    let mut weight = zero;
    let mut h = zero;
    let mut hx = zero;
    let mut hy = zero;
    let mut hxx = zero;
    let mut hxy = zero;
    let mut hyy = zero;
    let mut all_x = [zero; 3];
    let mut all_y = [zero; 3];
    let mut row = rows.begin;
    while row < rows.end {
        let below = (origin[1] + row as i32) as f32 + 0.5 - placed.y;
        let dy = L::splat(below);
        let row_color = if VARIED { color + along_y * below } else { color };
        let mut row_weight = zero;
        let mut row_h = zero;
        let mut row_hx = zero;
        let mut row_red = zero;
        let mut row_green = zero;
        let mut row_blue = zero;
        let mut next = at + row * side + column;
        let end = next + blocks * L::WIDTH;
        let mut x = left;
        while next < end {
            let dx = x - L::splat(placed.x);
            let q = mahalanobis(conic, dx, dy);
            let mut f = falloff(q);
            let reached = in_support(q);
            let r = L::read(gradient, next);
            let g = L::read(gradient, next + area);
            let b = L::read(gradient, next + 2 * area);
            let s = L::read(gradient, next + 3 * area);
            let mut of_red = L::splat(row_color.x);
            let mut of_green = L::splat(row_color.y);
            let mut of_blue = L::splat(row_color.z);
            if VARIED {
                of_red = of_red + L::splat(along_x.x) * dx;
                of_green = of_green + L::splat(along_x.y) * dx;
                of_blue = of_blue + L::splat(along_x.z) * dx;
            }
            let by_alpha = r * of_red + g * of_green + b * of_blue + s;
            // a falloff of 0 makes NaN of what is not finite
            let mut by_distance = L::select(reached, f * by_alpha, zero);
            if VARIED {
                let shaped = Shaped::new(f, color.w);
                by_distance = by_distance * shaped.by_falloff;
                f = shaped.value;
                row_weight = row_weight + L::select(reached, f * by_alpha, zero);
                let by_flatness = L::select(reached, shaped.by_flatness * by_alpha, zero);
                flatness = flatness + by_flatness;
            }
            let by_x = by_distance * dx;
            red = L::select(reached, red + f * r, red);
            green = L::select(reached, green + f * g, green);
            blue = L::select(reached, blue + f * b, blue);
            if VARIED {
                let by_red = L::select(reached, f * r, zero);
                let by_green = L::select(reached, f * g, zero);
                let by_blue = L::select(reached, f * b, zero);
                row_red = row_red + by_red;
                row_green = row_green + by_green;
                row_blue = row_blue + by_blue;
                let [x, y, z] = all_x;
                all_x = [x + by_red * dx, y + by_green * dx, z + by_blue * dx];
            }
            row_h = row_h + by_distance;
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
        if VARIED {
            weight = weight + row_weight;
            let [x, y, z] = all_y;
            all_y = [x + row_red * dy, y + row_green * dy, z + row_blue * dy];
        }
        row += 1;
    }
    let weight = if VARIED { weight } else { h };
    Moments {
        first: Vec3::new(weight.sum(), hx.sum(), hy.sum()),
        second: Vec3::new(hxx.sum(), hxy.sum(), hyy.sum()),
        color: Vec4::new(red.sum(), green.sum(), blue.sum(), flatness.sum()),
        along_x: Vec3::new(all_x[0].sum(), all_x[1].sum(), all_x[2].sum()),
        along_y: Vec3::new(all_y[0].sum(), all_y[1].sum(), all_y[2].sum()),
    }
}

/// Sums over the pixels that an intersection's support may reach, and over their neighbors in the same rows, which add nothing.
#[inline(always)]
fn all_moments<L: Lane, const VARIED: bool>(
    gradient: Read<f32>,
    at: u32,
    side: u32,
    rows: Span,
    columns: Span,
    origin: [i32; 2],
    splat: Varied,
) -> Moments {
    // whole blocks, moved to the left where they would end past the row
    let wanted = (columns.end - columns.begin).div_ceil(L::WIDTH);
    let fitting = side / L::WIDTH;
    let blocks = if wanted < fitting { wanted } else { fitting };
    let max = side - blocks * L::WIDTH;
    let begin = if columns.begin < max { columns.begin } else { max };
    let mut sum = moments::<L, VARIED>(gradient, at, side, rows, begin, blocks, origin, splat);
    let end = begin + blocks * L::WIDTH;
    if L::WIDTH > 1 && end < columns.end {
        let rest = columns.end - end;
        let more = moments::<L::One, VARIED>(gradient, at, side, rows, end, rest, origin, splat);
        sum = Moments {
            first: sum.first + more.first,
            second: sum.second + more.second,
            color: sum.color + more.color,
            along_x: sum.along_x + more.along_x,
            along_y: sum.along_y + more.along_y,
        };
    }
    sum
}

/// Adds to `intersection_gradient [intersections, 3]` the gradient of each intersection's splat from some rows of its tile, given
/// `sum_gradient [tiles, 4, S, S]`, dL/dC and dL/dS: `(d mean2d x, y, d weight, 0), (d conic xx, xy, yy, 0),
/// (d color, d shape)`. Where colors vary, also adds to `intersection_slope [intersections, 2]` the gradient of their growth along x and
/// y, and `slope [pairs, 4]` is as [`slope`](crate::slope::slope()) writes it.
///
/// The derivative of Eq. 12: with `alpha = weight falloff(q)`, `dL/dalpha = dL/dC . c + dL/dS`, and
/// `dL/dq = -alpha/2 dL/dalpha` where the falloff is not 0, for one without a shape. The weight is the one before its [`Compensation`], which depends on
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
    slope: Read<Vec4>,
    sum_gradient: Read<f32>,
    intersection_gradient: Write<Vec4>,
    intersection_slope: Write<Vec4>,
) {
    let index = id.index();
    if index < params.intersections {
        let t = owner(tile_first, params.tiles, index);
        let [x, y] = Tile::read(tile, t).origin;
        let pair = intersection.read(index);
        let vector = pair * VECTORS;
        let placed = splat.read(vector);
        let conic = splat.read(vector + 1);
        let mut color = splat.read(vector + 2);
        let side = params.side;
        let columns = Span::new(placed.x, placed.w, x, 0, side);
        let last_row = params.first_row + params.rows;
        let rows = Span::new(placed.y, conic.w, y, params.first_row, last_row);
        if columns.begin < columns.end && rows.begin < rows.end {
            let at = t * SUM_PLANES * side * side;
            let origin = [x, y];
            let gradient = sum_gradient;
            let mut along_x = Vec4::ZERO;
            let mut along_y = Vec4::ZERO;
            if params.sloped != 0 {
                along_x = slope.read(pair * SLOPE_VECTORS);
                along_y = slope.read(pair * SLOPE_VECTORS + 1);
            }
            if params.shaped == 0 {
                color.w = 0.0;
            }
            let mut sum = if params.sloped | params.shaped != 0 {
                let splat = [placed, conic, color, along_x, along_y];
                all_moments::<L, true>(gradient, at, side, rows, columns, origin, splat)
            } else {
                let splat = [placed, conic, color, along_x, along_y];
                all_moments::<L, false>(gradient, at, side, rows, columns, origin, splat)
            };
            sum.color.w =
                if params.shaped != 0 { sum.color.w * flatness_slope(color.w) } else { 0.0 };
            // dq/dmean2d = -2 conic d
            let hx = sum.first.y;
            let hy = sum.first.z;
            let weight = placed.z;
            let conic = Vec3::new(conic.x, conic.y, conic.z);
            let compensation = Compensation::new(conic, params.compensated_blur);
            let mut geometry = Vec4::new(
                weight * (conic.x * hx + conic.y * hy),
                weight * (conic.y * hx + conic.z * hy),
                sum.first.x * compensation.factor,
                0.0,
            );
            let mut shape = Vec3::new(-0.5, -1.0, -0.5) * sum.second * weight;
            if params.compensated_blur > 0.0 {
                shape += compensation.log_slope * (sum.first.x * weight);
            }
            if params.sloped != 0 {
                // a center that moves takes the color with it
                let by_color = (sum.color.truncate() * weight).extend(0.0);
                geometry.x -= along_x.dot(by_color);
                geometry.y -= along_y.dot(by_color);
                let first = index * SLOPE_GRADIENT_VECTORS;
                let before = intersection_slope.read(first);
                intersection_slope.write(first, before + (sum.along_x * weight).extend(0.0));
                let before = intersection_slope.read(first + 1);
                intersection_slope.write(first + 1, before + (sum.along_y * weight).extend(0.0));
            }
            let first = index * VECTORS;
            let before = intersection_gradient.read(first);
            intersection_gradient.write(first, before + geometry);
            let before = intersection_gradient.read(first + 1);
            intersection_gradient.write(first + 1, before + shape.extend(0.0));
            let before = intersection_gradient.read(first + 2);
            intersection_gradient.write(first + 2, before + sum.color * weight);
        }
    }
}
