//! The kernel language: what a compute kernel is written in, once, for every GPU and for the CPU.
//!
//! A kernel is an ordinary function with the attribute [`kernel`](macro@prelude::kernel); its parameters are its bindings.
//! The crate is compiled twice: to SPIR-V by Rust-GPU, where [`memory::Read`] and [`memory::Write`] are storage
//! buffers, and for the host, where they are views of slices and every access is checked.
#![no_std]
#![cfg_attr(target_arch = "spirv", feature(f16, asm_experimental_arch))]
// what clippy would have instead is more than the shader compiler takes
#![allow(clippy::implicit_saturating_sub, clippy::manual_range_contains, clippy::manual_clamp)]

// `#[kernel]` writes `::organza_kernel`, here as everywhere
extern crate self as organza_kernel;

pub mod atomic;
pub mod count;
pub mod fixed;
pub mod half;
pub mod invocation;
#[cfg(not(target_arch = "spirv"))]
pub mod kernel;
pub mod lane;
pub mod lane_vec4;
pub mod math;
pub mod memory;
pub mod prelude;
#[cfg(not(target_arch = "spirv"))]
pub mod running;
pub mod samples;
pub mod shared_tile;
#[cfg(not(target_arch = "spirv"))]
mod wide;
#[cfg(not(target_arch = "spirv"))]
mod wide_math;
#[cfg(not(target_arch = "spirv"))]
pub mod work;

#[cfg(not(target_arch = "spirv"))]
pub use kernel::{Access, BindingInfo, EntryPoint, KernelInfo, SharedInfo, kernels};

/// Dependencies of what `#[kernel]` writes.
#[doc(hidden)]
pub mod dependencies {
    pub use bytemuck;
    pub use glam;
    #[cfg(not(target_arch = "spirv"))]
    pub use linkme;
    pub use spirv_std;
}
