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
#[kernel(threads(SIDE, SIDE), over(params.columns, params.rows, 1), iterations = 2 * MAX_INNER)]
pub fn product(
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
    let mut sum = 0.0;
    let mut first = 0;
    while first < params.inner {
        let column = first + id.local.x;
        let row = first + id.local.y;
        // beyond the matrices, tiles are 0
        let mut a = 0.0;
        if place.y < params.rows && column < params.inner {
            a = left.read(place.y * params.inner + column);
        }
        let mut b = 0.0;
        if row < params.inner && place.x < params.columns {
            b = right.read(row * params.columns + place.x);
        }
        left_tile.write(own, a);
        right_tile.write(own, b);
        id.barrier();
        let mut k = 0;
        while k < SIDE {
            let a = left_tile.read(id.local.y * SIDE + k);
            sum += a * right_tile.read(k * SIDE + id.local.x);
            k += 1;
        }
        id.barrier();
        first += SIDE;
    }
    if place.x < params.columns && place.y < params.rows {
        output.write(place.y * params.columns + place.x, sum);
    }
}
