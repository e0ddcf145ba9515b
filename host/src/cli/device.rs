//! Options that choose a device.

use std::time::Instant;

use clap::ValueEnum;
use clap::builder::PossibleValuesParser;
use organza::{
    BackendChoice, DeviceOptions, InstructionSet, Renderer, Result, SpirvPath, UploadOptions,
};

use super::console::Console;
use super::refuse;

/// The device, and storage of the scene on it.
#[derive(Debug, clap::Args)]
pub struct SceneArgs {
    /// Store both hash grids in half precision: half their memory, each feature off by at most 1/2048; no gradients
    #[arg(long, help_heading = "Device", hide_short_help = true)]
    pub half_grids: bool,
    #[command(flatten)]
    pub device: DeviceArgs,
}

impl SceneArgs {
    pub fn options(&self) -> UploadOptions {
        UploadOptions { half_grids: self.half_grids }
    }
}

/// Options of the subcommands that render.
#[derive(Clone, Debug, clap::Args)]
pub struct DeviceArgs {
    /// The device to use; `auto` takes a GPU if there is one, and says which
    #[arg(long, value_enum, default_value_t, help_heading = "Device", hide_short_help = true)]
    backend: Backend,

    /// How kernels reach the GPU's driver: as SPIR-V (Vulkan only), or translated by naga
    /// [default: passthrough if the GPU supports it]
    #[arg(long, value_parser = ["passthrough", "naga"], help_heading = "Device", hide_short_help = true)]
    spirv: Option<String>,

    /// Use the GPU whose name contains this text
    #[arg(long, value_name = "NAME", help_heading = "Device", hide_short_help = true)]
    adapter: Option<String>,

    /// Which kernels a GPU runs: `plain` ones, or the `best` it has, with workgroup memory or 64-bit atomics
    /// [default: best; plain on a software device]
    #[arg(long, value_parser = ["plain", "best"], help_heading = "Device", hide_short_help = true)]
    variants: Option<String>,

    /// Threads of the CPU backend [default: one per core]
    #[arg(long, value_name = "N", help_heading = "Device", hide_short_help = true)]
    #[arg(value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,

    /// Instruction set of the CPU backend; `scalar` runs one invocation at a time, for debugging
    /// [default: the widest of this CPU]
    #[arg(long, value_name = "SET", help_heading = "Device", hide_short_help = true)]
    #[arg(value_parser = PossibleValuesParser::new(InstructionSet::ALL.map(InstructionSet::as_str)))]
    instruction_set: Option<String>,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, ValueEnum)]
enum Backend {
    #[default]
    Auto,
    Gpu,
    Cpu,
}

impl DeviceArgs {
    /// Opens the device and says which it is.
    pub fn open(&self, console: Console) -> Result<Renderer> {
        self.open_as(&self.options()?, console)
    }

    /// Opens a device of such options, and says which it is.
    pub fn open_as(&self, options: &DeviceOptions, console: Console) -> Result<Renderer> {
        let start = Instant::now();
        let device = console.during("opening the device", || organza::open_device(options))?;
        console.note(&device.name());
        console.detail(device.choice());
        if device.backend() == "gpu" && device.is_cpu_like() {
            console.note("this GPU is software; `--backend cpu` is faster on this machine");
        }
        console.detail(&format!("opened the device in {:.2} s", start.elapsed().as_secs_f64()));
        Ok(Renderer::new(device))
    }

    /// The device options that the arguments describe.
    pub fn options(&self) -> Result<DeviceOptions> {
        let asks_for_gpu =
            self.adapter.is_some() || self.spirv.is_some() || self.variants.is_some();
        let backend = match self.backend {
            Backend::Cpu if asks_for_gpu => {
                return refuse(
                    "`--adapter`, `--spirv` and `--variants` are for GPUs, but `--backend` is cpu",
                );
            }
            Backend::Gpu if self.threads.is_some() => {
                return refuse("`--threads` is for the CPU, but `--backend` is gpu");
            }
            Backend::Gpu if self.instruction_set.is_some() => {
                return refuse("`--instruction-set` is for the CPU, but `--backend` is gpu");
            }
            Backend::Cpu => BackendChoice::Cpu,
            // A user who names a GPU does not want the CPU instead.
            Backend::Auto if !asks_for_gpu => BackendChoice::Auto,
            Backend::Auto | Backend::Gpu => BackendChoice::Gpu,
        };
        let spirv = self.spirv.as_ref().map(|path| match path == SpirvPath::Naga.as_str() {
            true => SpirvPath::Naga,
            false => SpirvPath::Passthrough,
        });
        let named = |set: &InstructionSet| Some(set.as_str()) == self.instruction_set.as_deref();
        let instruction_set = InstructionSet::ALL.into_iter().find(named);
        let variants = self.variants.as_ref().map(|variants| variants == "best");
        let options = DeviceOptions::default().backend(backend).spirv(spirv).variants(variants);
        let options = options.threads(self.threads.map(usize::from)).adapter(self.adapter.clone());
        Ok(options.instruction_set(instruction_set))
    }
}
