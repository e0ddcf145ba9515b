//! The variant of [`dense_weight_backward`](crate::dense_weight_backward::dense_weight_backward()): a workgroup multiplies from workgroup
//! memory.
//!
//! A workgroup takes a tile of the weights, of 64 inputs and 32 outputs, and an invocation 8 inputs and 4 outputs of it. The
//! workgroup copies 8 quads of all these rows, and multiplies them; then the next ones. So neighbors read
//! what lies side by side in memory, and a value that is read there serves 32 or 64 products, instead of four.
//!
//! The sums have the order of the plain kernel.

use glam::Vec4;

use crate::dense::min;
use crate::weight_slice::{
    DenseWeightBackwardParams, Outputs, QUAD, QuadCursor, SlicePart, add_quad, add_sums, begin_sum,
    begin_sums, quad_of_row, total,
};
use muslin::lane_vec4::LaneVec4;
use muslin::prelude::*;

/// Invocations of a workgroup in each direction of its tile.
const SIDE: u32 = 8;
/// Inputs of an invocation: every eighth. Neighbors have neighboring rows, which lie in different banks.
const INPUTS: u32 = 8;
/// Its outputs, likewise.
const OUTPUTS: u32 = 4;
/// Inputs of a tile.
const TILE_INPUTS: u32 = SIDE * INPUTS;
/// Outputs of a tile.
const TILE_OUTPUTS: u32 = SIDE * OUTPUTS;
/// Quads of a row that are copied at once, by as many neighbors.
const QUADS: u32 = 8;
/// Distance of two rows in workgroup memory. It is odd, so that eight neighbors read from different banks.
const PITCH: u32 = QUADS + 1;

/// Vectors in workgroup memory.
pub const STAGED: usize = ((TILE_INPUTS + TILE_OUTPUTS) * PITCH) as usize;

/// Distance of two of an invocation's rows.
const STEP: u32 = SIDE * PITCH;

/// Sums of an invocation, of four outputs each.
struct Sums {
    /// Its first four inputs.
    sums: [LaneVec4<f32>; 4],
    /// Its other four.
    more: [LaneVec4<f32>; 4],
    /// The biases.
    biases: LaneVec4<f32>,
}

/// Tiles of a layer.
#[cfg(not(target_arch = "spirv"))]
pub fn tiles(inputs: u32, columns: u32) -> u32 {
    inputs.div_ceil(TILE_INPUTS) * (4 * columns).div_ceil(TILE_OUTPUTS)
}

/// The first input and the first output of a workgroup's tile. A workgroup past the last tile has an input that the layer lacks.
#[inline(always)]
pub fn tile_of(params: &DenseWeightBackwardParams, workgroup: u32) -> [u32; 2] {
    let across = (4 * params.columns - 1) / TILE_OUTPUTS + 1;
    [workgroup / across * TILE_INPUTS, workgroup % across * TILE_OUTPUTS]
}

/// Every eighth row of a tile, from the first on.
#[inline(always)]
fn every_eighth(first: u32) -> [u32; 4] {
    [first, first + SIDE, first + 2 * SIDE, first + 3 * SIDE]
}

/// Where the values of an input's weights begin. Inputs past the last repeat it.
#[inline(always)]
fn weights_of(params: &DenseWeightBackwardParams, input: u32) -> u32 {
    4 * (params.weight + min(input, params.inputs - 1) * params.columns)
}

/// Adds the sums of a workgroup's tile over a slice; leaves them in `carry` if the slice ends in another chunk.
#[inline(always)]
#[allow(clippy::too_many_arguments)]
pub fn add_tile(
    id: Invocation,
    params: &DenseWeightBackwardParams,
    tile: [u32; 2],
    part: SlicePart,
    rows: [ReadFours<f32>; 2],
    carry: Write<f32>,
    sum: Write<impl SumWord>,
    staged: &mut impl SharedTile<Vec4, STAGED>,
) {
    let down = id.local.x / SIDE;
    let across = id.local.x % SIDE;
    let outputs = Outputs { first: tile[1] + across, step: SIDE, end: 4 * params.columns };
    let input = tile[0] + down;
    let next = input + 4 * SIDE;
    let sums = begin_rows(params, carry, part, outputs, input);
    let more = begin_rows(params, carry, part, outputs, next);
    let bias = 4 * params.bias;
    // the first inputs of a layer take the biases along
    let has_bias = input == 0;
    let biases = begin_sum(carry, part.before + bias, outputs, part.continues && has_bias);
    let sums = Sums { sums, more, biases };
    let Sums { sums, more, biases } =
        sum_tile(id, params, tile, [part.begin, part.end], rows, sums, has_bias, staged);
    add_rows(params, carry, sum, part, outputs, input, sums);
    add_rows(params, carry, sum, part, outputs, next, more);
    if has_bias {
        add_sums::<false>(params, carry, sum, part, bias, outputs, rounded(biases));
    }
}

/// The start of the sums of four inputs.
#[inline(always)]
fn begin_rows(
    params: &DenseWeightBackwardParams,
    carry: Write<f32>,
    part: SlicePart,
    outputs: Outputs,
    input: u32,
) -> [LaneVec4<f32>; 4] {
    let [input0, input1, input2, input3] = every_eighth(input);
    let rows = [
        part.before + weights_of(params, input0),
        part.before + weights_of(params, input1),
        part.before + weights_of(params, input2),
        part.before + weights_of(params, input3),
    ];
    begin_sums(carry, rows, outputs, part.continues)
}

/// Adds the sums of four inputs.
#[inline(always)]
fn add_rows(
    params: &DenseWeightBackwardParams,
    carry: Write<f32>,
    sum: Write<impl SumWord>,
    part: SlicePart,
    outputs: Outputs,
    input: u32,
    [sum0, sum1, sum2, sum3]: [LaneVec4<f32>; 4],
) {
    let [input0, input1, input2, input3] = every_eighth(input);
    add_row(params, carry, sum, part, outputs, input0, sum0);
    add_row(params, carry, sum, part, outputs, input1, sum1);
    add_row(params, carry, sum, part, outputs, input2, sum2);
    add_row(params, carry, sum, part, outputs, input3, sum3);
}

/// Adds the sums of an input, if the layer has it.
#[inline(always)]
fn add_row(
    params: &DenseWeightBackwardParams,
    carry: Write<f32>,
    sum: Write<impl SumWord>,
    part: SlicePart,
    outputs: Outputs,
    input: u32,
    value: LaneVec4<f32>,
) {
    if input < params.inputs {
        let to = weights_of(params, input);
        add_sums::<false>(params, carry, sum, part, to, outputs, rounded(value));
    }
}

/// Four sums in the plain kernel's form: the sums of the lanes, with no samples left over.
#[inline(always)]
fn rounded(value: LaneVec4<f32>) -> Vec4 {
    total(value, LaneVec4::<f32>::splat(Vec4::ZERO))
}

/// Sums of an invocation over a range of samples.
#[loops]
#[inline(always)]
#[allow(clippy::too_many_arguments)]
fn sum_tile(
    id: Invocation,
    params: &DenseWeightBackwardParams,
    tile: [u32; 2],
    [begin, end]: [u32; 2],
    rows: [ReadFours<f32>; 2],
    before: Sums,
    has_bias: bool,
    staged: &mut impl SharedTile<Vec4, STAGED>,
) -> Sums {
    let down = id.local.x / SIDE;
    let across = id.local.x % SIDE;
    let Sums { sums, more, mut biases } = before;
    // in variables: an array of them would stay in memory
    let [mut sum0, mut sum1, mut sum2, mut sum3] = sums;
    let [mut sum4, mut sum5, mut sum6, mut sum7] = more;
    let mut cursor = QuadCursor { at: begin / QUAD, begin, end };
    while QUAD * cursor.at < end {
        staged.wait(id);
        stage(id, params, tile, rows, cursor, staged);
        staged.wait(id);
        let quads = min((end - 1) / QUAD + 1 - cursor.at, QUADS);
        let mut quad = 0;
        while quad < quads {
            let at = TILE_INPUTS * PITCH + across * PITCH + quad;
            let g = staged_columns(staged, at);
            let at = down * PITCH + quad;
            sum0 = add_quad(sum0, staged_row(staged, at), g);
            sum1 = add_quad(sum1, staged_row(staged, at + STEP), g);
            sum2 = add_quad(sum2, staged_row(staged, at + 2 * STEP), g);
            sum3 = add_quad(sum3, staged_row(staged, at + 3 * STEP), g);
            sum4 = add_quad(sum4, staged_row(staged, at + 4 * STEP), g);
            sum5 = add_quad(sum5, staged_row(staged, at + 5 * STEP), g);
            sum6 = add_quad(sum6, staged_row(staged, at + 6 * STEP), g);
            sum7 = add_quad(sum7, staged_row(staged, at + 7 * STEP), g);
            if has_bias {
                biases = add_quad(biases, [1.0; QUAD as usize], g);
            }
            quad += 1;
        }
        cursor.at += quads;
    }
    Sums { sums: [sum0, sum1, sum2, sum3], more: [sum4, sum5, sum6, sum7], biases }
}

/// Copies the next samples of a tile's rows to workgroup memory: eight neighbors, eight vectors of a row. All are read before
/// any is stored, so that an invocation waits for memory once.
#[inline(always)]
fn stage(
    id: Invocation,
    params: &DenseWeightBackwardParams,
    tile: [u32; 2],
    [input, output_gradient]: [ReadFours<f32>; 2],
    cursor: QuadCursor,
    staged: &mut impl SharedTile<Vec4, STAGED>,
) {
    let row = id.local.x / QUADS;
    let quad = id.local.x % QUADS;
    // past the last quad, the last one is read again; nothing multiplies that copy
    let cursor = QuadCursor { at: min(cursor.at + quad, (cursor.end - 1) / QUAD), ..cursor };
    let stride = params.stride / QUAD;
    let last = [params.inputs - 1, 4 * params.columns - 1];
    let x = read_rows(input, tile[0] + row, last[0], stride, cursor);
    let more = read_rows(input, tile[0] + 4 * SIDE + row, last[0], stride, cursor);
    let g = read_rows(output_gradient, tile[1] + row, last[1], stride, cursor);
    staged.begin_stores();
    let at = row * PITCH + quad;
    store_rows(staged, at, x);
    store_rows(staged, at + 4 * STEP, more);
    store_rows(staged, at + TILE_INPUTS * PITCH, g);
}

/// A quad of every eighth row, from the first on, with zeros for samples that do not count. Rows past the last repeat it.
#[inline(always)]
fn read_rows(
    rows: ReadFours<f32>,
    first: u32,
    last: u32,
    stride: u32,
    cursor: QuadCursor,
) -> [[f32; QUAD as usize]; 4] {
    let [row0, row1, row2, row3] = every_eighth(first);
    [
        quad_of_row::<f32, false>(rows, min(row0, last) * stride, cursor),
        quad_of_row::<f32, false>(rows, min(row1, last) * stride, cursor),
        quad_of_row::<f32, false>(rows, min(row2, last) * stride, cursor),
        quad_of_row::<f32, false>(rows, min(row3, last) * stride, cursor),
    ]
}

/// Stores a quad of every eighth row.
#[inline(always)]
fn store_rows(
    staged: &mut impl SharedTile<Vec4, STAGED>,
    at: u32,
    [row0, row1, row2, row3]: [[f32; QUAD as usize]; 4],
) {
    staged.store(at, Vec4::from_array(row0));
    staged.store(at + STEP, Vec4::from_array(row1));
    staged.store(at + 2 * STEP, Vec4::from_array(row2));
    staged.store(at + 3 * STEP, Vec4::from_array(row3));
}

/// A quad of a row in workgroup memory.
#[inline(always)]
fn staged_row(staged: &impl SharedTile<Vec4, STAGED>, at: u32) -> [f32; QUAD as usize] {
    staged.load(at).to_array()
}

/// A quad of four outputs.
#[inline(always)]
fn staged_columns(
    staged: &impl SharedTile<Vec4, STAGED>,
    at: u32,
) -> [LaneVec4<f32>; QUAD as usize] {
    let x = staged.load(at);
    let y = staged.load(at + STEP);
    let z = staged.load(at + 2 * STEP);
    let w = staged.load(at + 3 * STEP);
    [
        LaneVec4 { x: x.x, y: y.x, z: z.x, w: w.x },
        LaneVec4 { x: x.y, y: y.y, z: z.y, w: w.y },
        LaneVec4 { x: x.z, y: y.z, z: z.z, w: w.z },
        LaneVec4 { x: x.w, y: y.w, z: z.w, w: w.w },
    ]
}
