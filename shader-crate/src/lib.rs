//! The kernels of organza.  One stage, one file; each kernel is an ordinary function.
//!
//! The crate is compiled twice: to SPIR-V by Rust-GPU, where [`memory::Read`] and [`memory::Write`] are
//! storage buffers, and for the host, where they are views of slices and every access is checked.
#![no_std]
#![cfg_attr(target_arch = "spirv", feature(f16, asm_experimental_arch))]
// what clippy would have instead is more than the shader compiler takes
#![allow(clippy::implicit_saturating_sub, clippy::manual_range_contains, clippy::manual_clamp)]

pub mod adam;
pub mod atomic;
pub mod camera;
pub mod color;
pub mod color_backward;
pub mod composite;
pub mod composite_backward;
pub mod count;
pub mod dense;
pub mod dense_backward;
pub mod dense_half;
pub mod fixed;
pub mod half;
pub mod hash_grid;
pub mod hash_grid_backward;
pub mod hash_grid_half;
pub mod hash_grid_scale;
pub mod invocation;
#[cfg(not(target_arch = "spirv"))]
pub mod kernel;
pub mod lane;
pub mod lens;
pub mod limits;
pub mod loss;
pub mod math;
pub mod memory;
pub mod pair;
pub mod peak;
#[cfg(not(target_arch = "spirv"))]
pub mod place;
pub mod prelude;
pub mod project;
pub mod project_backward;
pub mod resolve;
pub mod samples;
pub mod scan;
pub mod segment;
pub mod spherical_harmonics;
pub mod splat;
pub mod ssim;
pub mod stage;
pub mod tile;
pub mod tile_cells;
pub mod transmittance;
pub mod transmittance_backward;
pub mod unit_cube;
#[cfg(not(target_arch = "spirv"))]
mod wide;
#[cfg(not(target_arch = "spirv"))]
mod wide_math;

#[cfg(not(target_arch = "spirv"))]
pub use kernel::{Access, BindingInfo, EntryPoint, KernelInfo, SharedInfo, kernels};
