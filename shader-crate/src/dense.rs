//! Dense layers of both networks (Eq. 2 and 10).
//!
//! A network's parameters are one buffer of `Vec4`: for each layer the weights, input by input (the transpose of
//! the file's `[out, in]`), then the biases.  Outputs are padded with zeros to full columns of four, hidden
//! layers to [`HIDDEN_BLOCK`], so that no invocation asks where a row ends.

use glam::Vec4;

use crate::limits::MAX_INPUTS;
use crate::prelude::*;

/// Outputs of a hidden layer that one invocation computes.
pub const HIDDEN_BLOCK: u32 = 16;

/// Parameters of [`dense`].
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct DenseParams {
    /// Samples in the batch.
    pub samples: u32,
    /// Distance of two rows in `input` and `output`.
    pub stride: u32,
    /// Inputs of the layer.
    pub inputs: u32,
    /// Columns of four outputs, padding included.
    pub columns: u32,
    /// Where the layer's weights begin.
    pub weight: u32,
    /// Where the layer's biases begin.
    pub bias: u32,
}

/// Four outputs of a layer for one sample, before the activation: `b + sum_i W_i x_i`.
///
/// Inputs are summed in ascending order on every device.
#[inline(always)]
pub fn column(
    params: &DenseParams,
    parameters: Read<Vec4>,
    input: Read<f32>,
    sample: u32,
    column: u32,
) -> Vec4 {
    let mut sum = parameters.read(params.bias + column);
    let mut weight = params.weight + column;
    let mut at = sample;
    let mut i = 0;
    while i < params.inputs {
        sum += parameters.read(weight) * input.read(at);
        weight += params.columns;
        at += params.stride;
        i += 1;
    }
    sum
}

/// A hidden layer: `output = max(W input + b, 0)`, samples along x and y, blocks of 16 outputs along z.
///
/// `input [inputs, stride]`, `output [4 columns, stride]`.
#[kernel(threads(64), iterations = MAX_INPUTS, fused)]
pub fn dense(
    id: Invocation,
    params: &DenseParams,
    parameters: Read<Vec4>,
    input: Read<f32>,
    output: Write<f32>,
) {
    let sample = id.index();
    if sample < params.samples {
        // four columns at once: each input is read once for sixteen outputs
        let first = id.workgroup.z * (HIDDEN_BLOCK / 4);
        let mut a = parameters.read(params.bias + first);
        let mut b = parameters.read(params.bias + first + 1);
        let mut c = parameters.read(params.bias + first + 2);
        let mut d = parameters.read(params.bias + first + 3);
        let mut weight = params.weight + first;
        let mut at = sample;
        let mut i = 0;
        while i < params.inputs {
            let x = input.read(at);
            a += parameters.read(weight) * x;
            b += parameters.read(weight + 1) * x;
            c += parameters.read(weight + 2) * x;
            d += parameters.read(weight + 3) * x;
            weight += params.columns;
            at += params.stride;
            i += 1;
        }
        let row = first * 4;
        write_rectified(output, a, row, params.stride, sample);
        write_rectified(output, b, row + 4, params.stride, sample);
        write_rectified(output, c, row + 8, params.stride, sample);
        write_rectified(output, d, row + 12, params.stride, sample);
    }
}

#[inline(always)]
fn write_rectified(output: Write<f32>, value: Vec4, row: u32, stride: u32, sample: u32) {
    let value = value.max(Vec4::ZERO);
    let first = row * stride + sample;
    output.write(first, value.x);
    output.write(first + stride, value.y);
    output.write(first + 2 * stride, value.z);
    output.write(first + 3 * stride, value.w);
}
