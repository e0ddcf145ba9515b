//! Devices: buffers and dispatches, on a GPU through wgpu or on the CPU.
//!
//! [`Device::open`] chooses a backend and gets the program's compiled kernels, its [`Modules`]. Code that uses a [`Device`] does
//! not know the backend: the same dispatch of the same kernel runs on both.

mod buffer;
mod coroutine;
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

pub use buffer::{Buffer, Host, TAIL_ALIGNMENT};
pub use count::Count;
pub use device::Device;
pub use error::{Error, Result, format_bytes};
pub use gpu::{AdapterInfo, adapters};
#[doc(hidden)]
pub use modules::Aligned;
pub use modules::{CodeSize, CompiledKernel, Modules};
pub use open::{BackendChoice, DeviceOptions, SpirvPath};
pub use organza_kernel::kernel::InstructionSet;
pub use timings::KernelTime;
