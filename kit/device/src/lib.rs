//! Devices: buffers and dispatches, on a GPU through wgpu or on the CPU.
//!
//! [`Device::open`] chooses a backend and gets the program's compiled kernels, its [`Modules`]. Code that uses a [`Device`] does
//! not know the backend: the same dispatch of the same kernel runs on both.
//!
//! # A kernel runs
//!
//! Buffers live on the device. The host uploads inputs, runs kernels and reads what it needs; in between, nothing leaves the device.
//!
//! ```
//! # extern crate muslin_kernel as muslin;
//! use muslin_device::{Device, DeviceOptions, Modules};
//! use muslin::prelude::*;
//!
//! #[params]
//! pub struct SquareParams {
//!     pub count: u32,
//! }
//!
//! #[kernel(threads(64))]
//! pub fn square(id: Invocation, params: &SquareParams, input: Read<f32>, output: Write<f32>) {
//!     if id.index() < params.count {
//!         output.write(id.index(), input.read(id.index()) * input.read(id.index()));
//!     }
//! }
//!
//! fn main() -> muslin_device::Result<()> {
//!     let device = Device::open(&DeviceOptions::checked(), Modules::none())?;
//!     let input = device.upload("input", &[1.0, 2.0, -3.0])?;
//!     let output = device.unwritten("output", 3)?;
//!     let params = SquareParams { count: 3 };
//!     // at least 3 invocations along x, one workgroup along z
//!     device.run(&SquareKernel { params, input: &input, output: &output }, 3, 1)?;
//!     assert_eq!(device.read(&output)?, [1.0, 4.0, 9.0]);
//!     Ok(())
//! }
//! ```
//!
//! This device is the CPU. `DeviceOptions::default()` takes a GPU if there is one, and needs the program's compiled
//! kernels.
//!
//! # Kernels for GPUs
//!
//! GPUs need the feature `gpu`, which is on by default. Without it, wgpu is not compiled, and there is no GPU: enough for tests on
//! the CPU.
//!
//! `cargo xtask kernels`, which is `muslin-build`, compiles kernels to SPIR-V modules. The program's build script finds them with
//! `muslin_manifest::embed_compiled`, and [`modules`] embeds them:
//!
//! ```ignore
//! static MODULES: muslin_device::Modules = muslin_device::modules!();
//! let device = Device::open(&DeviceOptions::default(), &MODULES)?;
//! ```
//!
//! If a module is missing, or older than its kernel's declaration, the device refuses that kernel and says so.
//!
//! # Elsewhere
//!
//! [`Device::from_wgpu`] runs kernels on a device of wgpu that the program has opened, on buffers that may be its own.
//!
//! [`Device::planner`] runs nothing. It records buffers and dispatches as a [`DevicePlan`], which something else can run:
//! for example, a browser with WebGPU.
//!
//! # The device for tests
//!
//! [`DeviceOptions::checked`] is a CPU for tests. It finds races between invocations, NaN, and reads of unwritten
//! elements. Allocate the outputs of kernels with [`Device::unwritten`]. It also runs one workgroup more than needed,
//! which must do nothing.

// `#[kernel]` writes the path `::muslin`
#[cfg(test)]
extern crate muslin_kernel as muslin;

mod buffer;
mod cpu;
mod cpu_dispatch;
mod cpu_memory;
mod device;
#[cfg_attr(not(feature = "gpu"), path = "no_gpu.rs")]
mod gpu;
#[cfg(feature = "gpu")]
mod interop;
mod job;
mod modules;
mod options;
mod panics;
mod plan;
mod races;
mod thorough;
mod transfer;

pub use buffer::{Buffer, Count, Host, TAIL_ALIGNMENT};
pub use device::{Device, KernelTime, Traffic};
pub use gpu::adapters;
#[doc(hidden)]
pub use modules::Aligned;
pub use modules::{CompiledKernel, Modules};
pub use muslin_error::{Error, Result, format_bytes, memory};
pub use muslin_kernel::kernel::{InstructionSet, kernels_of};
pub use muslin_manifest::{STALE, Table, grouped};
pub use options::{AdapterInfo, BackendChoice, DeviceOptions, SpirvPath};
pub use plan::{BufferRange, DevicePlan, PlannedBuffer, PlannedCount, Step};
pub use transfer::Pending;
/// The version of wgpu whose devices and buffers [`Device::from_wgpu`] and [`Buffer::from_wgpu`] take.
#[cfg(feature = "gpu")]
pub use wgpu;
