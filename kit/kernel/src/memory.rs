//! Buffers, as kernels see them: [`Read`], [`Write`] and workgroup memory, [`Shared`].
//!
//! On the GPU [`Read`] and [`Write`] are slices, indexed without checks: a bounds check inside nested loops
//! becomes an exit through several levels, which naga's SPIR-V reader miscompiles
//! (<https://github.com/gfx-rs/wgpu/issues/4449>), and plain `get_unchecked` is not known to Rust-GPU.
//! On the CPU they are views that check every access.

#[cfg(target_arch = "spirv")]
mod device;
#[cfg(not(target_arch = "spirv"))]
mod host;
#[cfg(not(target_arch = "spirv"))]
mod monitor;

#[cfg(target_arch = "spirv")]
pub use device::{Read, ReadBuffer, Shared, SharedBuffer, Write, WriteBuffer};
#[cfg(not(target_arch = "spirv"))]
pub use host::{Read, Shared, Write};
#[cfg(not(target_arch = "spirv"))]
pub use monitor::{AccessMonitor, Touch};
