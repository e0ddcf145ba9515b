//! All layers of the transmittance network at once (Eq. 10).
//!
//! An invocation keeps the activations of its own samples in workgroup memory, a column. Nobody else reads them, so nobody waits.
//! On a CPU, the column is an array in the first cache. The last hidden layer goes to no memory: its outputs are added to the
//! logit, four or sixteen at a time, in their order.

use glam::Vec4;

use crate::hash_grid::POINT_ROWS;
use crate::limits::{MAX_HIDDEN_WIDTH, MAX_INPUTS};
use muslin::lane_vec4::LaneVec4;
use muslin::math::log_sigmoid;
use muslin::prelude::*;
use muslin::samples::{LaneFunction, Samples};
#[cfg(not(target_arch = "spirv"))]
use muslin::work::{NUMBER, Shape, VECTOR, Work, wide};

/// Invocations of a workgroup: the distance of two rows of a column.
const PITCH: u32 = 64;

/// Rows of a column.
pub const COLUMN_ROWS: u32 = 64;

/// Values in workgroup memory.
const COLUMNS_LEN: usize = (PITCH * COLUMN_ROWS) as usize;

/// Rounds of a hidden layer's loops at most.
const ROUNDS: u32 = MAX_HIDDEN_WIDTH / 4 * (MAX_INPUTS + 1);

/// Parameters of [`transmittance_network`].
#[params]
pub struct TransmittanceNetworkParams {
    /// Samples in this chunk.
    pub samples: u32,
    /// First sample of this chunk.
    pub first_sample: u32,
    /// Distance of two rows in `point` and `input`.
    pub stride: u32,
    /// Inputs of the network.
    pub inputs: u32,
    /// Columns of four outputs of the first of two hidden layers; 0 if there is only one.
    pub columns: u32,
    /// Inputs of the last hidden layer.
    pub last_inputs: u32,
    /// Its columns.
    pub last_columns: u32,
    /// Its outputs without padding.
    pub last_outputs: u32,
}

/// A hidden layer: where its parameters begin, and what it reads.
#[derive(Clone, Copy)]
struct Layer {
    inputs: u32,
    columns: u32,
    weight: u32,
    /// Where the first input is.
    first: u32,
    /// Distance of two inputs.
    step: u32,
}

impl Layer {
    #[inline(always)]
    fn bias(&self) -> u32 {
        self.weight + self.inputs * self.columns
    }

    #[inline(always)]
    fn end(&self) -> u32 {
        self.bias() + self.columns
    }
}

/// An input of a layer: of the network, or of the column.
#[inline(always)]
fn value<S: Samples, const INSIDE: bool>(
    input: Read<f32>,
    column: Shared<f32, COLUMNS_LEN>,
    at: u32,
) -> S {
    if INSIDE { S::load(column, at) } else { S::read_row(input, at) }
}

/// Sixteen outputs of a hidden layer, before the activation.
#[loops]
#[inline(always)]
fn four_columns<S: Samples, const INSIDE: bool>(
    layer: Layer,
    parameters: Read<Vec4>,
    input: Read<f32>,
    column: Shared<f32, COLUMNS_LEN>,
    first: u32,
) -> [LaneVec4<S>; 4] {
    let bias = layer.bias() + first;
    let mut a = LaneVec4::<S>::splat(parameters.read(bias));
    let mut b = LaneVec4::<S>::splat(parameters.read(bias + 1));
    let mut c = LaneVec4::<S>::splat(parameters.read(bias + 2));
    let mut d = LaneVec4::<S>::splat(parameters.read(bias + 3));
    let mut weight = layer.weight + first;
    let mut at = layer.first;
    let mut i = 0;
    while i < layer.inputs {
        let x = value::<S, INSIDE>(input, column, at);
        a = a.add_product(parameters.read(weight), x);
        b = b.add_product(parameters.read(weight + 1), x);
        c = c.add_product(parameters.read(weight + 2), x);
        d = d.add_product(parameters.read(weight + 3), x);
        weight += layer.columns;
        at += layer.step;
        i += 1;
    }
    [a, b, c, d]
}

/// Four outputs of a hidden layer, before the activation.
#[loops]
#[inline(always)]
fn one_column<S: Samples, const INSIDE: bool>(
    layer: Layer,
    parameters: Read<Vec4>,
    input: Read<f32>,
    column: Shared<f32, COLUMNS_LEN>,
    first: u32,
) -> LaneVec4<S> {
    let mut sum = LaneVec4::<S>::splat(parameters.read(layer.bias() + first));
    let mut weight = layer.weight + first;
    let mut at = layer.first;
    let mut i = 0;
    while i < layer.inputs {
        sum = sum.add_product(parameters.read(weight), value::<S, INSIDE>(input, column, at));
        weight += layer.columns;
        at += layer.step;
        i += 1;
    }
    sum
}

/// Stores four rows of a column.
#[inline(always)]
fn keep<S: Samples>(column: Shared<f32, COLUMNS_LEN>, at: u32, value: LaneVec4<S>) {
    let zero = S::splat(0.0);
    value.x.max(zero).store(column, at);
    value.y.max(zero).store(column, at + PITCH);
    value.z.max(zero).store(column, at + 2 * PITCH);
    value.w.max(zero).store(column, at + 3 * PITCH);
}

/// A hidden layer, from the network's input to the column.
#[loops]
#[inline(always)]
fn first_layer<S: Samples>(
    layer: Layer,
    parameters: Read<Vec4>,
    input: Read<f32>,
    column: Shared<f32, COLUMNS_LEN>,
    own: u32,
) {
    let mut first = 0;
    while first < layer.columns {
        let at = 4 * first * PITCH + own;
        if S::COLUMNS == 4 {
            let [a, b, c, d] = four_columns::<S, false>(layer, parameters, input, column, first);
            keep(column, at, a);
            keep(column, at + 4 * PITCH, b);
            keep(column, at + 8 * PITCH, c);
            keep(column, at + 12 * PITCH, d);
        } else {
            let a = one_column::<S, false>(layer, parameters, input, column, first);
            keep(column, at, a);
        }
        first += S::COLUMNS;
    }
}

/// The last layer: its weights, an input a vector, and the last input.
#[derive(Clone, Copy)]
struct Head {
    weight: u32,
    last: u32,
}

/// Adds four inputs of the last layer to the logit. Those behind the last are 0.
#[inline(always)]
fn add_four<S: Samples>(
    logit: S,
    head: Head,
    parameters: Read<Vec4>,
    first: u32,
    value: LaneVec4<S>,
) -> S {
    let logit = add_one(logit, head, parameters, first, value.x);
    let logit = add_one(logit, head, parameters, first + 1, value.y);
    let logit = add_one(logit, head, parameters, first + 2, value.z);
    add_one(logit, head, parameters, first + 3, value.w)
}

#[inline(always)]
fn add_one<S: Samples>(logit: S, head: Head, parameters: Read<Vec4>, input: u32, value: S) -> S {
    let row = if input < head.last { input } else { head.last };
    let weight = parameters.read(head.weight + row).x;
    value.max(S::splat(0.0)).mul_add(S::splat(weight), logit)
}

/// The logit: the last hidden layer, and the last one.
#[loops]
#[inline(always)]
fn last_layers<S: Samples, const INSIDE: bool>(
    layer: Layer,
    head: Head,
    parameters: Read<Vec4>,
    input: Read<f32>,
    column: Shared<f32, COLUMNS_LEN>,
) -> S {
    let mut logit = S::splat(parameters.read(head.weight + head.last + 1).x);
    let mut first = 0;
    while first < layer.columns {
        if S::COLUMNS == 4 {
            let [a, b, c, d] = four_columns::<S, INSIDE>(layer, parameters, input, column, first);
            logit = add_four(logit, head, parameters, 4 * first, a);
            logit = add_four(logit, head, parameters, 4 * first + 4, b);
            logit = add_four(logit, head, parameters, 4 * first + 8, c);
            logit = add_four(logit, head, parameters, 4 * first + 12, d);
        } else {
            let a = one_column::<S, INSIDE>(layer, parameters, input, column, first);
            logit = add_four(logit, head, parameters, 4 * first, a);
        }
        first += S::COLUMNS;
    }
    logit
}

/// `factor * log_sigmoid(a)`
struct LogRho;

impl LaneFunction for LogRho {
    #[inline(always)]
    fn call<L: Lane>(a: L, factor: L) -> L {
        factor * log_sigmoid(a)
    }
}

/// Operations and bytes of [`transmittance_network`].
#[cfg(not(target_arch = "spirv"))]
fn network_work(params: &TransmittanceNetworkParams, _: Shape<'_>) -> Work {
    let TransmittanceNetworkParams { samples, inputs, columns, .. } = *params;
    let [samples, inputs, outputs] = wide([samples, inputs, 4 * columns]);
    let [last_inputs, last] = wide([params.last_inputs, 4 * params.last_columns]);
    let weights = inputs * outputs + last_inputs * last + last;
    Work {
        flops: 2 * samples * weights,
        bytes: NUMBER * (samples * (inputs + 2) + weights) + VECTOR,
    }
}

/// The scalar network and the logarithm of Eq. 11's factor: `log_rho [samples] = s_factor * log_sigmoid(a_k)`.
///
/// `point [7, stride]`, `input [inputs, stride]`.
#[kernel(threads(64), iterations = 2 * ROUNDS, fused, lanes(samples), counts(samples), work(network_work))]
pub fn transmittance_network<S: Samples>(
    id: Invocation,
    params: &TransmittanceNetworkParams,
    parameters: Read<Vec4>,
    point: Read<f32>,
    input: Read<f32>,
    log_rho: Write<f32>,
    column: Shared<f32, COLUMNS_LEN>,
) {
    let sample = id.index();
    if sample < params.samples {
        let own = id.local.x;
        let stride = params.stride;
        let inputs = params.inputs;
        let columns = params.columns;
        let layer = Layer { inputs, columns, weight: 0, first: sample, step: stride };
        let [inputs, columns] = [params.last_inputs, params.last_columns];
        let last = params.last_outputs - 1;
        let logit = if layer.columns > 0 {
            first_layer::<S>(layer, parameters, input, column, own);
            let weight = layer.end();
            let layer = Layer { inputs, columns, weight, first: own, step: PITCH };
            let head = Head { weight: layer.end(), last };
            last_layers::<S, true>(layer, head, parameters, input, column)
        } else {
            let layer = Layer { inputs, columns, weight: 0, first: sample, step: stride };
            let head = Head { weight: layer.end(), last };
            last_layers::<S, false>(layer, head, parameters, input, column)
        };
        let factor = S::read_row(point, POINT_ROWS * stride + sample);
        logit.map::<LogRho>(factor).write_row(log_rho, params.first_sample + sample);
    }
}
