//! The product of two matrices, tile by tile.

use muslin::prelude::*;

/// Side of a tile.
pub const SIDE: u32 = 16;
const TILE: usize = (SIDE * SIDE) as usize;
/// Most columns of the left matrix.
pub const MAX_INNER: u32 = 8192;

/// Parameters of [`product`].
#[params]
pub struct ProductParams {
    /// Rows of the left matrix.
    pub rows: u32,
    /// Columns of the left matrix, and rows of the right one: at most [`MAX_INNER`].
    pub inner: u32,
    /// Columns of the right matrix.
    pub columns: u32,
}

/// `output [rows, columns] = left [rows, inner] right [inner, columns]`. A workgroup loads a tile of both, and then multiplies.
#[kernel(threads(SIDE, SIDE), over(params.columns, params.rows, 1), lanes(columns), iterations = 2 * MAX_INNER)]
pub fn product<L: Lane>(
    id: Invocation,
    params: &ProductParams,
    left: Read<f32>,
    right: Read<f32>,
    output: Write<f32>,
    left_tile: Shared<f32, TILE>,
    right_tile: Shared<f32, TILE>,
) {
    let place = id.global();
    let own = id.local.y * SIDE + id.local.x;
    let mut sum = L::splat(0.0);
    let mut first = 0;
    while first < params.inner {
        // beyond the matrices, tiles are 0
        let left_row = place.y * params.inner;
        let left_end = if place.y < params.rows { left_row + params.inner } else { 0 };
        let a = L::read_below(left, left_row + first + id.local.x, left_end);
        let row = first + id.local.y;
        let right_row = row * params.columns;
        let right_end = if row < params.inner { right_row + params.columns } else { 0 };
        let b = L::read_below(right, right_row + place.x, right_end);
        a.write_shared(left_tile, own);
        b.write_shared(right_tile, own);
        id.barrier();
        let mut k = 0;
        while k < SIDE {
            let a = L::splat(left_tile.read(id.local.y * SIDE + k));
            sum = sum + a * L::read_shared(right_tile, k * SIDE + id.local.x);
            k += 1;
        }
        id.barrier();
        first += SIDE;
    }
    if place.x < params.columns && place.y < params.rows {
        sum.write(output, place.y * params.columns + place.x);
    }
}
