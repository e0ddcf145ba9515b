//! A buffer of a GPU, in builds with and without wgpu.

/// A buffer of a GPU.
#[cfg(feature = "gpu")]
pub type GpuBuffer = crate::gpu::GpuMemory;

/// No buffer: there is no GPU without the feature `gpu`.
#[cfg(not(feature = "gpu"))]
#[derive(Clone, Debug, PartialEq)]
pub enum GpuBuffer {}
