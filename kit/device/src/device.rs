//! A device: buffers and dispatches, whatever the backend.

use std::borrow::Cow;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use organza_kernel::kernel::{Access, BindingInfo, Dispatch, EntryPoint, KernelInfo};

use organza_kernel::work::Work;

use crate::buffer::{Host, RawBuffer};
use crate::count::Count;
use crate::error::Result;
use crate::modules::Modules;
use crate::open::{self, DeviceOptions};
use crate::timings::{KernelTime, Timings};
use crate::{cpu, gpu, plan};

/// Where kernels run.
///
/// ```
/// use organza_device::{Device, DeviceOptions, Modules};
///
/// let device = Device::open(&DeviceOptions::cpu(None), Modules::none())?;
/// let buffer = device.upload("numbers", &[1.0_f32, 2.0])?;
/// assert_eq!(device.read(&buffer)?, [1.0, 2.0]);
/// # Ok::<(), organza_device::Error>(())
/// ```
#[derive(Debug)]
pub struct Device {
    pub(crate) kind: Kind,
    choice: String,
    /// Whether dispatches are timed on a GPU, and their work is counted.
    times: AtomicBool,
    /// Whether a GPU's dispatches must be waited for to be timed.
    waits: AtomicBool,
    timings: Timings,
    /// Buffers until memory is refused; 0 where it is not.
    pub(crate) refused: AtomicU64,
    /// See [`DeviceOptions::extra_workgroup`].
    extra_workgroup: bool,
}

#[derive(Debug)]
pub(crate) enum Kind {
    Cpu(cpu::Cpu),
    Gpu(Box<gpu::Gpu>),
    Planner(plan::Planner),
}

impl Device {
    pub(crate) fn new(kind: Kind, choice: String) -> Self {
        let no = || AtomicBool::new(false);
        let (timings, refused) = (Timings::default(), AtomicU64::new(0));
        Self { kind, choice, times: no(), waits: no(), timings, refused, extra_workgroup: false }
    }

    pub(crate) fn with_extra_workgroup(self, extra_workgroup: bool) -> Self {
        Self { extra_workgroup, ..self }
    }

    /// Opens the device that `options` ask for; `modules` are the compiled kernels that a GPU runs.
    ///
    /// # Errors
    /// [`Error::NoGpu`](crate::Error::NoGpu) if a GPU was demanded and none can be used.
    pub fn open(options: &DeviceOptions, modules: &'static Modules) -> Result<Self> {
        open::open(options, modules)
    }

    /// Which device it is, and why it was taken.
    #[must_use]
    pub fn choice(&self) -> &str {
        &self.choice
    }

    /// `cpu`, `gpu` or `planner`.
    #[must_use]
    pub fn backend(&self) -> &'static str {
        match self.kind {
            Kind::Cpu(_) => "cpu",
            Kind::Gpu(_) => "gpu",
            Kind::Planner(_) => "planner",
        }
    }

    /// Whether this is a software device, or the CPU: small chunks that stay in its caches suit it.
    pub fn is_cpu_like(&self) -> bool {
        match &self.kind {
            Kind::Cpu(_) => true,
            Kind::Gpu(gpu) => gpu.is_software(),
            Kind::Planner(_) => false,
        }
    }

    /// What results depend on, to the bit: the instruction set of a CPU, or a GPU with its driver and how it gets its
    /// kernels. Two devices of which this is the same compute the same.
    #[must_use]
    pub fn arithmetic(&self) -> String {
        match &self.kind {
            Kind::Cpu(cpu) => {
                format!("cpu, {}, {}", std::env::consts::ARCH, cpu.instruction_set().as_str())
            }
            Kind::Gpu(gpu) => format!("gpu, {}, {}", gpu.description(), gpu.driver()),
            Kind::Planner(_) => self.choice.clone(),
        }
    }

    /// Which of a kernel's entry points it runs: on the CPU, they stand for the function.
    #[must_use]
    pub fn entry_point(&self, kernel: &KernelInfo) -> EntryPoint {
        match &self.kind {
            Kind::Cpu(cpu) => cpu.entry_point(kernel),
            Kind::Gpu(gpu) => gpu.entry_point(kernel),
            Kind::Planner(_) => kernel.plain(),
        }
    }

    /// Largest size of one buffer, in bytes.
    #[must_use]
    pub fn max_buffer_bytes(&self) -> u64 {
        match &self.kind {
            Kind::Cpu(_) => u64::MAX,
            Kind::Gpu(gpu) => gpu.max_buffer_bytes(),
            Kind::Planner(planner) => planner.max_buffer_bytes(),
        }
    }

    /// Runs a kernel over `workgroups`; on the GPU it is queued.  None of the sizes may pass 65,535.
    ///
    /// # Errors
    /// [`Error::Kernel`](crate::Error::Kernel) if the kernel fails,
    /// [`Error::StaleKernels`](crate::Error::StaleKernels) if its SPIR-V is not there.
    pub fn dispatch<'a>(
        &self,
        kernel: &impl Dispatch<'a, Host>,
        workgroups: [u32; 3],
    ) -> Result<()> {
        if workgroups.contains(&0) {
            return Ok(());
        }
        let mut buffers = Vec::with_capacity(kernel.info().bindings.len());
        kernel.bind(&mut |buffer| buffers.push(buffer));
        let (info, counts) = (kernel.info(), kernel.counts());
        let uniform = self.fill_in(kernel.uniform(), counts);
        let uniform = &*uniform;
        let times = self.times.load(Ordering::Relaxed);
        let work = || match times {
            true => info.work(uniform, &elements(info, &buffers), workgroups[2]),
            false => Work::default(),
        };
        match &self.kind {
            Kind::Cpu(cpu) => {
                let start = Instant::now();
                let result = cpu.dispatch(info, uniform, &buffers, workgroups);
                // of the device's time
                self.timings.add(
                    info.name,
                    start.elapsed() / cpu::Cpu::concurrent_threads(),
                    work(),
                );
                result
            }
            Kind::Gpu(gpu) if times && self.waits.load(Ordering::Relaxed) => {
                // what was queued before is not this kernel's time
                gpu.wait()?;
                let start = Instant::now();
                gpu.dispatch(info, uniform, counts, &buffers, workgroups)?;
                gpu.wait()?;
                self.timings.add(info.name, start.elapsed(), work());
                Ok(())
            }
            Kind::Gpu(gpu) => {
                gpu.dispatch(info, uniform, counts, &buffers, workgroups)?;
                if times {
                    // what it takes is known later
                    self.timings.add(info.name, Duration::ZERO, work());
                }
                Ok(())
            }
            Kind::Planner(planner) => {
                planner.dispatch(info, uniform, counts, &buffers, workgroups);
                Ok(())
            }
        }
    }

    /// A kernel's parameters with the numbers that kernels have written on the CPU; a GPU fills in its own.
    fn fill_in<'u>(&self, uniform: &'u [u8], counts: &[(usize, &Count)]) -> Cow<'u, [u8]> {
        let is_known = counts.iter().all(|(_, count)| count.is_known());
        if is_known || !matches!(self.kind, Kind::Cpu(_)) {
            return Cow::Borrowed(uniform);
        }
        let mut filled = uniform.to_vec();
        for (offset, count) in counts {
            filled[*offset..][..size_of::<u32>()].copy_from_slice(&count.on_cpu().to_ne_bytes());
        }
        Cow::Owned(filled)
    }

    /// Says that what was dispatched before has written all [`Count`]s that are used from here on.
    pub fn publish_counts(&self) {
        match &self.kind {
            Kind::Cpu(_) => {}
            Kind::Gpu(gpu) => gpu.publish_counts(),
            Kind::Planner(planner) => planner.publish_counts(),
        }
    }

    /// Whether numbers are better left on the device than read: on a GPU reading waits.  Where dispatches are timed, their
    /// work is counted by those numbers.
    pub fn leaves_counts_on_device(&self) -> bool {
        !matches!(self.kind, Kind::Cpu(_)) && !self.times.load(Ordering::Relaxed)
    }

    /// Runs `work`, which dispatches many kernels. On a CPU it runs in the thread pool of the kernels, which is cheaper.
    pub fn run_in_pool<R: Send>(&self, work: impl FnOnce() -> R + Send) -> R {
        match &self.kind {
            Kind::Cpu(cpu) => cpu.run_in_pool(work),
            _ => work(),
        }
    }

    /// Does `work` for every item. On a CPU it takes one item per thread at a time, so that the data of an item stays in its
    /// core's caches. Items must not write to the same memory.
    ///
    /// # Errors
    /// What `work` runs into first.
    pub fn parallel_for<T: Send, E: Send>(
        &self,
        items: impl Iterator<Item = T>,
        work: impl Fn(T) -> Result<(), E> + Sync,
    ) -> Result<(), E> {
        match &self.kind {
            Kind::Cpu(cpu) => cpu.parallel_for(items.collect(), work),
            _ => items.into_iter().try_for_each(work),
        }
    }

    /// Like [`Device::parallel_for`], with scratch memory from `scratches`; `new` makes more of it.
    ///
    /// # Errors
    /// What `new` or `work` runs into first.
    pub fn parallel_for_with<T: Send, S: Send, E: Send>(
        &self,
        items: impl Iterator<Item = T>,
        scratches: &Mutex<Vec<S>>,
        new: impl Fn() -> Result<S, E> + Sync,
        work: impl Fn(&S, T) -> Result<(), E> + Sync,
    ) -> Result<(), E> {
        let unused = || scratches.lock().unwrap_or_else(PoisonError::into_inner);
        self.parallel_for(items, |item| {
            let found = unused().pop();
            let scratch = found.map_or_else(&new, Ok)?;
            let result = work(&scratch, item);
            unused().push(scratch);
            result
        })
    }

    /// Threads of a CPU; 1 for a GPU.
    pub fn threads(&self) -> usize {
        match &self.kind {
            Kind::Cpu(cpu) => cpu.threads(),
            _ => 1,
        }
    }

    /// Whether a dispatch gets a workgroup more than its items need. Workgroups of one invocation always fit.
    fn has_extra_workgroup(&self, info: &KernelInfo) -> bool {
        self.extra_workgroup && info.workgroup_size != [1; 3]
    }

    /// Workgroups along x and y for this many items.
    fn workgroups_for(&self, info: &KernelInfo, items: u32) -> [u32; 2] {
        let invocations = match self.kind {
            Kind::Cpu(_) => items,
            _ => items.div_ceil(info.each),
        };
        match self.has_extra_workgroup(info) && items > 0 {
            true => workgroups_for(info, invocations.saturating_add(info.workgroup_size[0])),
            false => workgroups_for(info, invocations),
        }
    }

    /// Runs a kernel over at least `items` items along x and y, one for each invocation or as many as it takes, and `workgroups_z`
    /// workgroups along z.
    ///
    /// # Errors
    /// The same errors as [`Device::dispatch`].
    pub fn run<'a>(
        &self,
        kernel: &impl Dispatch<'a, Host>,
        items: u32,
        workgroups_z: u32,
    ) -> Result<()> {
        let workgroups = self.workgroups_for(kernel.info(), items);
        self.dispatch(kernel, [workgroups[0], workgroups[1], workgroups_z])
    }

    /// Runs a kernel with at least `size` invocations along x and y, and `size[2]` workgroups along z.
    ///
    /// # Errors
    /// The same errors as [`Device::dispatch`].
    pub fn run_over<'a>(&self, kernel: &impl Dispatch<'a, Host>, size: [u32; 3]) -> Result<()> {
        let [x, y, _] = kernel.info().workgroup_size;
        let extra = u32::from(self.has_extra_workgroup(kernel.info()) && !size.contains(&0));
        self.dispatch(kernel, [size[0].div_ceil(x) + extra, size[1].div_ceil(y) + extra, size[2]])
    }

    /// From now on, whether a GPU's dispatches are timed and every device's [`Work`] is counted; the CPU's times are always
    /// there.  A GPU writes timestamps, so that nothing waits; where it has none, each dispatch is waited for: its time
    /// has the way to the device and back, and the whole takes longer.
    pub fn time_dispatches(&self, times: bool) {
        if let Kind::Gpu(gpu) = &self.kind {
            let has_timestamps = gpu.time_dispatches(times);
            self.waits.store(!has_timestamps, Ordering::Relaxed);
        }
        self.times.store(times, Ordering::Relaxed);
    }

    /// What the kernels have taken since the last call, by name.  Waits for what was timed on a GPU; there is nothing unless
    /// [asked for](Device::time_dispatches), nor of a device that was lost.
    #[must_use]
    pub fn take_timings(&self) -> Vec<KernelTime> {
        if let Kind::Gpu(gpu) = &self.kind {
            for (kernel, time) in gpu.take_times() {
                self.timings.add_time(kernel, time);
            }
        }
        self.timings.take()
    }

    /// How often the host has waited for what it read from a GPU; 0 on a CPU.
    #[doc(hidden)]
    #[must_use]
    pub fn waits(&self) -> u64 {
        match &self.kind {
            Kind::Gpu(gpu) => gpu.waits(),
            _ => 0,
        }
    }

    /// Makes the device fail as a lost one does: for tests of what happens then.
    #[doc(hidden)]
    pub fn lose(&self) {
        if let Kind::Gpu(gpu) = &self.kind {
            gpu.lose();
        }
    }
}

/// Elements of each buffer, in the order of the bindings.
fn elements(info: &KernelInfo, buffers: &[&RawBuffer]) -> Vec<u64> {
    let bindings = info.bindings.iter().filter(|binding| binding.access != Access::Uniform);
    let count = |(binding, buffer): (&BindingInfo, &&RawBuffer)| {
        buffer.bytes / u64::from(binding.element_bytes)
    };
    bindings.zip(buffers).map(count).collect()
}

/// Workgroups along x and y that hold `items` invocations; an axis ends at 65,535.
fn workgroups_for(info: &KernelInfo, items: u32) -> [u32; 2] {
    const MAX: u32 = 65_535;
    let groups = items.div_ceil(info.workgroup_size[0]);
    if groups <= MAX { [groups, u32::from(groups > 0)] } else { [MAX, groups.div_ceil(MAX)] }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zeros_are_zeros_where_other_values_lay() {
        let device = Device::open(&DeviceOptions::cpu(Some(1)), Modules::none()).unwrap();
        drop(device.upload("values", &[7_u32; 250]).unwrap());
        let again = device.zeros::<u32>("zeros", 250).unwrap();
        assert_eq!(device.read(&again).unwrap(), [0; 250]);
    }

    #[test]
    fn workgroups_hold_all_items() {
        let info = organza_kernel::kernels().find(|k| k.name == "count_fill").expect("a kernel");
        for items in [0, 1, 63, 64, 65, 65_535 * 64, 65_535 * 64 + 1, 1 << 31, u32::MAX] {
            let [x, y] = workgroups_for(info, items);
            assert!(x <= 65_535 && y <= 65_535);
            assert!(u64::from(x) * u64::from(y) * 64 >= u64::from(items), "{items}: {x} x {y}");
        }
    }
}
