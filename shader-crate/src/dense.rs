//! Dense layers of both networks (Eq. 2 and 10).
//!
//! A network's parameters are one buffer of `Vec4`: for each layer the weights, input by input (the transpose of
//! the file's `[out, in]`), then the biases. Outputs are padded with zeros to full columns of four, hidden
//! layers to [`OUTPUTS_PER_INVOCATION`], so no invocation checks where a row ends.

use glam::Vec4;

use crate::limits::MAX_INPUTS;
use muslin::lane_vec4::LaneVec4;
use muslin::prelude::*;
use muslin::samples::Samples;

/// Outputs of a hidden layer that one invocation computes.
pub const OUTPUTS_PER_INVOCATION: u32 = 16;

/// Columns of them.
const BLOCK_COLUMNS: u32 = OUTPUTS_PER_INVOCATION / 4;

/// Parameters of [`dense`].
#[params]
pub struct DenseParams {
    /// Samples of the chunk.
    pub samples: u32,
    /// Distance of two rows in `input` and `output`, a multiple of 4.
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

/// Parameters of a head: a kernel with the last layer of a network, and what follows it.
#[params]
pub struct HeadParams {
    /// Samples of the chunk.
    pub samples: u32,
    /// First sample of the chunk, among all in the output.
    pub first: u32,
    /// See [`DenseParams::stride`].
    pub stride: u32,
    /// See [`DenseParams::inputs`].
    pub inputs: u32,
    /// See [`DenseParams::weight`].
    pub weight: u32,
    /// See [`DenseParams::bias`].
    pub bias: u32,
}

impl HeadParams {
    /// The layer.
    #[inline(always)]
    pub fn layer(&self) -> DenseParams {
        DenseParams {
            samples: self.samples,
            stride: self.stride,
            inputs: self.inputs,
            columns: 1,
            weight: self.weight,
            bias: self.bias,
        }
    }
}

/// The four outputs of a layer that has no more, for each lane's sample, before the activation: `b + sum_i W_i x_i`.
///
/// Inputs are summed in ascending order on every device.
#[loops]
#[inline(always)]
pub fn column<L: Lane>(
    params: &DenseParams,
    parameters: Read<Vec4>,
    input: Read<f32>,
    sample: u32,
) -> LaneVec4<L> {
    let mut sum = LaneVec4::splat(parameters.read(params.bias));
    let mut weight = params.weight;
    let mut at = sample;
    let mut i = 0;
    while i < params.inputs {
        sum = sum.add_product(parameters.read(weight), L::read(input, at));
        weight += 1;
        at += params.stride;
        i += 1;
    }
    sum
}

/// Four rows of a buffer, from a row on.
#[inline(always)]
pub fn read_column<S: Samples>(buffer: ReadFours<f32>, first: u32, stride: u32) -> LaneVec4<S> {
    LaneVec4 {
        x: S::read(buffer, first),
        y: S::read(buffer, first + stride),
        z: S::read(buffer, first + 2 * stride),
        w: S::read(buffer, first + 3 * stride),
    }
}

/// The smaller of two numbers.
#[inline(always)]
pub fn min(a: u32, b: u32) -> u32 {
    if a < b { a } else { b }
}

/// A hidden layer: `output = max(W input + b, 0)`, samples along x and y, blocks of 16 outputs along z.
///
/// `input [inputs, stride]`, `output [4 columns, stride]`.
#[kernel(threads(64), over(params.samples, params.columns * 4 / OUTPUTS_PER_INVOCATION), iterations = MAX_INPUTS, fused, z_innermost, lanes(samples), counts(samples))]
pub fn dense<S: Samples>(
    id: Invocation,
    params: &DenseParams,
    parameters: Read<Vec4>,
    input: ReadFours<f32>,
    output: WriteFours<f32>,
) {
    let sample = id.index();
    if sample < params.samples {
        let first = id.workgroup.z * BLOCK_COLUMNS;
        if S::COLUMNS == BLOCK_COLUMNS {
            four_columns::<S>(params, parameters, input, output, sample, first);
        } else {
            one_column::<S>(params, parameters, input, output, sample, first);
            one_column::<S>(params, parameters, input, output, sample, first + 1);
            one_column::<S>(params, parameters, input, output, sample, first + 2);
            one_column::<S>(params, parameters, input, output, sample, first + 3);
        }
    }
}

/// Sixteen outputs of a hidden layer, from a column on: each input is read once for all of them.
#[loops]
#[inline(always)]
fn four_columns<S: Samples>(
    params: &DenseParams,
    parameters: Read<Vec4>,
    input: ReadFours<f32>,
    output: WriteFours<f32>,
    sample: u32,
    first: u32,
) {
    let mut a = LaneVec4::<S>::splat(parameters.read(params.bias + first));
    let mut b = LaneVec4::<S>::splat(parameters.read(params.bias + first + 1));
    let mut c = LaneVec4::<S>::splat(parameters.read(params.bias + first + 2));
    let mut d = LaneVec4::<S>::splat(parameters.read(params.bias + first + 3));
    let mut weight = params.weight + first;
    let mut at = sample;
    let mut i = 0;
    while i < params.inputs {
        let x = S::read(input, at);
        a = a.add_product(parameters.read(weight), x);
        b = b.add_product(parameters.read(weight + 1), x);
        c = c.add_product(parameters.read(weight + 2), x);
        d = d.add_product(parameters.read(weight + 3), x);
        weight += params.columns;
        at += params.stride;
        i += 1;
    }
    let row = first * 4;
    write_rectified(output, a, row, params, sample);
    write_rectified(output, b, row + 4, params, sample);
    write_rectified(output, c, row + 8, params, sample);
    write_rectified(output, d, row + 12, params, sample);
}

/// Four outputs of a hidden layer.
#[loops]
#[inline(always)]
fn one_column<S: Samples>(
    params: &DenseParams,
    parameters: Read<Vec4>,
    input: ReadFours<f32>,
    output: WriteFours<f32>,
    sample: u32,
    first: u32,
) {
    let mut sum = LaneVec4::<S>::splat(parameters.read(params.bias + first));
    let mut weight = params.weight + first;
    let mut at = sample;
    let mut i = 0;
    while i < params.inputs {
        let x = S::read(input, at);
        sum = sum.add_product(parameters.read(weight), x);
        weight += params.columns;
        at += params.stride;
        i += 1;
    }
    write_rectified(output, sum, first * 4, params, sample);
}

/// Writes four rows of `max(value, 0)`, the outputs of a layer from a row on.
#[inline(always)]
pub fn write_rectified<S: Samples>(
    output: WriteFours<f32>,
    value: LaneVec4<S>,
    row: u32,
    params: &DenseParams,
    sample: u32,
) {
    let zero = S::splat(0.0);
    let stride = params.stride;
    let count = params.samples - sample;
    let first = row * stride + sample;
    value.x.max(zero).write(output, first, count);
    value.y.max(zero).write(output, first + stride, count);
    value.z.max(zero).write(output, first + 2 * stride, count);
    value.w.max(zero).write(output, first + 3 * stride, count);
}
