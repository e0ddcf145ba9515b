//! Samples of a segment and its transmittance (Eq. 9 to 11).

use super::numeric::Number;

/// The midpoint x_k of Eq. 9, for `count` steps along w, starting at s.
pub fn midpoint(s: [f64; 3], w: [f64; 3], k: u32, count: u32) -> [f64; 3] {
    let t = (f64::from(k) + 0.5) / f64::from(count);
    std::array::from_fn(|axis| s[axis] + t * w[axis])
}

/// The logarithm of a step's factor: `log rho_k = s_factor log sigmoid(a_k)`.
pub fn log_rho<N: Number>(a: N, factor: N) -> N {
    factor * a.log_sigmoid()
}

/// T of Eq. 11, from the sum of the factors' logarithms.
pub fn transmittance<N: Number>(log_rho: N) -> N {
    log_rho.exp()
}
