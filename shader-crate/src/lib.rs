//! The kernels of organza.  One stage, one file; each kernel is an ordinary function.
//!
//! The crate is compiled twice: to SPIR-V by Rust-GPU, where [`Read`](organza_kernel::memory::Read) and [`Write`](organza_kernel::memory::Write) are
//! storage buffers, and for the host, where they are views of slices and every access is checked.
#![no_std]
#![cfg_attr(target_arch = "spirv", feature(f16, asm_experimental_arch))]
// what clippy would have instead is more than the shader compiler takes
#![allow(clippy::implicit_saturating_sub, clippy::manual_range_contains, clippy::manual_clamp)]

pub mod adam;
pub mod camera;
pub mod color;
pub mod color_backward;
pub mod composite;
pub mod composite_backward;
pub mod count;
pub mod dense;
pub mod dense_backward;
pub mod dense_half;
pub mod hash_grid;
pub mod hash_grid_backward;
pub mod hash_grid_half;
pub mod hash_grid_scale;
pub mod lens;
pub mod limits;
pub mod loss;
pub mod pair;
pub mod peak;
pub mod project;
pub mod project_backward;
pub mod resolve;
pub mod scan;
pub mod segment;
pub mod spherical_harmonics;
pub mod splat;
pub mod ssim;
pub mod statistics;
pub mod tile;
pub mod tile_cells;
pub mod transmittance;
pub mod transmittance_backward;
pub mod unit_cube;
