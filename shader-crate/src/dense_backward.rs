//! The derivative of a dense layer by its inputs (Eq. 2 and 10), from dL/d of its outputs before the activation.
//!
//! A gradient has the layout of its tensor, `[rows, stride]`.

use glam::Vec4;

use crate::dense::{min, read_column};
use crate::limits::MAX_HIDDEN_WIDTH;
use muslin::lane_vec4::LaneVec4;
use muslin::prelude::*;
use muslin::samples::Samples;

/// Inputs of a layer whose gradient one invocation of [`dense_backward`] computes.
const INPUTS_PER_INVOCATION: u32 = 8;

/// Parameters of [`dense_backward`].
#[params]
pub struct DenseBackwardParams {
    /// Samples in the chunk.
    pub samples: u32,
    /// Distance of two rows in `input`, `output_gradient` and `input_gradient`, a multiple of 4.
    pub stride: u32,
    /// Inputs of the layer.
    pub inputs: u32,
    /// Columns of four outputs, padding included.
    pub columns: u32,
    /// Where the layer's weights begin.
    pub weight: u32,
    /// The first input that requires a gradient.
    pub first_input: u32,
    /// Exclusive end of the inputs: with `rectified`, after the padding of the layer below.
    pub end_input: u32,
    /// 1 if the inputs are a hidden layer's outputs: the gradient is then by their values before the activation.
    pub rectified: u32,
}

/// `sum + g W^T` for the four outputs of a column and four inputs.
#[inline(always)]
fn add_transposed<S: Samples>(sum: LaneVec4<S>, weight: [Vec4; 4], g: LaneVec4<S>) -> LaneVec4<S> {
    let [x, y, z, w] = weight;
    LaneVec4 {
        x: add_dot(sum.x, x, g),
        y: add_dot(sum.y, y, g),
        z: add_dot(sum.z, z, g),
        w: add_dot(sum.w, w, g),
    }
}

#[inline(always)]
fn add_dot<S: Samples>(sum: S, weight: Vec4, g: LaneVec4<S>) -> S {
    let sum = g.x.mul_add(S::splat(weight.x), sum);
    let sum = g.y.mul_add(S::splat(weight.y), sum);
    let sum = g.z.mul_add(S::splat(weight.z), sum);
    g.w.mul_add(S::splat(weight.w), sum)
}

/// The gradient of a layer's inputs, `dL/dx_i = sum_o W_oi dL/dy_o` of Eq. 2 and 10: samples along x and y, blocks of
/// eight inputs from `first_input` on along z.
///
/// `input [inputs, stride]`, `output_gradient [4 columns, stride]`, `input_gradient [end_input, stride]`.
#[kernel(threads(64), over(params.samples, (params.end_input - params.first_input).div_ceil(INPUTS_PER_INVOCATION)), iterations = MAX_HIDDEN_WIDTH / 4, fused, z_innermost, lanes(samples), counts(samples))]
pub fn dense_backward<S: Samples>(
    id: Invocation,
    params: &DenseBackwardParams,
    parameters: Read<Vec4>,
    input: ReadFours<f32>,
    output_gradient: ReadFours<f32>,
    input_gradient: WriteFours<f32>,
) {
    let sample = id.index();
    if sample < params.samples {
        let first = params.first_input + id.workgroup.z * INPUTS_PER_INVOCATION;
        if S::COLUMNS == 1 {
            let low = four_inputs::<S>(params, parameters, output_gradient, first, sample);
            write_gradient(params, input, input_gradient, low, first, sample);
            let high = four_inputs::<S>(params, parameters, output_gradient, first + 4, sample);
            write_gradient(params, input, input_gradient, high, first + 4, sample);
        } else {
            let [low, high] = eight_inputs::<S>(params, parameters, output_gradient, first, sample);
            write_gradient(params, input, input_gradient, low, first, sample);
            write_gradient(params, input, input_gradient, high, first + 4, sample);
        }
    }
}

/// The gradients of four inputs, from one on.
#[loops]
#[inline(always)]
fn four_inputs<S: Samples>(
    params: &DenseBackwardParams,
    parameters: Read<Vec4>,
    output_gradient: ReadFours<f32>,
    first: u32,
    sample: u32,
) -> LaneVec4<S> {
    let rows = weight_rows(params, first);
    let mut sum = LaneVec4::<S>::splat(Vec4::ZERO);
    let mut at = sample;
    let mut c = 0;
    while c < params.columns {
        let g = read_column::<S>(output_gradient, at, params.stride);
        sum = add_transposed(sum, read_weights(parameters, rows, c), g);
        at += 4 * params.stride;
        c += 1;
    }
    sum
}

/// The gradients of eight inputs: each of the outputs' gradients is read once for all of them.
#[loops]
#[inline(always)]
fn eight_inputs<S: Samples>(
    params: &DenseBackwardParams,
    parameters: Read<Vec4>,
    output_gradient: ReadFours<f32>,
    first: u32,
    sample: u32,
) -> [LaneVec4<S>; 2] {
    let low_rows = weight_rows(params, first);
    let high_rows = weight_rows(params, first + 4);
    let mut low = LaneVec4::<S>::splat(Vec4::ZERO);
    let mut high = LaneVec4::<S>::splat(Vec4::ZERO);
    let mut at = sample;
    let mut c = 0;
    while c < params.columns {
        let g = read_column::<S>(output_gradient, at, params.stride);
        low = add_transposed(low, read_weights(parameters, low_rows, c), g);
        high = add_transposed(high, read_weights(parameters, high_rows, c), g);
        at += 4 * params.stride;
        c += 1;
    }
    [low, high]
}

/// Where the weights of four inputs begin. Inputs past the last repeat it, and are not written.
#[inline(always)]
fn weight_rows(params: &DenseBackwardParams, first: u32) -> [u32; 4] {
    let last = params.inputs - 1;
    let weight = params.weight;
    let columns = params.columns;
    [
        weight + min(first, last) * columns,
        weight + min(first + 1, last) * columns,
        weight + min(first + 2, last) * columns,
        weight + min(first + 3, last) * columns,
    ]
}

/// The weights of four inputs and a column of outputs.
#[inline(always)]
fn read_weights(parameters: Read<Vec4>, rows: [u32; 4], column: u32) -> [Vec4; 4] {
    [
        parameters.read(rows[0] + column),
        parameters.read(rows[1] + column),
        parameters.read(rows[2] + column),
        parameters.read(rows[3] + column),
    ]
}

/// Writes four rows of a gradient, as many of them as there are.
#[inline(always)]
fn write_gradient<S: Samples>(
    params: &DenseBackwardParams,
    input: ReadFours<f32>,
    output: WriteFours<f32>,
    value: LaneVec4<S>,
    row: u32,
    sample: u32,
) {
    let count = params.samples - sample;
    let at = row * params.stride + sample;
    if row < params.end_input {
        masked(params, input, value.x, at).write(output, at, count);
    }
    let at = at + params.stride;
    if row + 1 < params.end_input {
        masked(params, input, value.y, at).write(output, at, count);
    }
    let at = at + params.stride;
    if row + 2 < params.end_input {
        masked(params, input, value.z, at).write(output, at, count);
    }
    let at = at + params.stride;
    if row + 3 < params.end_input {
        masked(params, input, value.w, at).write(output, at, count);
    }
}

/// Derivative of max(x, 0) of the layer below, if there is one: an output of 0 has no gradient.
#[inline(always)]
fn masked<S: Samples>(params: &DenseBackwardParams, input: ReadFours<f32>, value: S, at: u32) -> S {
    if params.rectified != 0 { value.where_positive(S::read(input, at)) } else { value }
}
