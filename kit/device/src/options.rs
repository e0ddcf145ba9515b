//! Options of a device, and its choice.

use crate::device::{Device, DeviceKind};
use crate::plan::Planner;
use crate::{Error, Modules, Result};
use crate::{cpu, gpu};
use muslin_kernel::kernel::InstructionSet;

/// The backend to use.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum BackendChoice {
    /// A GPU if there is one, otherwise the CPU.
    #[default]
    Auto,
    /// A GPU, or an error.
    Gpu,
    /// The CPU.
    Cpu,
}

/// The path of SPIR-V to the driver.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SpirvPath {
    /// Unchanged, only on Vulkan.
    Passthrough,
    /// Translated by naga, on every interface.
    Naga,
}

impl SpirvPath {
    /// Name of the path: `passthrough` or `naga`.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Passthrough => "passthrough",
            Self::Naga => "naga",
        }
    }
}

/// A GPU that the system offers.
#[derive(Clone, Debug)]
pub struct AdapterInfo {
    /// Name, which [`DeviceOptions::adapter`] can select.
    pub name: String,
    /// Interface, driver and version, as far as known.
    pub driver: String,
    /// Whether it accepts SPIR-V unchanged.
    pub passes_through: bool,
}

/// Options of the device to open. The default is the best device of the machine.
///
/// ```
/// use muslin_device::{DeviceOptions, SpirvPath};
///
/// let cpu = DeviceOptions::cpu(4);
/// let gpu = DeviceOptions::gpu(SpirvPath::Naga).adapter("radeon".to_owned());
/// assert_eq!((cpu.threads, gpu.adapter.as_deref()), (Some(4), Some("radeon")));
/// ```
#[derive(Clone, Debug, Default)]
#[non_exhaustive]
pub struct DeviceOptions {
    /// The backend to use.
    pub backend: BackendChoice,
    /// The path of SPIR-V to the driver. By default it is passed through if possible.
    pub spirv: Option<SpirvPath>,
    /// Number of threads of the CPU backend. By default, one per core.
    pub threads: Option<usize>,
    /// Part of the GPU's name, in upper or lower case.
    pub adapter: Option<String>,
    /// Index among equally capable GPUs, modulo their number: for processes that share a machine.
    pub place: usize,
    /// Whether the CPU fails if two invocations of a dispatch conflict in a storage buffer, or if a kernel reads an
    /// [unwritten](crate::Device::unwritten) element. For tests of kernels: it is slow, and takes 24 bytes for every element
    /// that a kernel may write. It also fails if a kernel writes NaN to `f32` or vectors of them, even to elements that are never read.
    pub check_races: bool,
    /// Whether [`Device::run`](crate::Device::run) and [`Device::run_over`](crate::Device::run_over) start one workgroup more than needed along x, and along y if
    /// there is a size. For tests of kernels: the additional invocations must do nothing.
    pub extra_workgroup: bool,
    /// With [`check_races`](Self::check_races), a seed: each dispatch runs in a random order of workgroups and invocations, on one
    /// thread, once more in the reverse order, once more without denormals (on x86-64), once more with fused and with regrouped
    /// arithmetic (in debug builds), and, if it has subgroups, with all their sizes. The results must agree; where the arithmetic is another one, the integers and which
    /// floats are finite, and where it is regrouped, floats to a thousandth.
    pub thorough: Option<u64>,
    /// Whether the CPU flushes denormals to zero, as some GPUs do: in arithmetic, and where numbers are compared. Only on x86-64.
    pub flush_denormals: bool,
    /// Number of lanes of a [subgroup](muslin_kernel::subgroup) on the CPU, one of its [sizes](muslin_kernel::subgroup::SIZES). By default 32, and on a
    /// [thorough](Self::thorough) device one that the seed chooses.
    pub subgroup_size: Option<u32>,
    /// Instruction set of kernels with lanes, on the CPU. By default, the best one of the CPU.
    pub instruction_set: Option<InstructionSet>,
    /// Whether a GPU runs the [variant](muslin_kernel::KernelInfo::variant) of a kernel that has one, or its plain
    /// entry point. By default, a hardware device runs variants. The CPU runs variants if this is set together with
    /// [`check_races`](Self::check_races).
    pub variants: Option<bool>,
    /// Whether a software GPU gets work in a card's portions. For tests of what a card is asked for: it is slower.
    pub like_a_card: bool,
}

impl DeviceOptions {
    /// The CPU with a number of threads; `None` means one per core.
    #[must_use]
    pub fn cpu(threads: impl Into<Option<usize>>) -> Self {
        Self { backend: BackendChoice::Cpu, threads: threads.into(), ..Self::default() }
    }

    /// A GPU, or an error.
    #[must_use]
    pub fn gpu(spirv: SpirvPath) -> Self {
        Self { backend: BackendChoice::Gpu, spirv: Some(spirv), ..Self::default() }
    }

    /// The CPU for tests of kernels: it [looks for races](Self::check_races), for reads of unwritten elements and for
    /// NaN, and runs [one workgroup more](Self::extra_workgroup) than needed.
    #[must_use]
    pub fn checked() -> Self {
        Self { check_races: true, extra_workgroup: true, ..Self::cpu(None) }
    }

    /// Like [`checked`](Self::checked), for all that takes several times as long: see [`thorough`](Self::thorough). Each seed is
    /// another test.
    #[must_use]
    pub fn thorough(seed: u64) -> Self {
        Self { thorough: Some(seed), ..Self::checked() }
    }
}

/// A method for each option, which sets it.
macro_rules! setters {
    ($($name:ident: $type:ty,)*) => {
        impl DeviceOptions {$(
            #[doc = concat!("Sets [`", stringify!($name), "`](Self::", stringify!($name), ").")]
            #[must_use]
            pub fn $name(mut self, value: $type) -> Self {
                self.$name = value.into();
                self
            }
        )*}
    };
}

setters! {
    backend: BackendChoice,
    spirv: impl Into<Option<SpirvPath>>,
    threads: impl Into<Option<usize>>,
    adapter: impl Into<Option<String>>,
    place: usize,
    check_races: bool,
    extra_workgroup: bool,
    flush_denormals: bool,
    subgroup_size: impl Into<Option<u32>>,
    instruction_set: impl Into<Option<InstructionSet>>,
    variants: impl Into<Option<bool>>,
    like_a_card: bool,
}

impl Device {
    /// Opens the device that `options` describe. `modules` are the compiled kernels for a GPU.
    ///
    /// # Errors
    /// [`Error::NoGpu`](crate::Error::NoGpu) if a GPU was demanded and none can be used.
    pub fn open(options: &DeviceOptions, modules: &'static Modules) -> Result<Self> {
        let device = match options.backend {
            BackendChoice::Cpu => open_cpu(options, "asked for"),
            BackendChoice::Gpu => {
                let gpu = gpu::Gpu::open(options, modules)?;
                let choice = format!("gpu: {} (asked for)", gpu.description());
                Ok(Device::new(DeviceKind::Gpu(Box::new(gpu)), choice))
            }
            BackendChoice::Auto => match gpu::Gpu::open(options, modules) {
                // a software device runs the same kernels on the same cores, with fewer choices
                Ok(gpu) if gpu.is_software() => {
                    open_cpu(options, &format!("the only GPU is a software device, {}", gpu.name()))
                }
                Ok(gpu) => {
                    let choice =
                        format!("gpu: {} (found; `--backend cpu` uses the CPU)", gpu.description());
                    Ok(Device::new(DeviceKind::Gpu(Box::new(gpu)), choice))
                }
                Err(Error::NoGpu { reason }) => {
                    open_cpu(options, &format!("no usable GPU: {reason}"))
                }
                Err(error) => Err(error),
            },
        };
        device.map(|device| device.with_extra_workgroup(options.extra_workgroup))
    }

    /// A device that runs nothing and records all requests for [`Device::take_plan`]. Reading one of its buffers is
    /// an error. It has the limits that every browser with WebGPU supports.
    #[must_use]
    pub fn planner() -> Self {
        Self::new(DeviceKind::Planner(Planner::default()), "a plan, to be run elsewhere".into())
    }
}

fn open_cpu(options: &DeviceOptions, why: &str) -> Result<Device> {
    let cpu = cpu::Cpu::new(options)?;
    let threads = cpu.threads();
    let plural = if threads == 1 { "" } else { "s" };
    let set = cpu.instruction_set().as_str();
    let choice = format!("cpu: {threads} thread{plural}, {set} ({why})");
    Ok(Device::new(DeviceKind::Cpu(cpu), choice))
}
