//! Multiresolution hash grid.

use glam::Vec3;

use crate::limits::MAX_FEATURES;
use crate::math::{max, truncate};
use crate::prelude::*;
use crate::unit_cube::Split;
#[cfg(not(target_arch = "spirv"))]
use crate::unit_cube::leading_bits;

/// One level of a grid; the host computes it in f64, kernels never call `pow`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
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
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct HashGridParams {
    /// Points to encode.
    pub points: u32,
    /// Distance of two rows in `position` and `output`.
    pub stride: u32,
    /// Row of `output` that the first level's first feature goes to.
    pub first_row: u32,
    /// Features of a level.
    pub features: u32,
    /// 1 for smoothstep interpolation, 0 for linear.
    pub smoothstep: u32,
}

/// Where a point lies in a level: the cell and the weights of its upper corners.
#[derive(Clone, Copy)]
pub struct Cell {
    /// Lowest corner.
    pub corner: [u32; 3],
    /// Interpolation weights, per axis.
    pub weight: Vec3,
}

impl GridLevel {
    /// A level of which the first entry, the entries and whether it is hashed are known.
    #[cfg(not(target_arch = "spirv"))]
    pub fn new(scale: f64, resolution: u32, first: u32, count: u32, hashed: bool) -> Self {
        let leading = leading_bits(scale, 12);
        let scale_rest = (scale - f64::from(leading)) as f32;
        Self { scale: leading, scale_rest, resolution, first, count, hashed: u32::from(hashed) }
    }

    /// The cell of a point, which is clamped to [0, 1] first.
    #[inline(always)]
    pub fn cell(&self, [x, y, z]: [Split; 3], smoothstep: bool) -> Cell {
        let (cell_x, weight_x) = self.axis(x, smoothstep);
        let (cell_y, weight_y) = self.axis(y, smoothstep);
        let (cell_z, weight_z) = self.axis(z, smoothstep);
        Cell { corner: [cell_x, cell_y, cell_z], weight: Vec3::new(weight_x, weight_y, weight_z) }
    }

    /// `x' * scale + 0.5`, its floor and its fraction.  The product of the leading parts is exact, so that the
    /// fraction keeps its digits however large the cell's number is.
    #[inline(always)]
    fn axis(&self, x: Split, smoothstep: bool) -> (u32, f32) {
        let x = x.clamped();
        let main = x.coarse * self.scale;
        let rest = x.coarse * self.scale_rest + x.fine * (self.scale + self.scale_rest) + 0.5;
        let whole = truncate(main);
        let t = max((main - whole) + rest, 0.0);
        let carry = truncate(t);
        let t = t - carry;
        ((whole + carry) as u32, if smoothstep { t * t * (3.0 - 2.0 * t) } else { t })
    }

    /// The entry of a grid point, counted from the table's begin.
    #[inline(always)]
    pub fn entry(&self, x: u32, y: u32, z: u32) -> u32 {
        let index = if self.hashed != 0 {
            // modulo a power of two
            (x ^ y.wrapping_mul(2_654_435_761) ^ z.wrapping_mul(805_459_861)) & (self.count - 1)
        } else {
            // modulo: a corner is at most `resolution`, so that once is enough
            let index = x + y * self.resolution + z * self.resolution * self.resolution;
            if index >= self.count { index - self.count } else { index }
        };
        self.first + index
    }
}

/// Rows that a point takes in a buffer `[rows, stride]`.
pub const POINT_ROWS: u32 = 6;

/// Writes a point of the unit cube into its column: the coarse parts in rows 0 to 2, the fine ones in rows 3 to 5.
#[inline(always)]
pub fn write_point(buffer: Write<f32>, stride: u32, column: u32, [x, y, z]: [Split; 3]) {
    buffer.write(column, x.coarse);
    buffer.write(stride + column, y.coarse);
    buffer.write(2 * stride + column, z.coarse);
    buffer.write(3 * stride + column, x.fine);
    buffer.write(4 * stride + column, y.fine);
    buffer.write(5 * stride + column, z.fine);
}

/// What [`write_point`] wrote.
#[inline(always)]
fn read_point(buffer: Read<f32>, stride: u32, column: u32) -> [Split; 3] {
    [
        read_split(buffer, stride, column),
        read_split(buffer, stride, stride + column),
        read_split(buffer, stride, 2 * stride + column),
    ]
}

/// The coordinate whose coarse part is at `coarse`.
#[inline(always)]
fn read_split(buffer: Read<f32>, stride: u32, coarse: u32) -> Split {
    Split { coarse: buffer.read(coarse), fine: buffer.read(coarse + 3 * stride) }
}

/// Writes the features of every (point, level): points along x and y, levels along z.
///
/// `position [6, stride]`, see [`write_point`]; `table [entries, features]`; `output [rows, stride]`.
#[kernel(threads(64), iterations = MAX_FEATURES)]
pub fn hash_grid(
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
        let x = read_point(position, stride, point);
        let cell = level.cell(x, params.smoothstep != 0);
        let [x0, y0, z0] = cell.corner;
        let (x1, y1, z1) = (x0 + 1, y0 + 1, z0 + 1);
        // the eight corners are written out: a local array would stay in memory
        let features = params.features;
        let e0 = level.entry(x0, y0, z0) * features;
        let e1 = level.entry(x1, y0, z0) * features;
        let e2 = level.entry(x0, y1, z0) * features;
        let e3 = level.entry(x1, y1, z0) * features;
        let e4 = level.entry(x0, y0, z1) * features;
        let e5 = level.entry(x1, y0, z1) * features;
        let e6 = level.entry(x0, y1, z1) * features;
        let e7 = level.entry(x1, y1, z1) * features;
        let upper = cell.weight;
        let lower = Vec3::ONE - upper;
        let (low_z, high_z) = (lower.z, upper.z);
        let w0 = lower.x * lower.y * low_z;
        let w1 = upper.x * lower.y * low_z;
        let w2 = lower.x * upper.y * low_z;
        let w3 = upper.x * upper.y * low_z;
        let w4 = lower.x * lower.y * high_z;
        let w5 = upper.x * lower.y * high_z;
        let w6 = lower.x * upper.y * high_z;
        let w7 = upper.x * upper.y * high_z;
        let mut row = (params.first_row + id.workgroup.z * features) * stride + point;
        let mut f = 0;
        while f < features {
            let value = table.read(e0 + f) * w0
                + table.read(e1 + f) * w1
                + table.read(e2 + f) * w2
                + table.read(e3 + f) * w3
                + table.read(e4 + f) * w4
                + table.read(e5 + f) * w5
                + table.read(e6 + f) * w6
                + table.read(e7 + f) * w7;
            output.write(row, value);
            row += stride;
            f += 1;
        }
    }
}
