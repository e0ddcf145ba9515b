//! The product of two matrices of halves, with sums of `f32`: on tensor cores where a device has some.

use muslin::prelude::*;
use muslin::tile::{Left, Right, Tile};

/// Most columns of the left matrix.
pub const MAX_INNER: u32 = 8192;

/// Parameters of the kernels of this file. Sides are multiples of a tile's side.
#[params]
pub struct TilesParams {
    /// Rows of the left matrix.
    pub rows: u32,
    /// Columns of the left matrix, and rows of the right one: at most [`MAX_INNER`].
    pub inner: u32,
    /// Columns of the right matrix.
    pub columns: u32,
}

/// `output [rows, columns] = left [rows, inner] right [inner, columns]`, a tile of the output in each invocation.
#[loops]
#[inline(always)]
fn product_of_tiles<const SIDE: usize>(
    id: Invocation,
    params: &TilesParams,
    left: Read<u32>,
    right: Read<u32>,
    output: Write<f32>,
) {
    let side = SIDE as u32;
    let across = params.columns / side;
    let index = id.index();
    if index < across * (params.rows / side) {
        let row = index / across * side;
        let column = index % across * side;
        let mut sum = Tile::<f32, SIDE, SIDE>::zero();
        let mut k = 0;
        while k < params.inner {
            let a = Tile::<Left, SIDE, SIDE>::load(left, row * params.inner + k, params.inner);
            let b =
                Tile::<Right, SIDE, SIDE>::load(right, k * params.columns + column, params.columns);
            sum = sum.multiply_add(a, b);
            k += side;
        }
        sum.store(output, row * params.columns + column, params.columns);
    }
}

/// `product_of_tiles` of 8 x 8.
#[kernel(threads(64), tiles(8, 8, 8), over(params.rows / 8 * (params.columns / 8)), iterations = MAX_INNER / 8)]
pub fn product_tiles_8(
    id: Invocation,
    params: &TilesParams,
    left: Read<u32>,
    right: Read<u32>,
    output: Write<f32>,
) {
    product_of_tiles::<8>(id, params, left, right, output);
}

/// `product_of_tiles` of 16 x 16.
#[kernel(threads(64), tiles(16, 16, 16), over(params.rows / 16 * (params.columns / 16)), iterations = MAX_INNER / 16)]
pub fn product_tiles_16(
    id: Invocation,
    params: &TilesParams,
    left: Read<u32>,
    right: Read<u32>,
    output: Write<f32>,
) {
    product_of_tiles::<16>(id, params, left, right, output);
}
