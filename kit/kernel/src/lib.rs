//! The kernel language: write a compute kernel once, in Rust, and run it on every GPU and on the CPU.
//!
//! A kernel is a function with the attribute [`kernel`](macro@prelude::kernel). Its parameters are its bindings. Start with
//! the [`prelude`], [`memory`] (buffers) and [`invocation`]. [`lane`] and [`samples`] are SIMD on the CPU, [`shared_tile`] is
//! workgroup memory as a cache, [`atomic`] and [`fixed`] are sums that do not depend on the order, and [`count`] has numbers
//! that stay on the device. The host finds all kernels in the [registry](kernel::kernels).
//!
//! The crate is compiled twice. Rust-GPU compiles it to SPIR-V, where [`memory::Read`] and [`memory::Write`] are storage
//! buffers. For the CPU they are views of slices, and every access is checked.
#![no_std]
#![cfg_attr(target_arch = "spirv", feature(f16, asm_experimental_arch))]
// the shader compiler cannot compile what clippy suggests instead
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
