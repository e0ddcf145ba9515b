//! The multiresolution hash grid of both fields (Eq. 1 and 9).

use crate::limits::MAX_FEATURES;
use crate::unit_cube::Split;
#[cfg(not(target_arch = "spirv"))]
use crate::unit_cube::leading_bits;
use muslin::prelude::*;

/// One level of a grid; the host computes it in f64, kernels never call `pow`.
#[params]
pub struct GridLevel {
    /// `base * growth^level - 1`, its first 12 bits.
    pub scale: f32,
    /// The rest of it.
    pub scale_rest: f32,
    /// `ceil(scale) + 1`
    pub resolution: u32,
    /// First entry in the table.
    pub first: u32,
    /// Entries; a power of two where the level is hashed.
    pub count: u32,
    /// 1 where `resolution^3` is more than the entries.
    pub hashed: u32,
}

/// Parameters of [`hash_grid`].
///
/// Points come in chunks: the rows of a chunk lie together, behind the rows of the chunk before.
#[params]
pub struct HashGridParams {
    /// Points to encode.
    pub points: u32,
    /// Distance of two rows in `position` and `output`.
    pub stride: u32,
    /// Row of `output` that the first level's first feature goes to.
    pub first_row: u32,
    /// Features of a level.
    pub features: u32,
    /// Points of a chunk: a multiple of 64, so that a workgroup's points are in one chunk.
    pub chunk: u32,
    /// Rows of a chunk in `position`.
    pub point_rows: u32,
    /// Rows of a chunk in `output`.
    pub rows: u32,
}

impl HashGridParams {
    /// Where the column of an invocation's point begins in `position`.
    #[inline(always)]
    pub fn point_column(&self, id: Invocation) -> u32 {
        self.column(id, self.point_rows)
    }

    /// Where the features of an invocation's point begin in `output`, for a level.
    #[inline(always)]
    pub fn feature_column(&self, id: Invocation, level: u32) -> u32 {
        let row = self.first_row + level * self.features;
        self.column(id, self.rows) + row * self.stride
    }

    /// The points of a workgroup are in one chunk, so a GPU divides once for all of them.
    #[inline(always)]
    fn column(&self, id: Invocation, rows: u32) -> u32 {
        let first = id.workgroup_index() * id.size.x;
        let chunk = first / self.chunk;
        chunk * (rows * self.stride) + (first - chunk * self.chunk) + id.local.x
    }
}

/// Where a point lies in a level: the cell and the weights of its upper corners.
#[derive(Clone, Copy)]
pub struct Cell<L: Lane> {
    /// Lowest corner.
    pub corner: [L::Index; 3],
    /// Weights of the upper corners, per axis.
    pub weight: [L; 3],
}

impl GridLevel {
    /// A level whose place in the table is known.
    #[cfg(not(target_arch = "spirv"))]
    pub fn new(scale: f64, resolution: u32, first: u32, count: u32, hashed: bool) -> Self {
        let leading = leading_bits(scale, 12);
        let scale_rest = (scale - f64::from(leading)) as f32;
        Self { scale: leading, scale_rest, resolution, first, count, hashed: u32::from(hashed) }
    }

    /// The cell of a point, which is clamped to [0, 1] first.
    #[inline(always)]
    pub fn cell<L: Lane>(&self, [x, y, z]: [Split<L>; 3]) -> Cell<L> {
        let (cell_x, weight_x) = self.axis(x);
        let (cell_y, weight_y) = self.axis(y);
        let (cell_z, weight_z) = self.axis(z);
        Cell { corner: [cell_x, cell_y, cell_z], weight: [weight_x, weight_y, weight_z] }
    }

    /// `x' * scale + 0.5`, its floor and its fraction. The product of the leading parts is exact, so that the
    /// fraction keeps its digits however large the cell's number is.
    #[inline(always)]
    fn axis<L: Lane>(&self, x: Split<L>) -> (L::Index, L) {
        let number = L::splat;
        let x = x.clamped();
        let main = x.coarse * number(self.scale);
        let rest = x.coarse * number(self.scale_rest)
            + x.fine * number(self.scale + self.scale_rest)
            + number(0.5);
        let whole = main.truncate();
        let t = ((main - whole) + rest).max(number(0.0));
        let carry = t.truncate();
        let t = t - carry;
        ((whole + carry).index(), t)
    }

    /// The entries of a cell's corners, x fastest, counted from the table's begin.
    ///
    /// A GPU takes as long for a product as for four sums. So the upper corners of an axis add a factor to the product of the
    /// lower ones.
    #[inline(always)]
    pub fn entries<I: LaneIndex>(&self, corner: [I; 3]) -> [I; 8] {
        let number = I::splat;
        let first = number(self.first);
        if self.hashed != 0 {
            // modulo a power of two
            let mask = number(self.count - 1);
            let [x, y, z] = axes(corner, [2_654_435_761, 805_459_861]);
            at_corners(x, y, z, |x, y, z| ((x ^ y ^ z) & mask).wrapping_add(first))
        } else {
            // modulo: a corner is at most `resolution`, so that once is enough
            let count = number(self.count);
            let row = self.resolution;
            let [x, y, z] = axes(corner, [row, row.wrapping_mul(row)]);
            at_corners(x, y, z, |x, y, z| {
                let index = x.wrapping_add(y).wrapping_add(z);
                let index = I::select(index.less(count), index, index.wrapping_sub(count));
                index.wrapping_add(first)
            })
        }
    }
}

/// The terms of the lower and the upper corners of a cell in their entries, for each axis; y and z have factors.
#[inline(always)]
fn axes<I: LaneIndex>([x, y, z]: [I; 3], [row, layer]: [u32; 2]) -> [[I; 2]; 3] {
    let number = I::splat;
    let axis = |lower: I, factor: u32| [lower, lower.wrapping_add(number(factor))];
    let y = y.wrapping_mul(number(row));
    let z = z.wrapping_mul(number(layer));
    [axis(x, 1), axis(y, row), axis(z, layer)]
}

/// A function of the corners of a cell, x fastest.
#[inline(always)]
fn at_corners<I: LaneIndex>(x: [I; 2], y: [I; 2], z: [I; 2], f: impl Fn(I, I, I) -> I) -> [I; 8] {
    [
        f(x[0], y[0], z[0]),
        f(x[1], y[0], z[0]),
        f(x[0], y[1], z[0]),
        f(x[1], y[1], z[0]),
        f(x[0], y[0], z[1]),
        f(x[1], y[0], z[1]),
        f(x[0], y[1], z[1]),
        f(x[1], y[1], z[1]),
    ]
}

/// The eight corners of a cell: their entries and their weights, x fastest.
#[derive(Clone, Copy)]
pub struct Corners<L: Lane> {
    /// Entries, counted from the table's begin.
    pub entry: [L::Index; 8],
    /// Trilinear weights.
    pub weight: [L; 8],
}

impl<L: Lane> Corners<L> {
    /// The corners of a cell. All eight are written out: a local array that is indexed would stay in memory.
    #[inline(always)]
    pub fn new(level: &GridLevel, cell: Cell<L>) -> Self {
        let [upper_x, upper_y, upper_z] = cell.weight;
        let one = L::splat(1.0);
        let lower_x = one - upper_x;
        let lower_y = one - upper_y;
        let lower_z = one - upper_z;
        let ll = lower_x * lower_y;
        let ul = upper_x * lower_y;
        let lu = lower_x * upper_y;
        let uu = upper_x * upper_y;
        let weight = [
            ll * lower_z,
            ul * lower_z,
            lu * lower_z,
            uu * lower_z,
            ll * upper_z,
            ul * upper_z,
            lu * upper_z,
            uu * upper_z,
        ];
        Self { entry: level.entries(cell.corner), weight }
    }

    /// The same corners, with the place of each one's first value in a table `[entries, width]` instead of its entry.
    #[inline(always)]
    pub fn places(self, width: u32) -> Self {
        let width = <L::Index as LaneIndex>::splat(width);
        let [a, b, c, d, e, f, g, h] = self.entry;
        let entry = [
            a.wrapping_mul(width),
            b.wrapping_mul(width),
            c.wrapping_mul(width),
            d.wrapping_mul(width),
            e.wrapping_mul(width),
            f.wrapping_mul(width),
            g.wrapping_mul(width),
            h.wrapping_mul(width),
        ];
        Self { entry, ..self }
    }
}

/// Writes an expression out for each of the eight corners of a cell, x fastest: `of_corners!(corners, |entry, weight| value)`
/// is an array of the values, and `of_corners!(each corners, |entry, weight| statement)` runs a statement for each corner.
macro_rules! of_corners {
    (each $corners:expr, |$entry:ident, $weight:ident| $value:expr) => {
        $crate::hash_grid::of_corners!(@ each $corners, $entry $weight $value)
    };
    ($corners:expr, |$entry:ident, $weight:ident| $value:expr) => {
        $crate::hash_grid::of_corners!(@ array $corners, $entry $weight $value)
    };
    (@ $kind:ident $corners:expr, $entry:ident $weight:ident $value:expr) => {{
        let [e0, e1, e2, e3, e4, e5, e6, e7] = $corners.entry;
        let [w0, w1, w2, w3, w4, w5, w6, w7] = $corners.weight;
        $crate::hash_grid::of_corners!(
            @$kind $entry $weight $value; e0 w0 e1 w1 e2 w2 e3 w3 e4 w4 e5 w5 e6 w6 e7 w7
        )
    }};
    (@each $entry:ident $weight:ident $value:expr; $($e:ident $w:ident)*) => {{
        $(
            let $entry = $e;
            let $weight = $w;
            $value;
        )*
    }};
    (@array $entry:ident $weight:ident $value:expr; $($e:ident $w:ident)*) => {
        [$({
            let $entry = $e;
            let $weight = $w;
            $value
        }),*]
    };
}
pub(crate) use of_corners;

/// The sum of the corners' values, in their order.
#[inline(always)]
pub fn sum<L: Lane>([a, b, c, d, e, f, g, h]: [L; 8]) -> L {
    a + b + c + d + e + f + g + h
}

/// [`sum`] for two values of each corner.
#[inline(always)]
fn sum_two<L: Lane>([a, b, c, d, e, f, g, h]: [[L; 2]; 8]) -> [L; 2] {
    [
        sum([a[0], b[0], c[0], d[0], e[0], f[0], g[0], h[0]]),
        sum([a[1], b[1], c[1], d[1], e[1], f[1], g[1], h[1]]),
    ]
}

/// Index of a value whose first neighbor is at a [place](Corners::places).
#[inline(always)]
pub fn value_at<L: Lane>(place: L::Index, value: u32) -> L::Index {
    place.wrapping_add(<L::Index as LaneIndex>::splat(value))
}

/// Rows that a point takes in a buffer `[rows, stride]`.
pub const POINT_ROWS: u32 = 6;

/// Writes a point of the unit cube into its column: the coarse parts in rows 0 to 2, the fine ones in rows 3 to 5.
#[inline(always)]
pub fn write_point<L: Lane>(
    buffer: Write<f32>,
    stride: u32,
    column: u32,
    [x, y, z]: [Split<L>; 3],
) {
    x.coarse.write(buffer, column);
    y.coarse.write(buffer, stride + column);
    z.coarse.write(buffer, 2 * stride + column);
    x.fine.write(buffer, 3 * stride + column);
    y.fine.write(buffer, 4 * stride + column);
    z.fine.write(buffer, 5 * stride + column);
}

/// The output of [`write_point`].
#[inline(always)]
pub fn read_point<L: Lane>(buffer: Read<f32>, stride: u32, column: u32) -> [Split<L>; 3] {
    [
        read_split(buffer, stride, column),
        read_split(buffer, stride, stride + column),
        read_split(buffer, stride, 2 * stride + column),
    ]
}

/// The coordinate whose coarse part is at `coarse`.
#[inline(always)]
fn read_split<L: Lane>(buffer: Read<f32>, stride: u32, coarse: u32) -> Split<L> {
    Split { coarse: L::read(buffer, coarse), fine: L::read(buffer, coarse + 3 * stride) }
}

/// Writes the features of every (point, level): points along x and y, levels along z.
///
/// `position [chunks, point_rows, stride]`, see [`write_point`]; `table [entries, features]`;
/// `output [chunks, rows, stride]`.
#[kernel(threads(64), over(params.points, levels.len()), iterations = MAX_FEATURES, lanes(points), counts(points))]
pub fn hash_grid<L: Lane>(
    id: Invocation,
    params: &HashGridParams,
    levels: Read<GridLevel>,
    table: Read<f32>,
    position: Read<f32>,
    output: Write<f32>,
) {
    let point = id.index();
    if point < params.points {
        let level = levels.read(id.workgroup.z);
        let stride = params.stride;
        let x = read_point::<L>(position, stride, params.point_column(id));
        let features = params.features;
        let corners = Corners::new(&level, level.cell(x)).places(features);
        let mut row = params.feature_column(id, id.workgroup.z);
        let mut f = 0;
        while L::GATHERS_TWO && f + 2 <= features {
            let [first, second] = sum_two(of_corners!(corners, |place, weight| {
                let [first, second] = L::gather_two(table, value_at::<L>(place, f));
                [first * weight, second * weight]
            }));
            first.write(output, row);
            second.write(output, row + stride);
            row += 2 * stride;
            f += 2;
        }
        while f < features {
            let value = sum(of_corners!(corners, |place, weight| {
                L::gather(table, value_at::<L>(place, f)) * weight
            }));
            value.write(output, row);
            row += stride;
            f += 1;
        }
    }
}
