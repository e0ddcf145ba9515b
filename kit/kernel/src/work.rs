//! Counts the operations and bytes of a dispatch from its parameters.
//!
//! A kernel declares its formula: `#[kernel(threads(64), work(square_work))]`. The formula is a function of the
//! parameters and the dispatch's [`Shape`]. Write it next to the parameters:
//!
//! ```ignore
//! #[cfg(not(target_arch = "spirv"))]
//! fn square_work(params: &SquareParams, _: Shape<'_>) -> Work {
//!     let count = u64::from(params.count);
//!     Work { flops: count, bytes: 2 * count * NUMBER }
//! }
//! ```

use core::ops::AddAssign;

/// Operations and bytes; zeros if they are not counted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Work {
    /// Floating-point operations: a multiply-add is two, an elementary function one.
    pub flops: u64,
    /// Bytes that must be read and written, if each value that does not change is read once per dispatch.
    pub bytes: u64,
}

impl AddAssign for Work {
    fn add_assign(&mut self, other: Self) {
        self.flops += other.flops;
        self.bytes += other.bytes;
    }
}

/// The data of a dispatch for a formula, besides its parameters.
#[derive(Clone, Copy, Debug)]
pub struct Shape<'a> {
    /// Number of elements of each storage buffer, in the order of the bindings.
    pub elements: &'a [u64],
    /// Number of workgroups along z.
    pub workgroups_z: u64,
}

/// The formula of a kernel: the bytes of its parameters, and the dispatch.
pub type WorkOf = fn(&[u8], Shape<'_>) -> Work;

/// Bytes of an `f32` or `u32`.
pub const NUMBER: u64 = 4;

/// Bytes of a `Vec4`.
pub const VECTOR: u64 = 16;

/// Converts parameters to `u64`, to calculate with them.
#[must_use]
pub fn wide<const N: usize>(numbers: [u32; N]) -> [u64; N] {
    numbers.map(u64::from)
}
