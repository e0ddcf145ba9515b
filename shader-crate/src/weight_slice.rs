//! The slices of samples that [`dense_weight_backward`](crate::dense_weight_backward) and its [variant](crate::weight_tile)
//! add up.

use glam::Vec4;

use crate::dense::min;
use muslin::binned;
use muslin::lane_vec4::LaneVec4;
use muslin::prelude::*;
use muslin::samples::Four;

/// Parameters of [`dense_weight_backward`](crate::dense_weight_backward::dense_weight_backward()).
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

/// `sum + x g`
#[inline(always)]
pub fn add_scaled<L: Lane>(sum: LaneVec4<L>, x: L, g: LaneVec4<L>) -> LaneVec4<L> {
    LaneVec4 {
        x: x.mul_add(g.x, sum.x),
        y: x.mul_add(g.y, sum.y),
        z: x.mul_add(g.z, sum.z),
        w: x.mul_add(g.w, sum.w),
    }
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
