//! The name and shape of a tensor in a scene file.

/// Kernels address values with 32 bits, and one bit is kept free.
pub(super) const MAX_VALUES: usize = 1 << 31;

/// The declaration of one tensor in a scene file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TensorSpec {
    /// Name in the file.
    pub name: String,
    /// Shape, row-major.
    pub shape: Vec<usize>,
    /// The reason for the shape, for messages.
    pub why: &'static str,
}

impl TensorSpec {
    /// Number of values in the tensor.
    pub fn values(&self) -> usize {
        self.shape.iter().fold(1, |values, &size| values.saturating_mul(size))
    }

    /// Whether a scene has the tensor: without slopes or shapes, it does not even have empty ones.
    pub(super) fn is_in_scene(&self) -> bool {
        !["gaussians.slope", "gaussians.shape"].contains(&&*self.name) || self.shape[1] > 0
    }
}
