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

    /// Whether a scene has the tensor: not if its rows are empty. But two are as old as the format, which has them anyway.
    pub(super) fn is_in_scene(&self) -> bool {
        const ALWAYS: [&str; 2] = ["gaussians.material", "gaussians.extra"];
        !self.shape[1..].contains(&0) || ALWAYS.contains(&&*self.name)
    }
}
