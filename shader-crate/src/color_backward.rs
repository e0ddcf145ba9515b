//! The derivatives of the color's head (Eq. 3) and of the material in the network's input (Eq. 1).

use glam::Vec4;

use crate::limits::MAX_VECTOR;
use crate::splat::VECTORS;
use muslin::prelude::*;

/// Parameters of [`color_head_backward`].
#[params]
pub struct ColorHeadBackwardParams {
    /// Pairs of the chunk.
    pub samples: u32,
    /// First pair of the chunk.
    pub first_pair: u32,
    /// Distance of two rows in `logit_gradient`.
    pub stride: u32,
}

/// The gradient of the color network's outputs, `dL/dc~ = dL/dc c (1 - c)` of Eq. 3.
///
/// `color [pairs, 3]`; `pair_gradient [pairs, 3]`, dL/dc in the third; `logit_gradient [3, stride]`.
#[kernel(threads(64), over(params.samples), counts(samples))]
pub fn color_head_backward(
    id: Invocation,
    params: &ColorHeadBackwardParams,
    color: Read<f32>,
    pair_gradient: Read<Vec4>,
    logit_gradient: Write<f32>,
) {
    let sample = id.index();
    if sample < params.samples {
        let pair = params.first_pair + sample;
        let gradient = pair_gradient.read(pair * VECTORS + 2);
        let r = color.read(pair * 3);
        let g = color.read(pair * 3 + 1);
        let b = color.read(pair * 3 + 2);
        logit_gradient.write(sample, gradient.x * (r * (1.0 - r)));
        logit_gradient.write(params.stride + sample, gradient.y * (g * (1.0 - g)));
        logit_gradient.write(2 * params.stride + sample, gradient.z * (b * (1.0 - b)));
    }
}

/// Parameters of [`material_backward`].
#[params]
pub struct MaterialBackwardParams {
    /// Pairs of the chunk.
    pub samples: u32,
    /// First pair of the chunk.
    pub first_pair: u32,
    /// Distance of two rows in `input_gradient`.
    pub stride: u32,
    /// Values of a Gaussian's material.
    pub material: u32,
    /// Row of the material in `input_gradient`.
    pub material_row: u32,
}

/// The gradient of every pair's material, a part of the color network's input (Eq. 1): `input_gradient
/// [rows, stride]` to `pair_material [pairs, material]`.
#[kernel(threads(64), over(params.samples), iterations = MAX_VECTOR, counts(samples))]
pub fn material_backward(
    id: Invocation,
    params: &MaterialBackwardParams,
    input_gradient: Read<f32>,
    pair_material: Write<f32>,
) {
    let sample = id.index();
    if sample < params.samples {
        let to = (params.first_pair + sample) * params.material;
        let mut from = params.material_row * params.stride + sample;
        let mut m = 0;
        while m < params.material {
            pair_material.write(to + m, input_gradient.read(from));
            from += params.stride;
            m += 1;
        }
    }
}
