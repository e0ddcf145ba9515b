//! The derivative of a dense layer by its weights and biases (Eq. 2 and 10), from dL/d of its outputs before the activation.
//!
//! A network's gradient has the layout of its parameters in [`dense`](crate::dense), with zeros as padding.

use glam::Vec4;

use crate::dense::{min, read_column};
use crate::limits::{MAX_CAMERAS, MAX_SLICE};
use crate::weight_slice::{
    DenseWeightBackwardParams, Outputs, QUAD, QuadCursor, SlicePart, add_quad, add_scaled,
    add_sums, begin_sums, quad_of_row, total,
};
#[cfg(not(target_arch = "spirv"))]
use crate::weight_tile::tiles;
use crate::weight_tile::{STAGED, add_tile, tile_of};
use muslin::lane_vec4::LaneVec4;
use muslin::prelude::*;
use muslin::samples::Samples;

/// Inputs of a layer that one invocation of [`dense_weight_backward`] takes; its outputs are a column of four.
const WEIGHT_ROWS_PER_INVOCATION: u32 = 4;

/// Iterations of a search among all cameras.
const SEARCH: u32 = u32::BITS;

/// Adds the gradient of a layer's weights and biases, `dL/dW_oi = sum x_i dL/dy_o` and `dL/db_o = sum dL/dy_o` of Eq. 2
/// and 10, to `sum`: blocks of four inputs and a column of outputs along x and y (the column counts fastest; behind the
/// last block the biases), windows of as many samples as a slice has along z.
///
/// The samples of each camera are cut into slices of the same length, from the camera's first sample on; the last one may
/// be shorter. A slice is summed in f32, and slices [exactly](muslin::binned): neither depends on what else is in the part. An
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
pub fn weight_invocations(inputs: u32, columns: u32) -> u32 {
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
