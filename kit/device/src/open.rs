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
///
/// ```
/// use organza_device::{DeviceOptions, SpirvPath};
///
/// let cpu = DeviceOptions::cpu(4);
/// let gpu = DeviceOptions::gpu(SpirvPath::Naga).adapter("radeon".to_owned());
/// assert_eq!((cpu.threads, gpu.adapter.as_deref()), (Some(4), Some("radeon")));
/// ```
#[derive(Clone, Debug, Default)]
#[non_exhaustive]
pub struct DeviceOptions {
    /// Which backend.
    pub backend: BackendChoice,
    /// How SPIR-V reaches the driver; passed through where that can be had, unless set.
    pub spirv: Option<SpirvPath>,
    /// Threads of the CPU backend; one for each core unless set.
    pub threads: Option<usize>,
    /// Part of the name of the GPU to take, in any case.
    pub adapter: Option<String>,
    /// Which of several equally capable GPUs to take, counted from 0 and around: for processes that share a machine.
    pub place: usize,
    /// On the CPU, whether to fail where two invocations of a dispatch get in each other's way in a storage buffer, where a
    /// kernel reads what [nothing has written](Device::unwritten). For tests of kernels: slow, and 24
    /// bytes for every element that a kernel may write.
    pub check_races: bool,
    /// With [`check_races`](Self::check_races), whether to fail where a kernel writes NaN to `f32` or vectors of them, also to
    /// elements that nobody reads.
    pub check_nan: bool,
    /// Whether [`Device::run`] and [`Device::run_over`] start one workgroup more than needed, along x and, for a size, along
    /// y. For tests of kernels: their invocations must do nothing.
    pub extra_workgroup: bool,
    /// On the CPU, what kernels with lanes run on; the best that there is unless set.
    pub instruction_set: Option<InstructionSet>,
    /// On a GPU, whether kernels that have a [variant](organza_kernel::KernelInfo::variant) run that, or their plain entry
    /// point; a hardware device runs variants, unless set. The CPU runs variants if this is set with
    /// [`check_races`](Self::check_races).
    pub variants: Option<bool>,
}

impl DeviceOptions {
    /// The CPU with a number of threads; `None` takes one for each core.
    #[must_use]
    pub fn cpu(threads: impl Into<Option<usize>>) -> Self {
        Self { backend: BackendChoice::Cpu, threads: threads.into(), ..Self::default() }
    }

    /// A GPU, or an error.
    #[must_use]
    pub fn gpu(spirv: SpirvPath) -> Self {
        Self { backend: BackendChoice::Gpu, spirv: Some(spirv), ..Self::default() }
    }

    /// The CPU as tests of kernels want it: it [looks for races](Self::check_races), for reads of what nothing has written and
    /// for [NaN](Self::check_nan), and runs [one workgroup more](Self::extra_workgroup) than needed.
    #[must_use]
    pub fn checked() -> Self {
        Self { check_races: true, check_nan: true, extra_workgroup: true, ..Self::cpu(None) }
    }

    /// Sets [`backend`](Self::backend).
    #[must_use]
    pub fn backend(mut self, backend: BackendChoice) -> Self {
        self.backend = backend;
        self
    }

    /// Sets [`spirv`](Self::spirv).
    #[must_use]
    pub fn spirv(mut self, path: impl Into<Option<SpirvPath>>) -> Self {
        self.spirv = path.into();
        self
    }

    /// Sets [`threads`](Self::threads).
    #[must_use]
    pub fn threads(mut self, threads: impl Into<Option<usize>>) -> Self {
        self.threads = threads.into();
        self
    }

    /// Sets [`adapter`](Self::adapter).
    #[must_use]
    pub fn adapter(mut self, name: impl Into<Option<String>>) -> Self {
        self.adapter = name.into();
        self
    }

    /// Sets [`place`](Self::place).
    #[must_use]
    pub fn place(mut self, place: usize) -> Self {
        self.place = place;
        self
    }

    /// Sets [`check_races`](Self::check_races).
    #[must_use]
    pub fn check_races(mut self, check: bool) -> Self {
        self.check_races = check;
        self
    }

    /// Sets [`check_nan`](Self::check_nan).
    #[must_use]
    pub fn check_nan(mut self, check: bool) -> Self {
        self.check_nan = check;
        self
    }

    /// Sets [`extra_workgroup`](Self::extra_workgroup).
    #[must_use]
    pub fn extra_workgroup(mut self, extra: bool) -> Self {
        self.extra_workgroup = extra;
        self
    }

    /// Sets [`instruction_set`](Self::instruction_set).
    #[must_use]
    pub fn instruction_set(mut self, set: impl Into<Option<InstructionSet>>) -> Self {
        self.instruction_set = set.into();
        self
    }

    /// Sets [`variants`](Self::variants).
    #[must_use]
    pub fn variants(mut self, variants: impl Into<Option<bool>>) -> Self {
        self.variants = variants.into();
        self
    }
}

pub fn open(options: &DeviceOptions, modules: &'static Modules) -> Result<Device> {
    let device = match options.backend {
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
    };
    device.map(|device| device.with_extra_workgroup(options.extra_workgroup))
}

fn open_cpu(options: &DeviceOptions, why: &str) -> Result<Device> {
    let cpu = cpu::Cpu::new(options)?;
    let threads = cpu.threads();
    let plural = if threads == 1 { "" } else { "s" };
    let set = cpu.instruction_set().as_str();
    let choice = format!("cpu: {threads} thread{plural}, {set} ({why})");
    Ok(Device::new(Kind::Cpu(cpu), choice))
}
