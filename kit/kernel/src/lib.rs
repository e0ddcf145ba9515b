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
//! # How it runs
//!
//! On the CPU a kernel is compiled with the rest of the program. For GPUs, `muslin-build` compiles it to SPIR-V with
//! [Rust-GPU](https://rust-gpu.github.io). The attribute also writes a struct with a field for each binding, here `SquareKernel`. With
//! `muslin-device` the host fills it and runs it, on either:
//!
//! ```ignore
//! let output = device.unwritten("output", input.len())?;
//! let params = SquareParams { count: input.len() as u32 };
//! device.run(&SquareKernel { params, input: &device.upload("input", &input)?, output: &output }, params.count, 1)?;
//! let squares: Vec<f32> = device.read(&output)?;
//! ```
//!
//! All kernels that a program is linked with are in a [registry](kernel::kernels). A program finds its own by the
//! [package](kernel::kernels_of) that declares them.
//!
//! # How to test it
//!
//! A test beside the kernel calls it as a function. [`Workgroup`](workgroup::Workgroup) does so for every invocation of a workgroup,
//! with barriers, in a second:
//!
//! ```
//! # extern crate muslin_kernel as muslin;
//! # use muslin::prelude::*;
//! # #[params] pub struct SquareParams { pub count: u32 }
//! # #[kernel(threads(64))]
//! # pub fn square(id: Invocation, params: &SquareParams, input: Read<f32>, output: Write<f32>) {
//! #     if id.index() < params.count {
//! #         output.write(id.index(), input.read(id.index()) * input.read(id.index()));
//! #     }
//! # }
//! use muslin::workgroup::Workgroup;
//!
//! # fn main() {
//! let (params, mut output) = (SquareParams { count: 3 }, [0.0; 3]);
//! let (input, view) = (Read::from(&[1.0, 2.0, -3.0][..]), Write::from(&mut output[..]));
//! Workgroup::new([64, 1, 1]).run(|id| square(id, &params, input, view));
//! assert_eq!(output, [1.0, 4.0, 9.0]);
//! # }
//! ```
//!
//! The CPU run is strict where a GPU continues with garbage. It reports an index out of range, a missing or divergent
//! barrier, a race, a read of unwritten memory, and a loop that runs longer than declared. Each message has the
//! kernel, the line, the invocation and the buffer:
//!
//! ```text
//! kernel `square`: index 100 is out of range of `input`, which has 100 elements, at kernels/src/lib.rs:14:29,
//! in invocation [36, 0, 0] of workgroup [1, 0, 0], [100, 0, 0] in the dispatch
//! ```
//!
//! `DeviceOptions::checked()` of `muslin-device` is the device that finds most mistakes.
//!
//! # How to compare devices
//!
//! `muslin-check` runs a kernel with many inputs on the CPU and on a GPU, with both paths of SPIR-V to a driver. It
//! compares the results with each other and with the equations in f64. It also keeps snapshots of tensors and
//! pictures.
//!
//! # How to debug it
//!
//! On the CPU a kernel is an ordinary function, and a debugger stops in it. Compile without optimizations, so that every variable can
//! be printed, and start the test's program, whose path `cargo test --no-run` prints:
//!
//! ```text
//! $ cargo test --no-run --config 'profile.dev.package.my-kernels.opt-level=0'
//! $ rust-gdb -ex 'break lib.rs:14' --args target/debug/deps/my_kernels-0123456789abcdef squares
//! (gdb) run
//! (gdb) print id
//! (gdb) condition 1 id.local.x == 7
//! (gdb) continue
//! ```
//!
//! The condition stops in one invocation. Kernels with lanes show single values with `InstructionSet::Scalar`, which
//! `DeviceOptions::checked()` uses. If a GPU's result differs from the CPU's, the parity test names the output and
//! the element: stop at this element.
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
// the shader compiler cannot compile clippy's suggestions
#![allow(clippy::implicit_saturating_sub, clippy::manual_range_contains, clippy::manual_clamp)]

// `#[kernel]` generates the path `::muslin`, also in this crate
extern crate self as muslin;

pub mod atomic;
pub mod binned;
#[cfg(not(target_arch = "spirv"))]
mod casts;
pub mod count;
#[doc(hidden)]
pub mod each;
pub mod fixed;
#[cfg(not(target_arch = "spirv"))]
mod fused;
#[cfg(not(target_arch = "spirv"))]
pub mod given;
pub mod half;
mod integers;
pub mod invocation;
#[cfg(not(target_arch = "spirv"))]
pub mod kernel;
pub mod lane;
pub mod lane_vec4;
pub mod math;
pub mod memory;
#[cfg(not(target_arch = "spirv"))]
mod path;
pub mod peak;
#[cfg(not(target_arch = "spirv"))]
mod phase;
pub mod prelude;
#[cfg(not(target_arch = "spirv"))]
pub mod running;
pub mod samples;
pub mod shared_tile;
#[cfg(not(target_arch = "spirv"))]
mod stop;
pub mod subgroup;
#[cfg(not(target_arch = "spirv"))]
#[macro_use]
mod wide_macros;
#[cfg(not(target_arch = "spirv"))]
mod wide;
#[cfg(not(target_arch = "spirv"))]
mod wide_index;
#[cfg(not(target_arch = "spirv"))]
mod wide_math;
#[cfg(not(target_arch = "spirv"))]
mod wide_samples;
#[cfg(all(not(target_arch = "spirv"), target_arch = "x86_64"))]
mod wide_vectors;
#[cfg(not(target_arch = "spirv"))]
pub mod work;
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
