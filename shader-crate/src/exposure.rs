//! A photograph's exposure: its camera turned the scene's colors x into `x' = gain x + offset` for each
//! channel. And the gradient. A plane is a channel of a tile.

use crate::limits::MAX_TILE_SIDE;
use muslin::prelude::*;

/// Parameters of [`expose`] and [`expose_backward`].
#[params]
pub struct ExposureParams {
    /// Planes of the batch: three for each tile.
    pub planes: u32,
    /// S, in pixels.
    pub side: u32,
}

/// `exposed [planes, S, S]`, of `image [planes, S, S]` and `exposure [planes, 2]`, a gain and an offset.
#[kernel(threads(64), over(params.planes * params.side * params.side))]
pub fn expose(
    id: Invocation,
    params: &ExposureParams,
    image: Read<f32>,
    exposure: Read<f32>,
    exposed: Write<f32>,
) {
    let index = id.index();
    let area = params.side * params.side;
    if index < params.planes * area {
        let first = index / area * 2;
        exposed.write(index, exposure.read(first) * image.read(index) + exposure.read(first + 1));
    }
}

/// Turns `gradient [planes, S, S]` from dL/dx' into dL/dx, and sums `(dL/dx' x, dL/dx')` of each row of pixels for the
/// gradients of gain and offset: `row_sum [planes, S, 2]`. The host adds the rows up, so that the order is always the same.
#[kernel(threads(64), over(params.planes * params.side), iterations = MAX_TILE_SIDE)]
pub fn expose_backward(
    id: Invocation,
    params: &ExposureParams,
    image: Read<f32>,
    exposure: Read<f32>,
    gradient: Write<f32>,
    row_sum: Write<f32>,
) {
    let row = id.index();
    if row < params.planes * params.side {
        let gain = exposure.read(row / params.side * 2);
        let mut by_gain = 0.0;
        let mut by_offset = 0.0;
        let mut next = row * params.side;
        let end = next + params.side;
        while next < end {
            let slope = gradient.read(next);
            by_gain += slope * image.read(next);
            by_offset += slope;
            gradient.write(next, slope * gain);
            next += 1;
        }
        row_sum.write(2 * row, by_gain);
        row_sum.write(2 * row + 1, by_offset);
    }
}
