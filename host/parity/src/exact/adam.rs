//! Adam (Kingma and Ba 2015, Algorithm 1) with decoupled weight decay (Loshchilov and Hutter 2019).

use super::numeric::Number;
use organza_shaders::adam::AdamParams;

/// Takes a step: returns the new m, v and value.
pub fn step<N: Number>(params: &AdamParams, gradient: N, [m, v, value]: [N; 3]) -> [N; 3] {
    let AdamParams { rate, decay1, decay2, correction2, epsilon, kept, .. } = *params;
    let number = |x: f32| N::from(x.into());
    let one = N::from(1.0);
    let [beta1, beta2] = [decay1, decay2].map(number);
    let m = beta1 * m + (one - beta1) * gradient;
    let v = beta2 * v + (one - beta2) * gradient * gradient;
    let moved = number(rate) * m / (v.sqrt() * number(correction2) + number(epsilon));
    [m, v, number(kept) * value - moved]
}
