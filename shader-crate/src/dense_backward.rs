//! The derivatives of the dense layers (Eq. 2 and 10), from dL/d of a layer's outputs before the activation.
//!
//! A gradient has the layout of its tensor: `[rows, stride]` for inputs and outputs, and for a network's parameters the layout
//! of [`dense`](crate::dense), with zeros as padding.

use glam::Vec4;

use crate::limits::{MAX_CAMERAS, MAX_HIDDEN_WIDTH, MAX_SLICE, MAX_SLICES};
use crate::unit::{
    SEARCH, first_sample_of, first_slice_of, samples_of_slice, slice_of_sample, unit_of_slice,
};
use organza_kernel::lane_vec4::LaneVec4;
use organza_kernel::prelude::*;
use organza_kernel::samples::Samples;
#[cfg(not(target_arch = "spirv"))]
use organza_kernel::work::{NUMBER, Shape, VECTOR, Work, wide};

/// Inputs of a layer whose gradient one invocation of [`dense_backward`] computes.
pub const INPUTS_PER_INVOCATION: u32 = 8;

/// Inputs of a layer that one invocation of [`dense_weight_backward`] takes; its outputs are a column of four.
pub const WEIGHT_ROWS_PER_INVOCATION: u32 = 4;

/// Parameters of [`dense_backward`].
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct DenseBackwardParams {
    /// Samples in the chunk.
    pub samples: u32,
    /// Distance of two rows in `input`, `output_gradient` and `input_gradient`: at least three more than there are samples.
    pub stride: u32,
    /// Inputs of the layer.
    pub inputs: u32,
    /// Columns of four outputs, padding included.
    pub columns: u32,
    /// Where the layer's weights begin.
    pub weight: u32,
    /// The first input whose gradient somebody needs.
    pub first_input: u32,
    /// The last one, and one: with `rectified`, the padding of the layer below, too.
    pub end_input: u32,
    /// 1 if the inputs are a hidden layer's outputs: the gradient is then that of their values before the activation.
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

/// Four rows of a buffer, from a row on.
#[inline(always)]
fn read_column<S: Samples>(buffer: Read<f32>, first: u32, stride: u32) -> LaneVec4<S> {
    LaneVec4 {
        x: S::read(buffer, first),
        y: S::read(buffer, first + stride),
        z: S::read(buffer, first + 2 * stride),
        w: S::read(buffer, first + 3 * stride),
    }
}

/// The smaller of two numbers.
#[inline(always)]
fn least(a: u32, b: u32) -> u32 {
    if a < b { a } else { b }
}

/// What [`dense_backward`] computes and moves.
#[cfg(not(target_arch = "spirv"))]
fn dense_backward_work(params: &DenseBackwardParams, _: Shape<'_>) -> Work {
    let inputs = params.end_input - params.first_input;
    let [samples, inputs, outputs] = wide([params.samples, inputs, 4 * params.columns]);
    let masked = u64::from(params.rectified) * inputs;
    Work {
        flops: 2 * samples * inputs * outputs,
        bytes: NUMBER * (samples * (inputs + masked + outputs) + inputs * outputs),
    }
}

/// The gradient of a layer's inputs, `dL/dx_i = sum_o W_oi dL/dy_o` of Eq. 2 and 10: samples along x and y, blocks of
/// eight inputs from `first_input` on along z.
///
/// `input [inputs, stride]`, `output_gradient [4 columns, stride]`, `input_gradient [end_input, stride]`.
#[kernel(threads(64), iterations = MAX_HIDDEN_WIDTH / 4, fused, z_innermost, lanes(samples), counts(samples), work(dense_backward_work))]
pub fn dense_backward<S: Samples>(
    id: Invocation,
    params: &DenseBackwardParams,
    parameters: Read<Vec4>,
    input: Read<f32>,
    output_gradient: Read<f32>,
    input_gradient: Write<f32>,
) {
    let sample = id.index();
    if sample < params.samples {
        let first = params.first_input + id.workgroup.z * INPUTS_PER_INVOCATION;
        // inputs past the last repeat it, and are not written
        let last = params.inputs - 1;
        let (weight, columns) = (params.weight, params.columns);
        let at0 = weight + least(first, last) * columns;
        let at1 = weight + least(first + 1, last) * columns;
        let at2 = weight + least(first + 2, last) * columns;
        let at3 = weight + least(first + 3, last) * columns;
        let at4 = weight + least(first + 4, last) * columns;
        let at5 = weight + least(first + 5, last) * columns;
        let at6 = weight + least(first + 6, last) * columns;
        let at7 = weight + least(first + 7, last) * columns;
        let mut low = LaneVec4::<S>::splat(Vec4::ZERO);
        let mut high = LaneVec4::<S>::splat(Vec4::ZERO);
        let mut at = sample;
        let mut c = 0;
        while c < columns {
            let g = read_column::<S>(output_gradient, at, params.stride);
            let rows = [
                parameters.read(at0 + c),
                parameters.read(at1 + c),
                parameters.read(at2 + c),
                parameters.read(at3 + c),
            ];
            low = add_transposed(low, rows, g);
            let rows = [
                parameters.read(at4 + c),
                parameters.read(at5 + c),
                parameters.read(at6 + c),
                parameters.read(at7 + c),
            ];
            high = add_transposed(high, rows, g);
            at += 4 * params.stride;
            c += 1;
        }
        write_gradient(params, input, input_gradient, low, first, sample);
        write_gradient(params, input, input_gradient, high, first + 4, sample);
    }
}

/// Writes four rows of a gradient, as many of them as there are.
#[inline(always)]
fn write_gradient<S: Samples>(
    params: &DenseBackwardParams,
    input: Read<f32>,
    output: Write<f32>,
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
fn masked<S: Samples>(params: &DenseBackwardParams, input: Read<f32>, value: S, at: u32) -> S {
    if params.rectified != 0 { value.where_positive(S::read(input, at)) } else { value }
}

/// Parameters of [`dense_weight_backward`].
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct DenseWeightBackwardParams {
    /// Samples in the chunk.
    pub samples: u32,
    /// The chunk's first sample, of all.
    pub first_sample: u32,
    /// Distance of two rows in `input` and `output_gradient`, a multiple of 4.
    pub stride: u32,
    /// Inputs of the layer.
    pub inputs: u32,
    /// Columns of four outputs, padding included.
    pub columns: u32,
    /// Where the layer's weights begin.
    pub weight: u32,
    /// Where the layer's biases begin.
    pub bias: u32,
    /// Units of the part.
    pub units: u32,
    /// Samples of a slice.
    pub slice: u32,
    /// Slices that `partial` has room for: a slice's place is its number modulo this.
    pub places: u32,
    /// Distance of two slices in `partial`: the parameters of the whole network.
    pub parameters: u32,
}

/// `sum + x g`
#[inline(always)]
fn add_scaled<L: Lane>(sum: LaneVec4<L>, x: L, g: LaneVec4<L>) -> LaneVec4<L> {
    LaneVec4 {
        x: x.mul_add(g.x, sum.x),
        y: x.mul_add(g.y, sum.y),
        z: x.mul_add(g.z, sum.z),
        w: x.mul_add(g.w, sum.w),
    }
}

/// Samples whose values are read together where [`Lane::READS_FOUR`]. Places are then counted in fours: a compiler must know
/// that they are multiples of four.
const FEW: u32 = 4;

/// [`read_column`] of a few samples.
#[inline(always)]
fn read_few<L: Lane>(rows: Read<f32>, first: u32, stride: u32) -> [LaneVec4<L>; FEW as usize] {
    let few = [
        few_of_row::<L>(rows, first),
        few_of_row::<L>(rows, first + stride),
        few_of_row::<L>(rows, first + 2 * stride),
        few_of_row::<L>(rows, first + 3 * stride),
    ];
    let [x, y, z, w] = few;
    [
        LaneVec4 { x: x[0], y: y[0], z: z[0], w: w[0] },
        LaneVec4 { x: x[1], y: y[1], z: z[1], w: w[1] },
        LaneVec4 { x: x[2], y: y[2], z: z[2], w: w[2] },
        LaneVec4 { x: x[3], y: y[3], z: z[3], w: w[3] },
    ]
}

/// A few values of a row.
#[inline(always)]
fn few_of_row<L: Lane>(rows: Read<f32>, first: u32) -> [L; FEW as usize] {
    let first = FEW * first;
    [
        L::read(rows, first),
        L::read(rows, first + 1),
        L::read(rows, first + 2),
        L::read(rows, first + 3),
    ]
}

/// [`add_scaled`] of a few samples, one after another.
#[inline(always)]
fn add_few<L: Lane>(
    sum: LaneVec4<L>,
    [x0, x1, x2, x3]: [L; FEW as usize],
    [g0, g1, g2, g3]: [LaneVec4<L>; FEW as usize],
) -> LaneVec4<L> {
    let sum = add_scaled(sum, x0, g0);
    let sum = add_scaled(sum, x1, g1);
    let sum = add_scaled(sum, x2, g2);
    add_scaled(sum, x3, g3)
}

/// `sum + g`
#[inline(always)]
pub fn add<L: Lane>(sum: LaneVec4<L>, g: LaneVec4<L>) -> LaneVec4<L> {
    LaneVec4 { x: sum.x + g.x, y: sum.y + g.y, z: sum.z + g.z, w: sum.w + g.w }
}

/// The same sums, each of them [settled](Lane::settled).
#[inline(always)]
pub fn settled<L: Lane>(sum: LaneVec4<L>) -> LaneVec4<L> {
    let LaneVec4 { x, y, z, w } = sum;
    LaneVec4 { x: x.settled(), y: y.settled(), z: z.settled(), w: w.settled() }
}

/// What all lanes have, and what was left over.
#[inline(always)]
fn total<L: Lane, M: Lane>(sum: LaneVec4<L>, rest: LaneVec4<M>) -> Vec4 {
    Vec4::new(
        sum.x.sum() + rest.x.sum(),
        sum.y.sum() + rest.y.sum(),
        sum.z.sum() + rest.z.sum(),
        sum.w.sum() + rest.w.sum(),
    )
}

/// What [`dense_weight_backward`] computes and moves.
#[cfg(not(target_arch = "spirv"))]
fn dense_weight_backward_work(params: &DenseWeightBackwardParams, shape: Shape<'_>) -> Work {
    let [samples, inputs, outputs] = wide([params.samples, params.inputs, 4 * params.columns]);
    Work {
        flops: samples * (2 * inputs + 1) * outputs,
        bytes: NUMBER
            * (samples * (inputs + outputs) + shape.workgroups_z * (inputs + 1) * outputs),
    }
}

/// The gradient of a layer's weights and biases, `dL/dW_oi = sum x_i dL/dy_o` and `dL/db_o = sum dL/dy_o` of Eq. 2 and
/// 10, the sums over the samples of a slice: blocks of four inputs and a column of outputs along x and y (the column
/// counts fastest; behind the last block the biases), slices along z.
///
/// `unit [units + 1, 2]`, see [`unit_begin`](crate::unit::unit_begin()); `input [inputs, stride]`, `output_gradient
/// [4 columns, stride]`, `partial [places, parameters]`. The slices are those that have a sample in the chunk. One that
/// began in the chunk before goes on from its sums there.
#[kernel(threads(64), iterations = MAX_SLICE + 2 * SEARCH, fused, lanes, counts(samples), work(dense_weight_backward_work))]
pub fn dense_weight_backward<L: Lane>(
    id: Invocation,
    params: &DenseWeightBackwardParams,
    unit: Read<u32>,
    input: Read<f32>,
    output_gradient: Read<f32>,
    partial: Write<Vec4>,
) {
    let index = id.index();
    let (columns, inputs) = (params.columns, params.inputs);
    let blocks = (inputs - 1) / WEIGHT_ROWS_PER_INVOCATION + 1;
    let chunk = params.first_sample;
    let slice = slice_of_sample(unit, params.units, params.slice, chunk) + id.workgroup.z;
    let (first, last) = samples_of_slice(unit, params.units, params.slice, slice);
    // counted from the chunk's first sample
    let begin = if first > chunk { first - chunk } else { 0 };
    let end = if last > chunk { least(last - chunk, params.samples) } else { 0 };
    if index < (blocks + 1) * columns && begin < end {
        let (block, column) = (index / columns, index % columns);
        let to = slice % params.places * params.parameters + column;
        // one lane goes on where the chunk before has ended: the sum does not depend on where that was
        let goes_on = first < chunk;
        let (of_lanes, of_rest) = (goes_on && L::WIDTH == 1, goes_on && L::WIDTH > 1);
        let g = 4 * column * params.stride;
        if block < blocks {
            let first = block * WEIGHT_ROWS_PER_INVOCATION;
            let to = to + params.weight + first * columns;
            // inputs past the last repeat it
            let to1 = to + least(1, inputs - 1 - first) * columns;
            let to2 = to + least(2, inputs - 1 - first) * columns;
            let to3 = to + least(3, inputs - 1 - first) * columns;
            let to = [to, to1, to2, to3];
            let before = begin_sums::<L>(partial, to, of_lanes);
            let (rows, stride) = (input_rows(params, first), params.stride);
            let (sums, sample) =
                sum_products::<L>(before, input, rows, output_gradient, g, stride, [begin, end]);
            let [sum0, sum1, sum2, sum3] = sums;
            let (sum0, sum1) = (settled(sum0), settled(sum1));
            let (sum2, sum3) = (settled(sum2), settled(sum3));
            let before = begin_sums::<L::One>(partial, to, of_rest);
            let range = [sample, end];
            let (rests, _) =
                sum_each::<L::One>(before, input, rows, output_gradient, g, stride, range);
            let [rest0, rest1, rest2, rest3] = rests;
            partial.write(to[0], total(sum0, rest0));
            if first + 1 < inputs {
                partial.write(to[1], total(sum1, rest1));
            }
            if first + 2 < inputs {
                partial.write(to[2], total(sum2, rest2));
            }
            if first + 3 < inputs {
                partial.write(to[3], total(sum3, rest3));
            }
        } else {
            let to = to + params.bias;
            let range = [begin, end];
            let before = begin_sum::<L>(partial, to, of_lanes);
            let (sum, sample) = sum_lanes::<L>(before, output_gradient, g, params.stride, range);
            let sum = settled(sum);
            let before = begin_sum::<L::One>(partial, to, of_rest);
            let range = [sample, end];
            let (rest, _) =
                sum_each_lane::<L::One>(before, output_gradient, g, params.stride, range);
            partial.write(to, total(sum, rest));
        }
    }
}

/// What a sum begins with: zeros, or what it has of the chunk before.
#[inline(always)]
fn begin_sum<L: Lane>(partial: Write<Vec4>, at: u32, goes_on: bool) -> LaneVec4<L> {
    LaneVec4::<L>::splat(if goes_on { partial.read(at) } else { Vec4::ZERO })
}

/// As [`begin_sum`], for four sums.
#[inline(always)]
fn begin_sums<L: Lane>(partial: Write<Vec4>, at: [u32; 4], goes_on: bool) -> [LaneVec4<L>; 4] {
    [
        begin_sum(partial, at[0], goes_on),
        begin_sum(partial, at[1], goes_on),
        begin_sum(partial, at[2], goes_on),
        begin_sum(partial, at[3], goes_on),
    ]
}

/// Sums of the products of four inputs and a column of outputs' gradients, over as many whole lanes of samples as there are;
/// and the first sample after those.
#[inline(always)]
fn sum_products<L: Lane>(
    before: [LaneVec4<L>; 4],
    input: Read<f32>,
    rows: [u32; 4],
    output_gradient: Read<f32>,
    g: u32,
    stride: u32,
    [begin, end]: [u32; 2],
) -> ([LaneVec4<L>; 4], u32) {
    if L::READS_FOUR {
        let first = begin.next_multiple_of(FEW);
        let range = [begin, least(first, end)];
        let (sums, _) = sum_each(before, input, rows, output_gradient, g, stride, range);
        let range = [first, end];
        let (sums, sample) = sum_few(sums, input, rows, output_gradient, g, stride, range);
        sum_each(sums, input, rows, output_gradient, g, stride, [sample, end])
    } else {
        sum_each(before, input, rows, output_gradient, g, stride, [begin, end])
    }
}

/// As [`sum_products`], with as many samples at a time as there are lanes.
#[loops]
#[inline(always)]
fn sum_each<L: Lane>(
    before: [LaneVec4<L>; 4],
    input: Read<f32>,
    [row0, row1, row2, row3]: [u32; 4],
    output_gradient: Read<f32>,
    g: u32,
    stride: u32,
    [begin, end]: [u32; 2],
) -> ([LaneVec4<L>; 4], u32) {
    // sixteen sums: four variables, for an aggregate of them would stay in memory
    let [mut sum0, mut sum1, mut sum2, mut sum3] = before;
    let mut sample = begin;
    while sample + L::WIDTH <= end {
        let g = read_column::<L>(output_gradient, g + sample, stride);
        sum0 = add_scaled(sum0, L::read(input, row0 + sample), g);
        sum1 = add_scaled(sum1, L::read(input, row1 + sample), g);
        sum2 = add_scaled(sum2, L::read(input, row2 + sample), g);
        sum3 = add_scaled(sum3, L::read(input, row3 + sample), g);
        sample += L::WIDTH;
    }
    ([sum0, sum1, sum2, sum3], sample)
}

/// As [`sum_products`], for a single lane, from a multiple of [`FEW`] on and a few samples at a time.
#[loops]
#[inline(always)]
fn sum_few<L: Lane>(
    before: [LaneVec4<L>; 4],
    input: Read<f32>,
    [row0, row1, row2, row3]: [u32; 4],
    output_gradient: Read<f32>,
    g: u32,
    stride: u32,
    [begin, end]: [u32; 2],
) -> ([LaneVec4<L>; 4], u32) {
    let [mut sum0, mut sum1, mut sum2, mut sum3] = before;
    let [row0, row1, row2, row3] = [row0 / FEW, row1 / FEW, row2 / FEW, row3 / FEW];
    let (g, stride) = (g / FEW, stride / FEW);
    let mut few = begin / FEW;
    while FEW * few + FEW <= end {
        let g = read_few::<L>(output_gradient, g + few, stride);
        let x0 = few_of_row::<L>(input, row0 + few);
        let x1 = few_of_row::<L>(input, row1 + few);
        let x2 = few_of_row::<L>(input, row2 + few);
        let x3 = few_of_row::<L>(input, row3 + few);
        sum0 = add_few(sum0, x0, g);
        sum1 = add_few(sum1, x1, g);
        sum2 = add_few(sum2, x2, g);
        sum3 = add_few(sum3, x3, g);
        few += 1;
    }
    ([sum0, sum1, sum2, sum3], FEW * few)
}

/// Sums of a column's four rows, over as many whole lanes of samples as there are; and the first sample after those.
#[inline(always)]
fn sum_lanes<L: Lane>(
    before: LaneVec4<L>,
    rows: Read<f32>,
    first: u32,
    stride: u32,
    [begin, end]: [u32; 2],
) -> (LaneVec4<L>, u32) {
    if L::READS_FOUR {
        let few = begin.next_multiple_of(FEW);
        let (sum, _) = sum_each_lane(before, rows, first, stride, [begin, least(few, end)]);
        let (sum, sample) = sum_few_lanes(sum, rows, first, stride, [few, end]);
        sum_each_lane(sum, rows, first, stride, [sample, end])
    } else {
        sum_each_lane(before, rows, first, stride, [begin, end])
    }
}

/// As [`sum_lanes`], with as many samples at a time as there are lanes.
#[loops]
#[inline(always)]
fn sum_each_lane<L: Lane>(
    before: LaneVec4<L>,
    rows: Read<f32>,
    first: u32,
    stride: u32,
    [begin, end]: [u32; 2],
) -> (LaneVec4<L>, u32) {
    let mut sum = before;
    let mut sample = begin;
    while sample + L::WIDTH <= end {
        sum = add(sum, read_column::<L>(rows, first + sample, stride));
        sample += L::WIDTH;
    }
    (sum, sample)
}

/// As [`sum_lanes`], for a single lane, from a multiple of [`FEW`] on and a few samples at a time.
#[loops]
#[inline(always)]
fn sum_few_lanes<L: Lane>(
    before: LaneVec4<L>,
    rows: Read<f32>,
    first: u32,
    stride: u32,
    [begin, end]: [u32; 2],
) -> (LaneVec4<L>, u32) {
    let mut sum = before;
    let mut few = begin / FEW;
    while FEW * few + FEW <= end {
        let [g0, g1, g2, g3] = read_few::<L>(rows, first / FEW + few, stride / FEW);
        sum = add(add(add(add(sum, g0), g1), g2), g3);
        few += 1;
    }
    (sum, FEW * few)
}

/// Where the rows of a block's inputs begin; inputs past the last repeat it.
#[inline(always)]
fn input_rows(params: &DenseWeightBackwardParams, first: u32) -> [u32; 4] {
    let (last, stride) = (params.inputs - 1, params.stride);
    [
        first * stride,
        least(first + 1, last) * stride,
        least(first + 2, last) * stride,
        least(first + 3, last) * stride,
    ]
}

/// Parameters of [`dense_weight_sum`].
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct DenseWeightSumParams {
    /// Vectors of parameters of the whole network.
    pub parameters: u32,
    /// The group's first sample, of all.
    pub first_sample: u32,
    /// Samples in the group.
    pub samples: u32,
    /// Units of the part.
    pub units: u32,
    /// Samples of a slice.
    pub slice: u32,
    /// See [`DenseWeightBackwardParams::places`].
    pub places: u32,
}

/// What [`dense_weight_sum`] computes and moves.
#[cfg(not(target_arch = "spirv"))]
fn dense_weight_sum_work(params: &DenseWeightSumParams, _: Shape<'_>) -> Work {
    let slices = params.samples.div_ceil(params.slice);
    let [parameters, slices] = wide([params.parameters, slices]);
    Work { flops: 4 * parameters * slices, bytes: VECTOR * parameters * (slices + 2) }
}

/// Adds what [`dense_weight_backward`] found in each slice that ends in a group of chunks to the sum of the slice's unit, in
/// their order: `unit [units + 1, 2]`, see [`unit_begin`](crate::unit::unit_begin()); `partial [places, parameters]`,
/// `unit_sum [units, parameters]`.
#[kernel(threads(64), iterations = MAX_SLICES + MAX_CAMERAS + 2 * SEARCH, counts(samples), work(dense_weight_sum_work))]
pub fn dense_weight_sum(
    id: Invocation,
    params: &DenseWeightSumParams,
    unit: Read<u32>,
    partial: Read<Vec4>,
    unit_sum: Write<Vec4>,
) {
    let (index, parameters) = (id.index(), params.parameters);
    if index < parameters && params.samples > 0 {
        let end = params.first_sample + params.samples;
        let mut slice = slice_of_sample(unit, params.units, params.slice, params.first_sample);
        let mut owner = unit_of_slice(unit, params.units, slice);
        while owner < params.units && first_sample_of(unit, owner) < end {
            // of the last unit, only those that are whole
            let first = first_sample_of(unit, owner);
            let is_whole = first_sample_of(unit, owner + 1) <= end;
            let whole = first_slice_of(unit, owner) + (end - first) / params.slice;
            let stop = if is_whole { first_slice_of(unit, owner + 1) } else { whole };
            let at = owner * parameters + index;
            let mut sum = unit_sum.read(at);
            while slice < stop {
                sum += partial.read(slice % params.places * parameters + index);
                slice += 1;
            }
            unit_sum.write(at, sum);
            owner += 1;
        }
    }
}

/// Parameters of [`dense_unit_sum`].
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct DenseUnitSumParams {
    /// Vectors of parameters of the whole network.
    pub parameters: u32,
    /// Units of the part.
    pub units: u32,
}

/// What [`dense_unit_sum`] computes and moves.
#[cfg(not(target_arch = "spirv"))]
fn dense_unit_sum_work(params: &DenseUnitSumParams, _: Shape<'_>) -> Work {
    let [parameters, units] = wide([params.parameters, params.units]);
    Work { flops: 4 * parameters * units, bytes: VECTOR * parameters * (units + 2) }
}

/// Adds the units' sums of [`dense_weight_sum`] in their order: `unit_sum [units, parameters]`, `gradient [parameters]`.
#[kernel(threads(64), iterations = MAX_CAMERAS, work(dense_unit_sum_work))]
pub fn dense_unit_sum(
    id: Invocation,
    params: &DenseUnitSumParams,
    unit_sum: Read<Vec4>,
    gradient: Write<Vec4>,
) {
    let index = id.index();
    if index < params.parameters {
        let mut sum = gradient.read(index);
        let mut unit = 0;
        while unit < params.units {
            sum += unit_sum.read(unit * params.parameters + index);
            unit += 1;
        }
        gradient.write(index, sum);
    }
}

#[cfg(test)]
mod tests {
    extern crate std;

    use std::vec;
    use std::vec::Vec;

    use glam::UVec3;

    use super::*;
    use crate::dense::{DenseParams, dense};
    use organza_kernel::samples::Four;

    fn numbers(count: u32) -> Vec<f32> {
        (0..count).map(|i| (i * 37 % 101) as f32 / 50.0 - 1.0).collect()
    }

    fn vectors(count: u32) -> Vec<Vec4> {
        numbers(4 * count).as_chunks::<4>().0.iter().copied().map(Vec4::from_array).collect()
    }

    /// The invocations of two workgroups.
    fn invocations(workgroup_z: u32) -> impl Iterator<Item = Invocation> {
        (0..128).map(move |x| {
            let workgroup = UVec3::new(x / 64, 0, workgroup_z);
            let local = UVec3::new(x % 64, 0, 0);
            Invocation::new(local, workgroup, UVec3::new(2, 1, 2), UVec3::new(64, 1, 1))
        })
    }

    /// An invocation of a GPU, which reads without a check: here every index is checked.
    #[test]
    fn layers_of_four_samples_are_those_of_one() {
        for samples in [1, 2, 3, 4, 63, 70] {
            let (stride, inputs, columns) = (samples + 3, 11, 8);
            let (weight, bias) = (3, 3 + inputs * columns);
            let params = DenseParams { samples, stride, inputs, columns, weight, bias };
            let parameters = vectors(3 + (inputs + 1) * columns);
            let input = numbers(inputs * stride);
            let len = (4 * columns * stride) as usize;
            let (mut one, mut four) = (vec![9.0; len], vec![9.0; len]);
            let back = DenseBackwardParams {
                samples,
                stride,
                inputs,
                columns,
                weight,
                first_input: 0,
                end_input: inputs,
                rectified: 1,
            };
            let gradient = numbers(4 * columns * stride);
            let back_len = (inputs * stride) as usize;
            let (mut back_one, mut back_four) = (vec![9.0; back_len], vec![9.0; back_len]);
            let (weights, input) = (Read::from(&parameters[..]), Read::from(&input[..]));
            let gradient = Read::from(&gradient[..]);
            for id in [0, 1].into_iter().flat_map(invocations) {
                dense::<f32>(id, &params, weights, input, Write::from(&mut one[..]));
                dense::<Four>(id.of(4), &params, weights, input, Write::from(&mut four[..]));
                let output = Write::from(&mut back_one[..]);
                dense_backward::<f32>(id, &back, weights, input, gradient, output);
                let output = Write::from(&mut back_four[..]);
                dense_backward::<Four>(id.of(4), &back, weights, input, gradient, output);
            }
            assert_eq!(one, four, "{samples} samples");
            assert_eq!(back_one, back_four, "{samples} samples on the way back");
            assert!(four.iter().any(|&value| value > 0.0 && value != 9.0));
        }
    }

    /// As above: slices that begin and end anywhere, and what a GPU reads together.
    #[test]
    fn weights_are_summed_sample_by_sample() {
        for (samples, slice) in [(1, 9), (3, 9), (4, 4), (70, 33), (64, 7), (12, 1), (11, 3)] {
            let (stride, inputs, columns) = ((samples + 3_u32).next_multiple_of(4), 6, 2);
            let slices = samples.div_ceil(slice);
            let parameters = (inputs + 1) * columns;
            let params = DenseWeightBackwardParams {
                samples,
                first_sample: 0,
                stride,
                inputs,
                columns,
                weight: 0,
                bias: inputs * columns,
                units: 1,
                slice,
                places: slices,
                parameters,
            };
            let (input, gradient) = (numbers(inputs * stride), numbers(4 * columns * stride));
            let mut partial = vec![Vec4::ZERO; (slices * parameters) as usize];
            for id in (0..slices).flat_map(invocations) {
                dense_weight_backward::<f32>(
                    id,
                    &params,
                    Read::from(&[0, 0, samples, slices][..]),
                    Read::from(&input[..]),
                    Read::from(&gradient[..]),
                    Write::from(&mut partial[..]),
                );
            }
            for index in 0..slices * parameters {
                let (at, place) = (index / parameters, index % parameters);
                let (row, column) = (place / columns, place % columns);
                let sum = |output: u32| {
                    (at * slice..samples.min((at + 1) * slice)).fold(0.0, |sum, sample| {
                        let g = gradient[((4 * column + output) * stride + sample) as usize];
                        let x = match row < inputs {
                            true => input[(row * stride + sample) as usize],
                            false => 1.0,
                        };
                        x * g + sum
                    })
                };
                let expected = Vec4::from_array([0, 1, 2, 3].map(sum));
                assert_eq!(partial[index as usize], expected, "{samples} samples, {index}");
            }
        }
    }
}
