//! How many operations a dispatch computes and how many bytes it moves, from its parameters.
//!
//! A kernel declares its formula: `#[kernel(threads(64), work(square_work))]`. That is a function of the parameters and the
//! dispatch's [`Shape`]; write it next to the parameters.

use core::ops::AddAssign;

/// What was computed and moved; zeros if that is not counted.
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

/// What a formula knows about a dispatch, besides its parameters.
#[derive(Clone, Copy, Debug)]
pub struct Shape<'a> {
    /// Elements of each storage buffer, in the order of the bindings.
    pub elements: &'a [u64],
    /// Workgroups along z.
    pub workgroups_z: u64,
}

/// The formula of a kernel: the bytes of its parameters, and the dispatch.
pub type WorkOf = fn(&[u8], Shape<'_>) -> Work;

/// Bytes of an `f32` or `u32`.
pub const NUMBER: u64 = 4;

/// Bytes of a `Vec4`.
pub const VECTOR: u64 = 16;

/// Parameters as numbers to calculate with.
#[must_use]
pub fn wide<const N: usize>(numbers: [u32; N]) -> [u64; N] {
    numbers.map(u64::from)
}
