//! Opens the device that the options ask for.

use crate::device::{Device, DeviceKind};
use crate::error::{Error, Result};
use crate::modules::Modules;
use crate::options::{BackendChoice, DeviceOptions};
use crate::plan::Planner;
use crate::{cpu, gpu};

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
