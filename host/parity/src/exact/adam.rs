//! Adam (Kingma and Ba 2015, Algorithm 1) with decoupled weight decay (Loshchilov and Hutter 2019).

/// The constants of a step.
#[derive(Clone, Copy, Debug)]
pub struct Step {
    /// `alpha / (1 - beta1^t)`
    pub rate: f64,
    /// beta1 and beta2.
    pub decay: [f64; 2],
    /// `1 / sqrt(1 - beta2^t)`
    pub correction2: f64,
    /// epsilon
    pub epsilon: f64,
    /// `1 - alpha lambda`
    pub kept: f64,
}

impl Step {
    /// Takes a step: returns the new m, v and value.
    pub fn take(&self, gradient: f64, [m, v, value]: [f64; 3]) -> [f64; 3] {
        let [beta1, beta2] = self.decay;
        let m = beta1 * m + (1.0 - beta1) * gradient;
        let v = beta2 * v + (1.0 - beta2) * gradient * gradient;
        let moved = self.rate * m / (v.sqrt() * self.correction2 + self.epsilon);
        [m, v, self.kept * value - moved]
    }
}
