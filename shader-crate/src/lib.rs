//! The kernels of organza.  One stage, one file; each kernel is an ordinary function.
//!
//! The crate is compiled twice: to SPIR-V by Rust-GPU, where [`memory::Read`] and [`memory::Write`] are
//! storage buffers, and for the host, where they are views of slices and every access is checked.
#![no_std]
// what clippy would have instead is more than the shader compiler takes
#![allow(clippy::manual_range_contains, clippy::manual_clamp)]

pub mod atomic;
pub mod camera;
pub mod color;
pub mod composite;
pub mod dense;
pub mod hash_grid;
pub mod invocation;
#[cfg(not(target_arch = "spirv"))]
pub mod kernel;
pub mod limits;
pub mod math;
pub mod memory;
pub mod pair;
#[cfg(not(target_arch = "spirv"))]
pub mod place;
pub mod prelude;
pub mod project;
pub mod scan;
pub mod segment;
pub mod spherical_harmonics;
pub mod splat;
pub mod tile;
pub mod transmittance;
pub mod unit_cube;

#[cfg(not(target_arch = "spirv"))]
pub use kernel::{Access, BindingInfo, KernelInfo, SharedInfo, kernels};
