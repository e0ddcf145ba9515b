//! Adam (Kingma and Ba 2015, Algorithm 1) with decoupled weight decay (Loshchilov and Hutter 2019).

use organza_shaders::adam::AdamParams;

/// Takes a step: returns the new m, v and value.
pub fn step(params: &AdamParams, gradient: f64, [m, v, value]: [f64; 3]) -> [f64; 3] {
    let AdamParams { rate, decay1, decay2, correction2, epsilon, kept, .. } = *params;
    let [rate, correction2, epsilon, kept] = [rate, correction2, epsilon, kept].map(f64::from);
    let [beta1, beta2] = [decay1, decay2].map(f64::from);
    let m = beta1 * m + (1.0 - beta1) * gradient;
    let v = beta2 * v + (1.0 - beta2) * gradient * gradient;
    let moved = rate * m / (v.sqrt() * correction2 + epsilon);
    [m, v, kept * value - moved]
}
