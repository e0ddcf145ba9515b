//! Devices: buffers and dispatches, on a GPU through wgpu or on the CPU.
//!
//! [`Device::open`] chooses a backend and gets the program's compiled kernels, its [`Modules`]. Code that uses a [`Device`] does
//! not know the backend: the same dispatch of the same kernel runs on both.
//!
//! # Kernels for GPUs
//!
//! A GPU runs compiled kernels. A program registers them when it opens a device: its build script finds them with
//! `organza_manifest::embed`, and [`modules`] embeds them. Where a module is missing or older than its kernel's declaration, the
//! device refuses that kernel and says so. The CPU needs none.
//!
//! ```ignore
//! static MODULES: organza_device::Modules = organza_device::modules!();
//! let device = Device::open(&DeviceOptions::default(), &MODULES)?;
//! ```
//!
//! # Tests
//!
//! [`DeviceOptions::checked`] is the CPU as tests want it. It finds races between invocations, and reads of what nothing has written:
//! allocate what kernels fill with [`Device::unwritten`]. It also runs one workgroup more than needed, which must do nothing.

mod buffer;
mod count;
mod cpu;
mod cpu_memory;
mod device;
mod error;
mod gpu;
pub mod memory;
mod modules;
mod open;
mod races;
mod supervise;
mod timings;
mod transfer;
mod written;

pub use buffer::{Buffer, Host, TAIL_ALIGNMENT};
pub use count::Count;
pub use device::Device;
pub use error::{Error, Result, format_bytes};
pub use gpu::{AdapterInfo, adapters};
#[doc(hidden)]
pub use modules::Aligned;
pub use modules::{CodeSize, CompiledKernel, Modules};
pub use open::{BackendChoice, DeviceOptions, SpirvPath};
pub use organza_kernel::kernel::{InstructionSet, kernels_of};
pub use timings::KernelTime;
