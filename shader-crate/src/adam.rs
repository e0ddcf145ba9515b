//! Adam (Kingma and Ba 2015, Algorithm 1) with decoupled weight decay (Loshchilov and Hutter 2019): one kernel for all
//! tensors.

use crate::hash_grid_backward::VALUES_PER_FLAG;
use muslin::prelude::*;

/// Parameters of [`adam`]; what depends on the step is computed on the host, in f64.
#[params]
pub struct AdamParams {
    /// Values of the group.
    pub values: u32,
    /// Where the group begins in `gradient`.
    pub first_gradient: u32,
    /// 1 if blocks without a flag are skipped; 0 if `touched` is one flag for the whole group.
    pub sparse: u32,
    /// `alpha / (1 - beta1^t)`, the corrected rate.
    pub rate: f32,
    /// beta1
    pub decay1: f32,
    /// beta2
    pub decay2: f32,
    /// `1 / sqrt(1 - beta2^t)`
    pub correction2: f32,
    /// epsilon
    pub epsilon: f32,
    /// `1 - alpha lambda`: what weight decay leaves of a value; 1 where there is none.
    pub kept: f32,
}

/// One step of every value: `m = beta1 m + (1 - beta1) g`, `v = beta2 v + (1 - beta2) g^2`,
/// `value = (1 - alpha lambda) value - alpha m^ / (sqrt(v^) + epsilon)`; the gradient becomes 0 for the next step.
///
/// A block of [`VALUES_PER_FLAG`] values that nothing has touched keeps its value and its moments: it costs one read.
#[kernel(threads(64), over(params.values), lanes(values), counts(values))]
pub fn adam<L: Lane>(
    id: Invocation,
    params: &AdamParams,
    touched: Read<u32>,
    gradient: Write<f32>,
    first_moment: Write<f32>,
    second_moment: Write<f32>,
    value: Write<f32>,
) {
    let index = id.index();
    if index < params.values && touched.read(index / VALUES_PER_FLAG * params.sparse) != 0 {
        let number = L::splat;
        let at = params.first_gradient + index;
        let g = L::read_written(gradient, at);
        let m = L::read_written(first_moment, index) * number(params.decay1)
            + g * number(1.0 - params.decay1);
        let v = L::read_written(second_moment, index) * number(params.decay2)
            + g * g * number(1.0 - params.decay2);
        let size = v.sqrt() * number(params.correction2) + number(params.epsilon);
        let moved =
            L::read_written(value, index) * number(params.kept) - number(params.rate) * m / size;
        m.write(first_moment, index);
        v.write(second_moment, index);
        moved.write(value, index);
        number(0.0).write(gradient, at);
    }
}
