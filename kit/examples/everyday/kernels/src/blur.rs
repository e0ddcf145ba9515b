//! Values from their neighbors: a blur of a picture, and a step of the heat equation.

use muslin::prelude::*;

/// Parameters of the kernels of this file.
#[params]
pub struct GridParams {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Of [`heat`]: diffusivity times the length of the step, at most 1/4.
    pub rate: f32,
}

/// A place that lies in a range, or the nearest one that does.
#[inline(always)]
fn clamped(place: u32, offset: u32, end: u32) -> u32 {
    // `offset` counts from 2 before the place
    (place + offset).max(2).min(end + 1) - 2
}

/// The mean of 5 x 5 pixels: `input [height, width]`, `output [height, width]`. Beyond the border, pixels are those of the border.
#[kernel(threads(16, 16), over(params.width, params.height, 1), iterations = 30)]
pub fn blur(id: Invocation, params: &GridParams, input: Read<f32>, output: Write<f32>) {
    let place = id.global();
    if place.x < params.width && place.y < params.height {
        let mut sum = 0.0;
        for dy in 0..5 {
            let row = clamped(place.y, dy, params.height) * params.width;
            for dx in 0..5 {
                sum += input.read(row + clamped(place.x, dx, params.width));
            }
        }
        output.write(place.y * params.width + place.x, sum * (1.0 / 25.0));
    }
}

/// A step of the heat equation, explicit: `input [height, width]`, `output [height, width]`. The border keeps its values.
#[kernel(threads(16, 16), over(params.width, params.height, 1))]
pub fn heat(id: Invocation, params: &GridParams, input: Read<f32>, output: Write<f32>) {
    let place = id.global();
    if place.x < params.width && place.y < params.height {
        let index = place.y * params.width + place.x;
        let own = input.read(index);
        let mut next = own;
        let is_inside =
            place.x > 0 && place.y > 0 && place.x + 1 < params.width && place.y + 1 < params.height;
        if is_inside {
            let sideways = input.read(index - 1) + input.read(index + 1);
            let upward = input.read(index - params.width) + input.read(index + params.width);
            next = own + params.rate * (sideways + upward - 4.0 * own);
        }
        output.write(index, next);
    }
}
