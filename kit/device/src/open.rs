//! Chooses a device.

use organza_kernel::kernel::InstructionSet;

use crate::device::{Device, Kind};
use crate::error::{Error, Result};
use crate::modules::Modules;
use crate::{cpu, gpu};

/// Which backend to take.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum BackendChoice {
    /// A GPU where there is one, else the CPU.
    #[default]
    Auto,
    /// A GPU, or an error.
    Gpu,
    /// The CPU.
    Cpu,
}

/// How SPIR-V reaches the driver.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SpirvPath {
    /// Unchanged: only on Vulkan.
    Passthrough,
    /// Read and written again by naga: everywhere.
    Naga,
}

impl SpirvPath {
    /// `passthrough` or `naga`.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Passthrough => "passthrough",
            Self::Naga => "naga",
        }
    }
}

/// What device to open; the default is the best there is.
#[derive(Clone, Debug, Default)]
pub struct DeviceOptions {
    /// Which backend.
    pub backend: BackendChoice,
    /// How SPIR-V reaches the driver; passed through where that can be had, unless set.
    pub spirv: Option<SpirvPath>,
    /// Threads of the CPU backend; one for each core unless set.
    pub threads: Option<usize>,
    /// Part of the name of the GPU to take, in any case.
    pub adapter: Option<String>,
    /// On the CPU, whether to fail where two invocations of a dispatch get in each other's way in a storage buffer.
    /// For tests of kernels: slow, and 16 bytes for every element that a kernel may write.
    pub check_races: bool,
    /// On the CPU, what kernels with lanes run on; the best that there is unless set.
    pub instruction_set: Option<InstructionSet>,
    /// On a GPU, whether kernels that have a [variant](organza_kernel::KernelInfo::variant) run that, or their plain entry
    /// point; a hardware device runs variants, unless set.
    pub variants: Option<bool>,
}

impl DeviceOptions {
    /// The CPU with `threads` threads.
    #[must_use]
    pub fn cpu(threads: Option<usize>) -> Self {
        Self { backend: BackendChoice::Cpu, threads, ..Self::default() }
    }

    /// A GPU, or an error.
    #[must_use]
    pub fn gpu(spirv: SpirvPath) -> Self {
        Self { backend: BackendChoice::Gpu, spirv: Some(spirv), ..Self::default() }
    }
}

pub fn open(options: &DeviceOptions, modules: &'static Modules) -> Result<Device> {
    match options.backend {
        BackendChoice::Cpu => open_cpu(options, "asked for"),
        BackendChoice::Gpu => {
            let gpu = gpu::Gpu::open(options, modules)?;
            let choice = format!("gpu: {} (asked for)", gpu.description());
            Ok(Device::new(Kind::Gpu(Box::new(gpu)), choice))
        }
        BackendChoice::Auto => match gpu::Gpu::open(options, modules) {
            // a software device runs the same kernels on the same cores, with less to choose from
            Ok(gpu) if gpu.is_software() => {
                open_cpu(options, &format!("the only GPU is a software device, {}", gpu.name()))
            }
            Ok(gpu) => {
                let choice =
                    format!("gpu: {} (found; `--backend cpu` uses the CPU)", gpu.description());
                Ok(Device::new(Kind::Gpu(Box::new(gpu)), choice))
            }
            Err(Error::NoGpu { reason }) => open_cpu(options, &format!("no usable GPU: {reason}")),
            Err(error) => Err(error),
        },
    }
}

fn open_cpu(options: &DeviceOptions, why: &str) -> Result<Device> {
    let cpu = cpu::Cpu::new(options.threads, options.check_races, options.instruction_set)?;
    let threads = cpu.threads();
    let plural = if threads == 1 { "" } else { "s" };
    let set = cpu.instruction_set().as_str();
    let choice = format!("cpu: {threads} thread{plural}, {set} ({why})");
    Ok(Device::new(Kind::Cpu(cpu), choice))
}
