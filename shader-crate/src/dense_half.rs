//! Hidden layers with 16-bit floats (halves), only for rendering: half the bytes of weights, and twice the multiply-adds on GPUs
//! that compute two halves at once.
//!
//! Products of [`PRODUCTS_PER_SUM`] inputs are added up as halves; such sums are added to an `f32`, as biases are.  With
//! u = 2^-11, the largest relative error of a rounding, a term has one of its weight, one of its input, one of its
//! product, and at most as many as a group has sums, of which the first adds to 0: an output before its activation is off
//! by at most `((1 + u)^(PRODUCTS_PER_SUM + 2) - 1) sum_i |w_i x_i|` and what is below the normal halves.

use glam::Vec4;

#[cfg(not(target_arch = "spirv"))]
use crate::dense::dense_work;
use crate::dense::{DenseParams, OUTPUTS_PER_INVOCATION, write_rectified};
use crate::dense_backward::add;
use crate::limits::MAX_INPUTS;
use organza_kernel::half::{HalfVector, Halves};
use organza_kernel::lane_vec4::LaneVec4;
use organza_kernel::prelude::*;
#[cfg(not(target_arch = "spirv"))]
use organza_kernel::work::{NUMBER, Shape, Work, wide};

/// Inputs whose products are added up in half precision.
pub const PRODUCTS_PER_SUM: u32 = 16;

/// The largest input of a layer: one beyond it counts as this.
pub const MAX_INPUT: f32 = 1_024.0;

/// The most that the sizes of a group's weights of an output may add up to: with inputs up to [`MAX_INPUT`] no sum leaves
/// the halves, which end at 65,504.
pub const MAX_WEIGHTS: f32 = 62.0;

/// The largest relative error of a rounding to a half.
pub const UNIT: f32 = 1.0 / 2_048.0;

// a sum grows by less than 2 UNIT with each of its roundings
const _: () = assert!(
    MAX_INPUT * MAX_WEIGHTS * (1.0 + 2.0 * UNIT * (PRODUCTS_PER_SUM + 2) as f32) < 65_504.0
);

/// Sixteen sums of halves.
#[derive(Clone, Copy)]
struct Part<L: Lane> {
    a: L::Halves,
    b: L::Halves,
    c: L::Halves,
    d: L::Halves,
}

impl<L: Lane> Part<L> {
    #[inline(always)]
    fn zero() -> Self {
        let zero = L::Halves::zero;
        Self { a: zero(), b: zero(), c: zero(), d: zero() }
    }

    /// Adds one input's products.
    #[inline(always)]
    fn add(self, weights: Read<HalfVector>, weight: u32, input: Read<f32>, at: u32) -> Self {
        let largest = L::splat(MAX_INPUT);
        let x = L::Halves::factor(L::read(input, at).min(largest).max(-largest));
        Self {
            a: self.a.add_product(weights.read(weight), x),
            b: self.b.add_product(weights.read(weight + 1), x),
            c: self.c.add_product(weights.read(weight + 2), x),
            d: self.d.add_product(weights.read(weight + 3), x),
        }
    }
}

/// What [`dense_half`] computes and moves.
#[cfg(not(target_arch = "spirv"))]
fn dense_half_work(params: &DenseParams, shape: Shape<'_>) -> Work {
    let Work { flops, bytes } = dense_work(params, shape);
    let [inputs, outputs] = wide([params.inputs, 4 * params.columns]);
    // of a weight half of the bytes
    Work { flops, bytes: bytes - NUMBER / 2 * inputs * outputs }
}

/// A hidden layer: `output = max(W input + b, 0)`, samples along x and y, blocks of 16 outputs along z.
///
/// `parameters` as in [`dense`](crate::dense), but only the biases are read; `weights` likewise, as halves.
/// `input [inputs, stride]`, `output [4 columns, stride]`.
#[kernel(threads(64), iterations = MAX_INPUTS / PRODUCTS_PER_SUM + MAX_INPUTS, fused, z_innermost, lanes(samples), counts(samples), work(dense_half_work))]
pub fn dense_half<L: Lane>(
    id: Invocation,
    params: &DenseParams,
    parameters: Read<Vec4>,
    weights: Read<HalfVector>,
    input: Read<f32>,
    output: Write<f32>,
) {
    let sample = id.index();
    if sample < params.samples {
        let block = id.workgroup.z;
        let first = block * (OUTPUTS_PER_INVOCATION / 4);
        let bias = params.bias + first;
        let mut a = LaneVec4::<L>::splat(parameters.read(bias));
        let mut b = LaneVec4::<L>::splat(parameters.read(bias + 1));
        let mut c = LaneVec4::<L>::splat(parameters.read(bias + 2));
        let mut d = LaneVec4::<L>::splat(parameters.read(bias + 3));
        let mut weight = params.weight + first;
        let mut at = sample;
        let mut left = params.inputs;
        while left > 0 {
            let mut part = Part::<L>::zero();
            let mut of_group = if left < PRODUCTS_PER_SUM { left } else { PRODUCTS_PER_SUM };
            left -= of_group;
            while of_group > 0 {
                part = part.add(weights, weight, input, at);
                weight += params.columns;
                at += params.stride;
                of_group -= 1;
            }
            a = add(a, part.a.column());
            b = add(b, part.b.column());
            c = add(c, part.c.column());
            d = add(d, part.d.column());
        }
        let row = block * OUTPUTS_PER_INVOCATION;
        write_rectified(output, a, row, params, sample);
        write_rectified(output, b, row + 4, params, sample);
        write_rectified(output, c, row + 8, params, sample);
        write_rectified(output, d, row + 12, params, sample);
    }
}
