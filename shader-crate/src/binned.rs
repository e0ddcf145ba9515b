//! From [binned] sums to gradients of the networks and of the cameras' poses.

use muslin::binned;
use muslin::prelude::*;

/// Parameters of [`binned_gradient`].
#[params]
pub struct BinnedGradientParams {
    /// Values of the gradient.
    pub values: u32,
}

/// Adds the sums to the gradient, and clears them: `sum [17, values, 2]`, `gradient [values]`.
#[kernel(threads(64), over(params.values), iterations = 2 * binned::ROWS)]
pub fn binned_gradient(
    id: Invocation,
    params: &BinnedGradientParams,
    sum: Write<u32>,
    gradient: Write<f32>,
) {
    let index = id.index();
    if index < params.values {
        let found = binned::take(sum, params.values, index);
        gradient.write(index, gradient.read(index) + found);
    }
}
