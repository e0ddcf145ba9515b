//! Buffers for kernels: [`Read`], [`Write`], [`Packed`] of small integers, [`ReadFours`] and [`WriteFours`], and workgroup
//! memory, [`Shared`].
//!
//! On the GPU, [`Read`] and [`Write`] are slices, indexed without checks. A bounds check inside nested loops would
//! become an exit through several levels, which naga's SPIR-V reader miscompiles
//! (<https://github.com/gfx-rs/wgpu/issues/4449>). Rust-GPU does not know plain `get_unchecked`. On the CPU they are
//! views that check every access.

#[cfg(target_arch = "spirv")]
mod device;
#[cfg(not(target_arch = "spirv"))]
mod host;

#[cfg(target_arch = "spirv")]
pub use device::{
    Packed, Read, ReadBuffer, ReadFours, Shared, SharedBuffer, Write, WriteBuffer, WriteFours,
};
#[cfg(not(target_arch = "spirv"))]
pub use host::{AccessMonitor, Packed, Read, ReadFours, Shared, Touch, Write, WriteFours};

/// Numbers of which a GPU reads and writes four at once, in [`ReadFours`] and [`WriteFours`].
pub trait Fours {
    /// Four of them.
    type Vector: Copy;
}

impl Fours for f32 {
    type Vector = glam::Vec4;
}
