//! The derivatives of the dense layers (Eq. 2 and 10), from dL/d of a layer's outputs before the activation.
//!
//! A gradient has the layout of its tensor: `[rows, stride]` for inputs and outputs, and for a network's parameters the layout
//! of [`dense`](crate::dense), with zeros as padding.

use glam::Vec4;

use crate::limits::{MAX_CAMERAS, MAX_HIDDEN_WIDTH, MAX_SLICE};
#[cfg(not(target_arch = "spirv"))]
use crate::weight_tile::tiles;
use crate::weight_tile::{STAGED, add_tile, tile_of};
use muslin::binned;
use muslin::lane_vec4::LaneVec4;
use muslin::prelude::*;
use muslin::samples::{Four, Samples};

/// Inputs of a layer whose gradient one invocation of [`dense_backward`] computes.
const INPUTS_PER_INVOCATION: u32 = 8;

/// Inputs of a layer that one invocation of [`dense_weight_backward`] takes; its outputs are a column of four.
const WEIGHT_ROWS_PER_INVOCATION: u32 = 4;

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

/// Four rows of a buffer, from a row on.
#[inline(always)]
fn read_column<S: Samples>(buffer: ReadFours<f32>, first: u32, stride: u32) -> LaneVec4<S> {
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

/// Parameters of [`dense_weight_backward`].
#[params]
pub struct DenseWeightBackwardParams {
    /// Samples in the chunk.
    pub samples: u32,
    /// Index of the chunk's first sample, among all samples.
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
    /// Cameras of the part.
    pub cameras: u32,
    /// Words of a camera's mask.
    pub words: u32,
    /// 1 for samples of the transmittance network, 0 for samples of the color network, which are the pairs.
    pub of_rays: u32,
    /// Samples of a slice.
    pub slice: u32,
    /// Vectors of parameters of the whole network.
    pub parameters: u32,
    /// 0 or 1, in turns from chunk to chunk: which half of `carry` the chunk before has written.
    pub turn: u32,
}

/// Iterations of a search among all cameras.
const SEARCH: u32 = u32::BITS;

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

/// Samples of a quad: neighbors, whose values are read as one vector where [`Lane::READS_FOUR`]. Rows are then counted in quads.
pub const QUAD: u32 = 4;

/// The place of a quad in a row, and the range of samples that count.
#[derive(Clone, Copy)]
pub struct QuadCursor {
    /// Index of the quad in its row.
    pub at: u32,
    /// The first sample that counts.
    pub begin: u32,
    /// Exclusive end.
    pub end: u32,
}

impl QuadCursor {
    /// Whether a loop goes on with this quad. With `WHOLE`, it takes quads up to the last whole one. Without, it takes the quads
    /// of which only some samples count: before the first whole quad, and after the last one.
    #[inline(always)]
    fn is_next<const WHOLE: bool>(self) -> bool {
        let first = QUAD * self.at;
        let is_last = first + QUAD > self.end;
        if WHOLE { !is_last } else { first < self.end && (first < self.begin || is_last) }
    }
}

/// [`read_column`] of a quad.
#[inline(always)]
fn read_quad<L: Lane, const WHOLE: bool>(
    rows: ReadFours<f32>,
    first: u32,
    stride: u32,
    cursor: QuadCursor,
) -> [LaneVec4<L>; QUAD as usize] {
    let quads = [
        quad_of_row::<L, WHOLE>(rows, first, cursor),
        quad_of_row::<L, WHOLE>(rows, first + stride, cursor),
        quad_of_row::<L, WHOLE>(rows, first + 2 * stride, cursor),
        quad_of_row::<L, WHOLE>(rows, first + 3 * stride, cursor),
    ];
    let [x, y, z, w] = quads;
    [
        LaneVec4 { x: x[0], y: y[0], z: z[0], w: w[0] },
        LaneVec4 { x: x[1], y: y[1], z: z[1], w: w[1] },
        LaneVec4 { x: x[2], y: y[2], z: z[2], w: w[2] },
        LaneVec4 { x: x[3], y: y[3], z: z[3], w: w[3] },
    ]
}

/// A quad of a row, with zeros for samples that do not count.
#[inline(always)]
pub fn quad_of_row<L: Lane, const WHOLE: bool>(
    rows: ReadFours<f32>,
    row: u32,
    cursor: QuadCursor,
) -> [L; QUAD as usize] {
    let [x, y, z, w] = Four::read_vector(rows, row + cursor.at).each();
    let kept = |value: L, place: u32| {
        let sample = QUAD * cursor.at + place;
        if WHOLE || sample.wrapping_sub(cursor.begin) < cursor.end - cursor.begin {
            value
        } else {
            L::splat(0.0)
        }
    };
    [kept(x, 0), kept(y, 1), kept(z, 2), kept(w, 3)]
}

/// `sum + x g` of a quad, one sample after another.
#[inline(always)]
pub fn add_quad<L: Lane>(
    sum: LaneVec4<L>,
    [x0, x1, x2, x3]: [L; QUAD as usize],
    [g0, g1, g2, g3]: [LaneVec4<L>; QUAD as usize],
) -> LaneVec4<L> {
    let sum = add_scaled(sum, x0, g0);
    let sum = add_scaled(sum, x1, g1);
    let sum = add_scaled(sum, x2, g2);
    add_scaled(sum, x3, g3)
}

/// The sum of all lanes, and of the samples that were left over.
#[inline(always)]
pub fn total<L: Lane, M: Lane>(sum: LaneVec4<L>, rest: LaneVec4<M>) -> Vec4 {
    Vec4::new(
        sum.x.sum() + rest.x.sum(),
        sum.y.sum() + rest.y.sum(),
        sum.z.sum() + rest.z.sum(),
        sum.w.sum() + rest.w.sum(),
    )
}

/// Adds the gradient of a layer's weights and biases, `dL/dW_oi = sum x_i dL/dy_o` and `dL/db_o = sum dL/dy_o` of Eq. 2
/// and 10, to `sum`: blocks of four inputs and a column of outputs along x and y (the column counts fastest; behind the
/// last block the biases), windows of as many samples as a slice has along z.
///
/// The samples of each camera are cut into slices of the same length, from the camera's first sample on; the last one may
/// be shorter. A slice is summed in f32, and slices [exactly](binned): neither depends on what else is in the part. An
/// invocation goes through the slices that begin in its window; the first one also goes on with a slice of the chunk
/// before.
///
/// `first_pair [cameras * words + 1]`; `first_sample [pairs + 1]`, which is not read for pairs; `input [inputs, stride]`,
/// `output_gradient [4 columns, stride]`; `carry [2, 4 parameters]`, the sums of a slice that ends in another chunk;
/// `sum [17, 4 parameters, 2]`.
///
/// In the variant, a workgroup takes a [tile](crate::weight_tile) of the weights.
#[kernel(threads(64), over(weight_invocations(params.inputs, params.columns), params.samples.div_ceil(params.slice)), iterations = 4 * MAX_SLICE + MAX_CAMERAS + SEARCH, fused, lanes, counts(samples))]
pub fn dense_weight_backward<L: Lane>(
    id: Invocation,
    params: &DenseWeightBackwardParams,
    first_pair: Read<u32>,
    first_sample: Read<u32>,
    input: ReadFours<f32>,
    output_gradient: ReadFours<f32>,
    carry: Write<f32>,
    sum: Write<impl SumWord>,
    staged: &mut impl SharedTile<Vec4, STAGED>,
) {
    let slice = params.slice;
    let blocks = (params.inputs - 1) / WEIGHT_ROWS_PER_INVOCATION + 1;
    let place = place_of(id.index(), params.columns);
    let tile = tile_of(params, id.workgroup_index());
    // all invocations of a workgroup wait for each other, those without weights too
    let has_part = if staged.is_shared() { tile[0] < params.inputs } else { place[0] <= blocks };
    let end = params.first_sample + params.samples;
    let window = params.first_sample + id.workgroup.z * slice;
    if has_part && window < end {
        let stop = min(window + slice, end);
        let mut camera = camera_of(params, first_pair, first_sample, window);
        let begin = first_of(params, first_pair, first_sample, camera);
        let mut camera_end = first_of(params, first_pair, first_sample, camera + 1);
        let before = (window - begin) % slice;
        let is_first = id.workgroup.z == 0 || before == 0;
        let mut first =
            if is_first { window - before } else { min(window - before + slice, camera_end) };
        while first < stop {
            if first == camera_end {
                camera += 1;
                camera_end = first_of(params, first_pair, first_sample, camera + 1);
            } else {
                let last = min(first + slice, camera_end);
                let part = part_of(params, [first, last]);
                if staged.is_shared() {
                    let rows = [input, output_gradient];
                    add_tile(id, params, tile, part, rows, carry, sum, staged);
                } else {
                    add_slice::<L>(params, place, part, input, output_gradient, carry, sum);
                }
                first = last;
            }
        }
    }
}

/// Invocations of [`dense_weight_backward`] for a layer: neighbors take four blocks of inputs together. The variant needs no
/// more, but for narrow layers of many inputs.
#[cfg(not(target_arch = "spirv"))]
fn weight_invocations(inputs: u32, columns: u32) -> u32 {
    let blocks = inputs.div_ceil(WEIGHT_ROWS_PER_INVOCATION) + 1;
    let plain = blocks.next_multiple_of(BLOCKS_TOGETHER) * columns;
    plain.max(64 * tiles(inputs, columns))
}

/// Blocks of inputs of which neighboring invocations take eight columns each.
const BLOCKS_TOGETHER: u32 = 4;

/// The block of inputs and the column of outputs of an invocation. The 32 lanes of a subgroup take 4 blocks and 8 columns, where
/// there are so many: their rows lie in 48 cache lines, while 2 blocks and 16 columns lie in 72.
#[inline(always)]
fn place_of(index: u32, columns: u32) -> [u32; 2] {
    if columns.is_multiple_of(8) {
        let group = index / (BLOCKS_TOGETHER * columns);
        let at = index % (BLOCKS_TOGETHER * columns);
        [BLOCKS_TOGETHER * group + at / 8 % BLOCKS_TOGETHER, at / 32 * 8 + at % 8]
    } else {
        [index / columns, index % columns]
    }
}

/// The first sample of a camera.
#[inline(always)]
fn first_of(
    params: &DenseWeightBackwardParams,
    first_pair: Read<u32>,
    first_sample: Read<u32>,
    camera: u32,
) -> u32 {
    let pair = first_pair.read(camera * params.words);
    if params.of_rays != 0 { first_sample.read(pair) } else { pair }
}

/// The camera of a sample.
#[loops]
#[inline(always)]
fn camera_of(
    params: &DenseWeightBackwardParams,
    first_pair: Read<u32>,
    first_sample: Read<u32>,
    sample: u32,
) -> u32 {
    let mut low = 0;
    let mut high = params.cameras;
    while low + 1 < high {
        let middle = (low + high) / 2;
        let is_before = first_of(params, first_pair, first_sample, middle) <= sample;
        low = if is_before { middle } else { low };
        high = if is_before { high } else { middle };
    }
    low
}

/// The part of a slice that lies in a chunk.
#[derive(Clone, Copy)]
pub struct SlicePart {
    /// The first sample, counted from the chunk's.
    pub begin: u32,
    /// Exclusive end.
    pub end: u32,
    /// Whether the slice begins in the chunk before: its sums go on.
    pub continues: bool,
    /// Whether it ends in this one.
    pub is_whole: bool,
    /// Where in `carry` the chunk before has left its sums.
    pub before: u32,
    /// Where this one leaves them.
    pub after: u32,
}

/// The part of the slice from a sample to another one.
#[inline(always)]
fn part_of(params: &DenseWeightBackwardParams, [first, last]: [u32; 2]) -> SlicePart {
    let chunk = params.first_sample;
    let values = 4 * params.parameters;
    SlicePart {
        begin: if first > chunk { first - chunk } else { 0 },
        end: min(last - chunk, params.samples),
        continues: first < chunk,
        is_whole: last <= chunk + params.samples,
        before: params.turn * values,
        after: (1 - params.turn) * values,
    }
}

/// Four outputs of a layer: every `step`th from `first` on, of those before `end`.
#[derive(Clone, Copy)]
pub struct Outputs {
    /// The first one.
    pub first: u32,
    /// Distance of two.
    pub step: u32,
    /// The outputs of the layer.
    pub end: u32,
}

/// Adds an invocation's sums over a slice; leaves them in `carry` if the slice ends in another chunk.
#[inline(always)]
fn add_slice<L: Lane>(
    params: &DenseWeightBackwardParams,
    [block, column]: [u32; 2],
    part: SlicePart,
    input: ReadFours<f32>,
    output_gradient: ReadFours<f32>,
    carry: Write<f32>,
    sum: Write<impl SumWord>,
) {
    let inputs = params.inputs;
    let columns = params.columns;
    let blocks = (inputs - 1) / WEIGHT_ROWS_PER_INVOCATION + 1;
    let stride = params.stride;
    let g = 4 * column * stride;
    let outputs = Outputs { first: 4 * column, step: 1, end: 4 * columns };
    if block < blocks {
        let first = block * WEIGHT_ROWS_PER_INVOCATION;
        let to = 4 * (params.weight + first * columns);
        // inputs past the last repeat it
        let to1 = to + 4 * min(1, inputs - 1 - first) * columns;
        let to2 = to + 4 * min(2, inputs - 1 - first) * columns;
        let to3 = to + 4 * min(3, inputs - 1 - first) * columns;
        let from = [part.before + to, part.before + to1, part.before + to2, part.before + to3];
        let rows = Rows { input, rows: input_rows(params, first), output_gradient, g, stride };
        let [sum0, sum1, sum2, sum3] = sum_slice::<L, false>(rows, carry, from, part, outputs);
        add_sums::<true>(params, carry, sum, part, to, outputs, sum0);
        if first + 1 < inputs {
            add_sums::<true>(params, carry, sum, part, to1, outputs, sum1);
        }
        if first + 2 < inputs {
            add_sums::<true>(params, carry, sum, part, to2, outputs, sum2);
        }
        if first + 3 < inputs {
            add_sums::<true>(params, carry, sum, part, to3, outputs, sum3);
        }
    } else {
        let to = 4 * params.bias;
        let from = [part.before + to; 4];
        let rows = Rows { input, rows: [0; 4], output_gradient, g, stride };
        let [sum0, _, _, _] = sum_slice::<L, true>(rows, carry, from, part, outputs);
        add_sums::<true>(params, carry, sum, part, to, outputs, sum0);
    }
}

/// The rows of an invocation: four of inputs, and a column of outputs' gradients.
#[derive(Clone, Copy)]
struct Rows<'a> {
    /// The layer's inputs.
    input: ReadFours<'a, f32>,
    /// Where four of them begin.
    rows: [u32; 4],
    /// The gradient of the layer's outputs.
    output_gradient: ReadFours<'a, f32>,
    /// Where the column's first row begins.
    g: u32,
    /// Distance of two rows.
    stride: u32,
}

/// The sums of a part of a slice, which go on where the chunk before has ended. With `BIAS`, all inputs are 1: the sum is a bias's.
#[inline(always)]
fn sum_slice<L: Lane, const BIAS: bool>(
    rows: Rows,
    carry: Write<f32>,
    from: [u32; 4],
    part: SlicePart,
    outputs: Outputs,
) -> [Vec4; 4] {
    // one lane goes on where the chunk before has ended: the sum does not depend on where that was
    let lanes_continue = part.continues && L::WIDTH == 1;
    let rest_continues = part.continues && L::WIDTH > 1;
    let sums = begin_sums::<L>(carry, from, outputs, lanes_continue);
    let ([sum0, sum1, sum2, sum3], sample) =
        sum_products::<L, BIAS>(sums, rows, [part.begin, part.end]);
    let sum0 = sum0.materialize();
    let sum1 = sum1.materialize();
    let sum2 = sum2.materialize();
    let sum3 = sum3.materialize();
    let rests = begin_sums::<L::One>(carry, from, outputs, rest_continues);
    let [rest0, rest1, rest2, rest3] = if L::WIDTH > 1 {
        sum_each::<L::One, BIAS>(rests, rows, [sample, part.end]).0
    } else {
        rests
    };
    [total(sum0, rest0), total(sum1, rest1), total(sum2, rest2), total(sum3, rest3)]
}

/// Adds four sums of a slice to the sums of all slices, in the row of parameters that begins at `to`; or leaves them for the
/// next chunk. If they are `WHOLE`, the layer has all four.
#[inline(always)]
pub fn add_sums<const WHOLE: bool>(
    params: &DenseWeightBackwardParams,
    carry: Write<f32>,
    sum: Write<impl SumWord>,
    part: SlicePart,
    to: u32,
    outputs: Outputs,
    value: Vec4,
) {
    let Outputs { first, step, end } = outputs;
    add_sum::<WHOLE>(params, carry, sum, part, to, [first, end], value.x);
    add_sum::<WHOLE>(params, carry, sum, part, to, [first + step, end], value.y);
    add_sum::<WHOLE>(params, carry, sum, part, to, [first + 2 * step, end], value.z);
    add_sum::<WHOLE>(params, carry, sum, part, to, [first + 3 * step, end], value.w);
}

/// As [`add_sums`], of one output, if the layer has it.
#[inline(always)]
fn add_sum<const WHOLE: bool>(
    params: &DenseWeightBackwardParams,
    carry: Write<f32>,
    sum: Write<impl SumWord>,
    part: SlicePart,
    to: u32,
    [output, end]: [u32; 2],
    value: f32,
) {
    if WHOLE || output < end {
        if part.is_whole {
            binned::add(sum, 4 * params.parameters, to + output, value);
        } else {
            carry.write(part.after + to + output, value);
        }
    }
}

/// The start of four sums: zeros, or the sums of the chunk before, of a row of parameters. Outputs past the last repeat it.
#[inline(always)]
pub fn begin_sum<L: Lane>(
    carry: Write<f32>,
    row: u32,
    outputs: Outputs,
    continues: bool,
) -> LaneVec4<L> {
    let Outputs { first, step, end } = outputs;
    LaneVec4::<L>::splat(if continues {
        Vec4::new(
            carry.read(row + min(first, end - 1)),
            carry.read(row + min(first + step, end - 1)),
            carry.read(row + min(first + 2 * step, end - 1)),
            carry.read(row + min(first + 3 * step, end - 1)),
        )
    } else {
        Vec4::ZERO
    })
}

/// As [`begin_sum`], for four rows.
#[inline(always)]
pub fn begin_sums<L: Lane>(
    carry: Write<f32>,
    rows: [u32; 4],
    outputs: Outputs,
    continues: bool,
) -> [LaneVec4<L>; 4] {
    [
        begin_sum(carry, rows[0], outputs, continues),
        begin_sum(carry, rows[1], outputs, continues),
        begin_sum(carry, rows[2], outputs, continues),
        begin_sum(carry, rows[3], outputs, continues),
    ]
}

/// Sums of the products of four inputs and a column of outputs' gradients, over the samples that fill all lanes; and the
/// first sample after them.
#[inline(always)]
fn sum_products<L: Lane, const BIAS: bool>(
    before: [LaneVec4<L>; 4],
    rows: Rows,
    [begin, end]: [u32; 2],
) -> ([LaneVec4<L>; 4], u32) {
    if L::READS_FOUR {
        let cursor = QuadCursor { at: begin / QUAD, begin, end };
        let (sums, cursor) = sum_quads::<L, false, BIAS>(before, rows, cursor);
        let (sums, cursor) = sum_quads::<L, true, BIAS>(sums, rows, cursor);
        let (sums, _) = sum_quads::<L, false, BIAS>(sums, rows, cursor);
        (sums, end)
    } else {
        sum_each::<L, BIAS>(before, rows, [begin, end])
    }
}

/// As [`sum_products`], with as many samples at a time as there are lanes.
#[loops]
#[inline(always)]
fn sum_each<L: Lane, const BIAS: bool>(
    before: [LaneVec4<L>; 4],
    rows: Rows,
    [begin, end]: [u32; 2],
) -> ([LaneVec4<L>; 4], u32) {
    // sixteen sums in four variables: an array of them would stay in memory
    let [mut sum0, mut sum1, mut sum2, mut sum3] = before;
    let Rows { input, rows: [row0, row1, row2, row3], output_gradient, g, stride } = rows;
    let mut sample = begin;
    while sample + L::WIDTH <= end {
        let g = read_column::<L>(output_gradient, g + sample, stride);
        sum0 = add_scaled(sum0, read_input::<L, BIAS>(input, row0 + sample), g);
        sum1 = add_scaled(sum1, read_input::<L, BIAS>(input, row1 + sample), g);
        sum2 = add_scaled(sum2, read_input::<L, BIAS>(input, row2 + sample), g);
        sum3 = add_scaled(sum3, read_input::<L, BIAS>(input, row3 + sample), g);
        sample += L::WIDTH;
    }
    ([sum0, sum1, sum2, sum3], sample)
}

/// An input of the samples of all lanes.
#[inline(always)]
fn read_input<L: Lane, const BIAS: bool>(input: ReadFours<f32>, at: u32) -> L {
    if BIAS { L::splat(1.0) } else { Samples::read(input, at) }
}

/// As [`sum_products`], for a single lane and a quad at a time, while [`QuadCursor::is_next`] says so.
#[loops]
#[inline(always)]
fn sum_quads<L: Lane, const WHOLE: bool, const BIAS: bool>(
    before: [LaneVec4<L>; 4],
    rows: Rows,
    mut cursor: QuadCursor,
) -> ([LaneVec4<L>; 4], QuadCursor) {
    let [mut sum0, mut sum1, mut sum2, mut sum3] = before;
    let Rows { input, rows: [row0, row1, row2, row3], output_gradient, g, stride } = rows;
    let [row0, row1, row2, row3] = [row0 / QUAD, row1 / QUAD, row2 / QUAD, row3 / QUAD];
    let g = g / QUAD;
    let stride = stride / QUAD;
    while cursor.is_next::<WHOLE>() {
        let g = read_quad::<L, WHOLE>(output_gradient, g, stride, cursor);
        sum0 = add_quad(sum0, input_quad::<L, WHOLE, BIAS>(input, row0, cursor), g);
        sum1 = add_quad(sum1, input_quad::<L, WHOLE, BIAS>(input, row1, cursor), g);
        sum2 = add_quad(sum2, input_quad::<L, WHOLE, BIAS>(input, row2, cursor), g);
        sum3 = add_quad(sum3, input_quad::<L, WHOLE, BIAS>(input, row3, cursor), g);
        cursor.at += 1;
    }
    ([sum0, sum1, sum2, sum3], cursor)
}

/// As [`read_input`], of a quad.
#[inline(always)]
fn input_quad<L: Lane, const WHOLE: bool, const BIAS: bool>(
    input: ReadFours<f32>,
    row: u32,
    cursor: QuadCursor,
) -> [L; QUAD as usize] {
    if BIAS { [L::splat(1.0); 4] } else { quad_of_row::<L, WHOLE>(input, row, cursor) }
}

/// Where the rows of a block's inputs begin; inputs past the last repeat it.
#[inline(always)]
fn input_rows(params: &DenseWeightBackwardParams, first: u32) -> [u32; 4] {
    let last = params.inputs - 1;
    let stride = params.stride;
    [
        first * stride,
        min(first + 1, last) * stride,
        min(first + 2, last) * stride,
        min(first + 3, last) * stride,
    ]
}

#[cfg(test)]
mod tests {
    extern crate std;

    use std::vec;
    use std::vec::Vec;

    use glam::UVec3;
    use muslin::shared_tile::Unshared;
    use muslin::workgroup::{SharedMemory, Workgroup};

    use super::*;
    use crate::dense::{DenseParams, dense};

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

    /// A GPU reads quads without a check. Here every index is checked.
    #[test]
    fn layers_of_quads_equal_layers_of_single_samples() {
        for samples in [1, 2, 3, 4, 63, 70] {
            let stride = (samples + 3_u32).next_multiple_of(4);
            let inputs = 11;
            let columns = 8;
            let weight = 3;
            let bias = 3 + inputs * columns;
            let params = DenseParams { samples, stride, inputs, columns, weight, bias };
            let parameters = vectors(3 + (inputs + 1) * columns);
            let input = numbers(inputs * stride);
            let len = (4 * columns * stride) as usize;
            let mut one = vec![9.0; len];
            let mut four = vec![9.0; len];
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
            let mut back_one = vec![9.0; back_len];
            let mut back_four = vec![9.0; back_len];
            let weights = Read::from(&parameters[..]);
            let input = Read::from(&input[..]);
            let gradient = Read::from(&gradient[..]);
            for id in [0, 1].into_iter().flat_map(invocations) {
                dense::<f32>(id, &params, weights, input, Write::from(&mut one[..]));
                dense::<Four>(
                    id.with_items(4),
                    &params,
                    weights,
                    input,
                    Write::from(&mut four[..]),
                );
                let output = Write::from(&mut back_one[..]);
                dense_backward::<f32>(id, &back, weights, input, gradient, output);
                let output = Write::from(&mut back_four[..]);
                dense_backward::<Four>(id.with_items(4), &back, weights, input, gradient, output);
            }
            assert_eq!(one, four, "{samples} samples");
            assert_eq!(back_one, back_four, "{samples} samples, backward");
            assert!(four.iter().any(|&value| value > 0.0 && value != 9.0));
        }
    }

    /// The invocations of workgroups.
    fn run(workgroups: [u32; 3], invocation: impl Fn(Invocation, Shared<Vec4, STAGED>)) {
        for z in 0..workgroups[2] {
            for x in 0..workgroups[0] {
                let staged = SharedMemory::new();
                let workgroup = Workgroup::new([64, 1, 1]).at([x, 0, z], workgroups);
                workgroup.run(|id| invocation(id, staged.view()));
            }
        }
    }

    /// Slices begin and end anywhere in a quad. The variant adds the same bits.
    #[test]
    fn weights_are_summed_slice_by_slice() {
        let sizes = [(1, 9), (3, 9), (4, 4), (70, 33), (64, 7), (12, 1), (11, 3)];
        let layers = [(6, 2), (6, 8), (67, 9)];
        for ((samples, slice), (inputs, columns)) in
            sizes.into_iter().flat_map(|size| layers.map(|layer| (size, layer)))
        {
            let stride = (samples + 3_u32).next_multiple_of(4);
            let parameters = (inputs + 1) * columns;
            let params = DenseWeightBackwardParams {
                samples,
                first_sample: 0,
                stride,
                inputs,
                columns,
                weight: 0,
                bias: inputs * columns,
                cameras: 1,
                words: 1,
                of_rays: 0,
                slice,
                parameters,
                turn: 0,
            };
            let input = numbers(inputs * stride);
            let gradient = numbers(4 * columns * stride);
            let [mut sum, sum_shared] = [false, true].map(|is_shared| {
                let mut carry = vec![0.0; 8 * parameters as usize];
                let mut sum = vec![0_u32; (2 * binned::ROWS * 4 * parameters) as usize];
                let workgroups = [
                    weight_invocations(inputs, columns).div_ceil(64),
                    1,
                    samples.div_ceil(slice) + 1,
                ];
                let carried = Write::from(&mut carry[..]);
                let sums = Write::from(&mut sum[..]);
                let first_pair = [0, samples];
                let pair = Read::from(&first_pair[..]);
                let sample = Read::from(&[0][..]);
                let x = Read::from(&input[..]);
                let g = Read::from(&gradient[..]);
                run(workgroups, |id, mut staged| {
                    if is_shared {
                        let staged = &mut staged;
                        dense_weight_backward::<f32>(
                            id, &params, pair, sample, x, g, carried, sums, staged,
                        );
                    } else {
                        let staged = &mut Unshared;
                        dense_weight_backward::<f32>(
                            id, &params, pair, sample, x, g, carried, sums, staged,
                        );
                    }
                });
                assert!(carry.iter().all(|carried| *carried == 0.0), "every slice is whole");
                sum
            });
            assert_eq!(sum, sum_shared, "{samples} samples, {inputs} inputs");
            // the helpers' loops count on, outside of the kernel
            muslin::kernel::allow_iterations(u32::MAX);
            for index in 0..4 * parameters {
                let place = index / 4;
                let row = place / columns;
                let column = place % columns;
                let output = 4 * column + index % 4;
                let term = |sum: f32, sample: u32| {
                    let g = gradient[(output * stride + sample) as usize];
                    let x = match row < inputs {
                        true => input[(row * stride + sample) as usize],
                        false => 1.0,
                    };
                    x * g + sum
                };
                let of_slice = |at: u32| (at..samples.min(at + slice)).fold(0.0, term);
                let slices = (0..samples).step_by(slice as usize).map(of_slice);
                let (expected, size) = slices.fold((0.0, 0.0), |(expected, size), of_slice| {
                    let of_slice = f64::from(of_slice);
                    (expected + of_slice, size + of_slice.abs())
                });
                let found = binned::take(Write::from(&mut sum[..]), 4 * parameters, index);
                let error = (f64::from(found) - expected).abs();
                assert!(error <= 3e-7 * size, "{samples} samples, {index}: {found}, {expected}");
            }
        }
    }
}
