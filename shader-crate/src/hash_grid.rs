//! Multiresolution hash grid.

use glam::Vec3;

use crate::math::clamp;
use crate::prelude::*;

/// One level of a grid; the host computes it in f64, kernels never call `pow`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct GridLevel {
    /// `base * growth^level - 1`
    pub scale: f32,
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
    /// The cell of a point, which is clamped to [0, 1] first.
    #[inline(always)]
    pub fn cell(&self, x: Vec3, smoothstep: bool) -> Cell {
        let (cell_x, weight_x) = self.axis(x.x, smoothstep);
        let (cell_y, weight_y) = self.axis(x.y, smoothstep);
        let (cell_z, weight_z) = self.axis(x.z, smoothstep);
        Cell { corner: [cell_x, cell_y, cell_z], weight: Vec3::new(weight_x, weight_y, weight_z) }
    }

    #[inline(always)]
    fn axis(&self, x: f32, smoothstep: bool) -> (u32, f32) {
        let position = clamp(x, 0.0, 1.0) * self.scale + 0.5;
        let cell = position as u32; // the floor: it is not negative
        let t = position - cell as f32;
        (cell, if smoothstep { t * t * (3.0 - 2.0 * t) } else { t })
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

/// Writes the features of every (point, level): points along x and y, levels along z.
///
/// `position [3, stride]`, in the unit cube; `table [entries, features]`; `output [rows, stride]`.
#[kernel(threads(64))]
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
        let x = Vec3::new(
            position.read(point),
            position.read(stride + point),
            position.read(2 * stride + point),
        );
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
