//! Values that no kernel computes, for outputs before a kernel runs.

use bytemuck::Pod;
use glam::Vec4;

/// Fills an output before the kernel runs: elements that the kernel should not write must keep this value.
pub trait Canary: Pod + PartialEq {
    /// A value that no kernel computes.
    const CANARY: Self;
    /// Another value that no kernel computes. A case fills the outputs of one device with this value, and those of
    /// the other device with [`Canary::CANARY`]. A kernel that reads its unwritten output then gives two different
    /// results.
    const OTHER_CANARY: Self;
}

impl Canary for f32 {
    const CANARY: Self = -12_345.5;
    const OTHER_CANARY: Self = 23_456.25;
}

impl Canary for u32 {
    const CANARY: Self = 0x00c0_ffee;
    const OTHER_CANARY: Self = 0x0bad_cafe;
}

impl Canary for Vec4 {
    const CANARY: Self = Self::splat(f32::CANARY);
    const OTHER_CANARY: Self = Self::splat(f32::OTHER_CANARY);
}

/// An output of `len` elements for [`KernelRunner::run`](crate::KernelRunner::run), which no kernel has written. If the kernel reads an element before it
/// writes it, a device with checks reports that.
#[must_use]
pub fn unwritten<T: Canary>(len: usize) -> Vec<T> {
    vec![T::CANARY; len]
}
