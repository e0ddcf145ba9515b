//! The transpose of a matrix: a tile is read row by row, and written row by row.

use muslin::prelude::*;

/// Side of a tile.
pub const SIDE: u32 = 16;
/// Distance of two rows of a tile: one more than the side, so that a column lies in different banks of a GPU's memory.
const STRIDE: u32 = SIDE + 1;

/// Parameters of [`transpose`].
#[params]
pub struct TransposeParams {
    /// Rows of the input.
    pub rows: u32,
    /// Columns of the input.
    pub columns: u32,
}

/// `output [columns, rows]` of `input [rows, columns]`.
#[kernel(threads(SIDE, SIDE), over(params.columns, params.rows, 1))]
pub fn transpose(
    id: Invocation,
    params: &TransposeParams,
    input: Read<u32>,
    output: Write<u32>,
    tile: Shared<u32, { (SIDE * STRIDE) as usize }>,
) {
    let place = id.global();
    if place.x < params.columns && place.y < params.rows {
        tile.write(
            id.local.y * STRIDE + id.local.x,
            input.read(place.y * params.columns + place.x),
        );
    }
    id.barrier();
    let column = id.workgroup.y * SIDE + id.local.x;
    let row = id.workgroup.x * SIDE + id.local.y;
    if column < params.rows && row < params.columns {
        output.write(row * params.rows + column, tile.read(id.local.x * STRIDE + id.local.y));
    }
}
