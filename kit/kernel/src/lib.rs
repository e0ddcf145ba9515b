//! The kernel language: write a compute kernel once, in Rust, and run it on every GPU and on the CPU.
//!
//! # What a kernel is
//!
//! A kernel is a function that a device calls many times at once: each call is an *invocation*, and does a small part of the work.
//! The attribute [`kernel`](macro@prelude::kernel) declares it. Its parameters are its bindings:
//!
//! ```
//! # extern crate muslin_kernel as muslin;
//! use muslin::prelude::*;
//!
//! /// Parameters of [`square`].
//! #[params]
//! pub struct SquareParams {
//!     /// Values to square.
//!     pub count: u32,
//! }
//!
//! /// `output = input^2`
//! #[kernel(threads(64))]
//! pub fn square(id: Invocation, params: &SquareParams, input: Read<f32>, output: Write<f32>) {
//!     let index = id.index();
//!     if index < params.count {
//!         output.write(index, input.read(index) * input.read(index));
//!     }
//! }
//! # fn main() {}
//! ```
//!
//! `threads(64)` says that 64 invocations form a *workgroup*. A dispatch has whole workgroups, so the last one can have invocations
//! without an item: a kernel starts with a test of its index. The invocations of a workgroup can share memory,
//! [`Shared`](memory::Shared), and wait for each other, [`Invocation::barrier`](invocation::Invocation::barrier). [`atomic`] lets
//! invocations count together. [`lane`] and [`samples`] are SIMD on the CPU.
//!
//! [`muslin`](https://docs.rs/muslin) says how to run, test and compare kernels; it exports this crate.
//!
//! # The crate
//!
//! Start with the [`prelude`], [`memory`] (buffers) and [`invocation`]. [`shared_tile`] is workgroup memory as a
//! cache, [`fixed`] and [`binned`] have sums that do not depend on the order, and [`count`] has numbers that stay on
//! the device.
//!
//! The crate is compiled twice. Rust-GPU compiles it to SPIR-V, where [`memory::Read`] and [`memory::Write`] are
//! storage buffers. For the CPU they are views of slices, and every access is checked.
#![no_std]
// of the compilation for tiles; rustc for GPUs is always a nightly
#![cfg_attr(target_arch = "spirv", allow(unused_features), feature(asm_experimental_arch, f16))]
// the shader compiler cannot compile clippy's suggestions
#![allow(clippy::implicit_saturating_sub, clippy::manual_range_contains, clippy::manual_clamp)]

#[cfg(target_endian = "big")]
compile_error!("words and 64-bit sums are read as GPUs store them, with the low byte first");

// `#[kernel]` generates the path `::muslin`, also in this crate
extern crate self as muslin;

/// What `#[kernel]` adds in debug builds on the CPU. It asks how this crate is built, not the author's: so a crate of kernels can do
/// without the standard library's checks and keep these.
#[doc(hidden)]
#[macro_export]
#[cfg(all(not(target_arch = "spirv"), debug_assertions))]
macro_rules! checked {
    (($($checked:tt)*) else ($($plain:tt)*)) => { $($checked)* };
    ($($checked:tt)*) => { $($checked)* };
}
#[doc(hidden)]
#[macro_export]
#[cfg(not(all(not(target_arch = "spirv"), debug_assertions)))]
macro_rules! checked {
    (($($checked:tt)*) else ($($plain:tt)*)) => { $($plain)* };
    ($($checked:tt)*) => {};
}

// before `lane`, which has its macros
#[cfg(not(target_arch = "spirv"))]
#[macro_use]
mod wide_macros;

pub mod atomic;
#[cfg(not(target_arch = "spirv"))]
mod binding;
pub mod binned;
#[cfg(not(target_arch = "spirv"))]
mod casts;
#[cfg(not(target_arch = "spirv"))]
mod conflict;
pub mod count;
#[doc(hidden)]
pub mod each;
pub mod fixed;
#[cfg(not(target_arch = "spirv"))]
mod fused;
#[cfg(not(target_arch = "spirv"))]
pub mod given;
pub mod half;
pub mod invocation;
#[cfg(not(target_arch = "spirv"))]
pub mod kernel;
pub mod lane;
pub mod lane_vec4;
pub mod math;
pub mod memory;
mod pack;
#[cfg(not(target_arch = "spirv"))]
mod phase;
pub mod prelude;
#[doc(hidden)]
#[cfg(not(target_arch = "spirv"))]
pub mod regions;
#[cfg(not(target_arch = "spirv"))]
pub mod running;
pub mod samples;
mod scalar;
pub mod shared_tile;
#[cfg(not(target_arch = "spirv"))]
mod stop;
pub mod subgroup;
pub mod tile;
#[cfg(all(not(target_arch = "spirv"), target_arch = "x86_64"))]
mod wide_vectors;
#[cfg(not(target_arch = "spirv"))]
pub mod workgroup;
#[cfg(not(target_arch = "spirv"))]
mod workgroup_memory;

#[cfg(not(target_arch = "spirv"))]
pub use kernel::{Access, BindingInfo, EntryPoint, KernelInfo, SharedInfo, kernels, kernels_of};

/// Most iterations of all loops of one invocation together: llvmpipe ends it silently after 65,536.
pub const MAX_ITERATIONS: u32 = 60_000;

// vectors for kernels and their hosts
pub use glam;

/// Dependencies of the code that `#[kernel]` generates.
#[doc(hidden)]
pub mod dependencies {
    pub use bytemuck;
    pub use glam;
    #[cfg(not(target_arch = "spirv"))]
    pub use linkme;
    pub use spirv_std;
}
