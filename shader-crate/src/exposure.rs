//! A photograph's exposure: its camera turned the scene's colors x into `x' = exp(a) x + b` for each channel. And the gradient. A
//! plane is a channel of a tile.
//!
//! `exposure [photographs, STRIDE]` has a and b of red, green and blue. A darker scene with larger gains would look the same, so
//! their means over all photographs are 0.

use crate::hash_grid_backward::VALUES_PER_FLAG;
use crate::limits::{MAX_PHOTOGRAPHS, MAX_TILE_SIDE};
use muslin::binned;
use muslin::math::exp;
use muslin::prelude::*;

/// Values of an exposure: a and b of three channels.
pub const VALUES: u32 = 6;

/// Distance of two photographs' values: a block that [`adam`](crate::adam::adam) takes or leaves as a whole.
pub const STRIDE: u32 = VALUES_PER_FLAG;

/// Where a plane's a and b are, for `photograph [tiles]`.
#[inline(always)]
fn place(photograph: Read<u32>, plane: u32) -> u32 {
    photograph.read(plane / 3) * STRIDE + plane % 3 * 2
}

/// Parameters of [`expose`].
#[params]
pub struct ExposeParams {
    /// Planes of the part: three for each tile.
    pub planes: u32,
    /// S, in pixels.
    pub side: u32,
}

/// `exposed [planes, S, S]`, of `image [planes, S, S]`.
#[kernel(threads(64), over(params.planes * params.side * params.side))]
pub fn expose(
    id: Invocation,
    params: &ExposeParams,
    photograph: Read<u32>,
    exposure: Read<f32>,
    image: Read<f32>,
    exposed: Write<f32>,
) {
    let index = id.index();
    let area = params.side * params.side;
    if index < params.planes * area {
        let at = place(photograph, index / area);
        let gain = exp(exposure.read(at));
        exposed.write(index, gain * image.read(index) + exposure.read(at + 1));
    }
}

/// Parameters of [`expose_backward`].
#[params]
pub struct ExposeBackwardParams {
    /// Rows of pixels of all planes.
    pub rows: u32,
    /// S, in pixels.
    pub side: u32,
    /// Values of `exposure`.
    pub values: u32,
}

/// Turns `gradient [planes, S, S]` from dL/dx' into dL/dx, and adds dL/da and dL/db to `sum [17, values, 2]`. A row of pixels is
/// summed in f32, and rows [exactly](binned).
#[kernel(threads(64), over(params.rows), iterations = MAX_TILE_SIDE, counts(rows))]
pub fn expose_backward(
    id: Invocation,
    params: &ExposeBackwardParams,
    photograph: Read<u32>,
    exposure: Read<f32>,
    image: Read<f32>,
    gradient: Write<f32>,
    sum: Write<u32>,
) {
    let row = id.index();
    if row < params.rows {
        let at = place(photograph, row / params.side);
        let gain = exp(exposure.read(at));
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
        binned::add(sum, params.values, at, by_gain * gain);
        binned::add(sum, params.values, at + 1, by_offset);
    }
}

/// Parameters of [`exposure_center`].
#[params]
pub struct ExposureCenterParams {
    /// Photographs.
    pub photographs: u32,
    /// [`VALUES`]
    pub values: u32,
}

/// Shifts each value of `exposure [photographs, STRIDE]` so that its mean over the photographs is 0.
#[kernel(threads(8), over(params.values), iterations = 2 * MAX_PHOTOGRAPHS, counts(values))]
pub fn exposure_center(id: Invocation, params: &ExposureCenterParams, exposure: Write<f32>) {
    let value = id.index();
    if value < params.values {
        let end = params.photographs * STRIDE;
        let mut sum = 0.0;
        let mut at = value;
        while at < end {
            sum += exposure.read(at);
            at += STRIDE;
        }
        let mean = sum / params.photographs as f32;
        at = value;
        while at < end {
            exposure.write(at, exposure.read(at) - mean);
            at += STRIDE;
        }
    }
}
