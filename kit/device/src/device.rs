//! A device: buffers and dispatches, for every backend, and the time that they took.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use muslin_kernel::kernel::{Access, BindingInfo, Dispatch, EntryPoint, Items, KernelInfo};

use crate::buffer::{Count, Host, RawBuffer};
use crate::job::{MAX_WORKGROUPS, Workgroups, workgroups_for};
use crate::{Error, Result, cpu, gpu, plan};

/// A device that runs kernels.
///
/// ```
/// use muslin_device::{Device, DeviceOptions, Modules};
///
/// let device = Device::open(&DeviceOptions::cpu(None), Modules::none())?;
/// let buffer = device.upload("numbers", &[1.0_f32, 2.0])?;
/// assert_eq!(device.read(&buffer)?, [1.0, 2.0]);
/// # Ok::<(), muslin_device::Error>(())
/// ```
#[derive(Debug)]
pub struct Device {
    pub(crate) kind: DeviceKind,
    choice: String,
    /// Whether dispatches are timed on a GPU.
    times: AtomicBool,
    /// Whether the host must wait for a GPU's dispatches to time them.
    waits: AtomicBool,
    timings: Timings,
    /// Number of buffers until an allocation fails; 0 if none should fail.
    pub(crate) refused: AtomicU64,
    /// See [`DeviceOptions::extra_workgroup`].
    extra_workgroup: bool,
}

#[derive(Debug)]
pub(crate) enum DeviceKind {
    Cpu(cpu::Cpu),
    Gpu(Box<gpu::Gpu>),
    Planner(plan::Planner),
}

impl Device {
    pub(crate) fn new(kind: DeviceKind, choice: String) -> Self {
        let no = || AtomicBool::new(false);
        let timings = Timings::default();
        let refused = AtomicU64::new(0);
        Self { kind, choice, times: no(), waits: no(), timings, refused, extra_workgroup: false }
    }

    pub(crate) fn with_extra_workgroup(self, extra_workgroup: bool) -> Self {
        Self { extra_workgroup, ..self }
    }

    /// The requests to a [planner](Device::planner) since the last call; empty on another device.
    #[must_use]
    pub fn take_plan(&self) -> plan::DevicePlan {
        match &self.kind {
            DeviceKind::Planner(planner) => planner.take(),
            _ => plan::DevicePlan::default(),
        }
    }

    /// What the device is: `CPU, 2 threads`, or `GPU, ` and its name.
    #[must_use]
    pub fn name(&self) -> String {
        match &self.kind {
            DeviceKind::Cpu(cpu) if cpu.threads() == 1 => "CPU, 1 thread".to_owned(),
            DeviceKind::Cpu(cpu) => format!("CPU, {} threads", cpu.threads()),
            DeviceKind::Gpu(gpu) => format!("GPU, {}", gpu.name()),
            DeviceKind::Planner(_) => self.choice.clone(),
        }
    }

    /// Description of the device, and the reason for its choice.
    #[must_use]
    pub fn choice(&self) -> &str {
        &self.choice
    }

    /// Name of the backend: `cpu`, `gpu` or `planner`.
    #[must_use]
    pub fn backend(&self) -> &'static str {
        match self.kind {
            DeviceKind::Cpu(_) => "cpu",
            DeviceKind::Gpu(_) => "gpu",
            DeviceKind::Planner(_) => "planner",
        }
    }

    /// Whether this is the CPU or a software device. Small chunks that stay in its caches are then best.
    pub fn is_cpu_like(&self) -> bool {
        match &self.kind {
            DeviceKind::Cpu(_) => true,
            DeviceKind::Gpu(gpu) => gpu.is_software(),
            DeviceKind::Planner(_) => false,
        }
    }

    /// Everything that the bits of results depend on: the instruction set of a CPU, or a GPU with its driver and its
    /// path for kernels. Two devices with the same text compute the same bits.
    #[must_use]
    pub fn arithmetic(&self) -> String {
        match &self.kind {
            DeviceKind::Cpu(cpu) => {
                format!("cpu, {}, {}", std::env::consts::ARCH, cpu.instruction_set().as_str())
            }
            DeviceKind::Gpu(gpu) => format!("gpu, {}, {}", gpu.description(), gpu.driver()),
            DeviceKind::Planner(_) => self.choice.clone(),
        }
    }

    /// The shapes of products of [tiles](muslin_kernel::tile) that run as cooperative matrices: rows, columns, and products in a sum. A kernel with
    /// another shape runs with ordinary arithmetic, as all do where there are none.
    #[must_use]
    pub fn tiles(&self) -> &[[u32; 3]] {
        match &self.kind {
            DeviceKind::Gpu(gpu) => gpu.tiles(),
            _ => &[],
        }
    }

    /// The entry point that runs for a kernel. On the CPU, it stands for the function.
    #[must_use]
    pub fn entry_point(&self, kernel: &KernelInfo) -> EntryPoint {
        match &self.kind {
            DeviceKind::Cpu(cpu) => cpu.entry_point(kernel),
            DeviceKind::Gpu(gpu) => gpu.entry_point(kernel),
            DeviceKind::Planner(_) => kernel.plain(),
        }
    }

    /// Largest size of one buffer, in bytes.
    #[must_use]
    pub fn max_buffer_bytes(&self) -> u64 {
        match &self.kind {
            DeviceKind::Cpu(_) => u64::MAX,
            DeviceKind::Gpu(gpu) => gpu.max_buffer_bytes(),
            DeviceKind::Planner(planner) => planner.max_buffer_bytes(),
        }
    }

    /// A share of a GPU's own memory, in bytes: one of `shares` equal ones, but at least `min`. It is `min` on the CPU, on a software device,
    /// and where the driver does not tell its memory.
    #[must_use]
    pub fn memory_share(&self, shares: u64, min: u64) -> u64 {
        match &self.kind {
            DeviceKind::Gpu(gpu) => {
                gpu.memory_bytes().map_or(min, |bytes| (bytes / shares).max(min))
            }
            DeviceKind::Cpu(_) | DeviceKind::Planner(_) => min,
        }
    }

    /// Runs a kernel over `workgroups`; on a GPU it is queued. No size may exceed 65,535.
    ///
    /// # Errors
    /// [`Error::Kernel`] if the kernel fails;
    /// [`Error::StaleKernels`] if its SPIR-V is missing.
    pub fn dispatch<'a>(
        &self,
        kernel: &impl Dispatch<'a, Host>,
        workgroups: [u32; 3],
    ) -> Result<()> {
        self.dispatch_with_extra(kernel, workgroups, workgroups)
    }

    /// Like [`Device::dispatch`]. Only `needed` of the workgroups are what the caller has asked for.
    fn dispatch_with_extra<'a>(
        &self,
        kernel: &impl Dispatch<'a, Host>,
        workgroups: [u32; 3],
        needed: [u32; 3],
    ) -> Result<()> {
        if workgroups.contains(&0) {
            return Ok(());
        }
        let mut buffers = Vec::with_capacity(kernel.info().bindings.len());
        kernel.bind(&mut |buffer| buffers.push(buffer));
        let info = kernel.info();
        refuse_too_many(info, needed)?;
        refuse_partial(info, &buffers)?;
        refuse_mixed_up(info, &buffers)?;
        let counts = kernel.counts();
        let uniform = self.fill_in(kernel.uniform(), counts);
        let uniform = &*uniform;
        let times = self.times.load(Ordering::Relaxed);
        match &self.kind {
            DeviceKind::Cpu(cpu) => {
                let start = Instant::now();
                let size = Workgroups { all: workgroups, needed };
                let result = cpu.dispatch(info, uniform, &buffers, size);
                // the device's time
                let time = start.elapsed() / cpu::Cpu::concurrent_threads();
                self.timings.add(info.name, 1, time);
                result
            }
            DeviceKind::Gpu(gpu) if times && self.waits.load(Ordering::Relaxed) => {
                // earlier dispatches must not count as this kernel's time
                gpu.wait()?;
                let start = Instant::now();
                gpu.dispatch(info, uniform, counts, &buffers, workgroups)?;
                gpu.wait()?;
                self.timings.add(info.name, 1, start.elapsed());
                Ok(())
            }
            DeviceKind::Gpu(gpu) => {
                gpu.dispatch(info, uniform, counts, &buffers, workgroups)?;
                if times {
                    // its time is known later
                    self.timings.add(info.name, 1, Duration::ZERO);
                }
                Ok(())
            }
            DeviceKind::Planner(planner) => {
                planner.dispatch(info, uniform, counts, &buffers, workgroups);
                Ok(())
            }
        }
    }

    /// A kernel's parameters with the numbers that kernels have written on the CPU. A GPU fills in its own.
    fn fill_in<'u>(&self, uniform: &'u [u8], counts: &[(usize, &Count)]) -> Cow<'u, [u8]> {
        let is_known = counts.iter().all(|(_, count)| count.is_known());
        if is_known || !matches!(self.kind, DeviceKind::Cpu(_)) {
            return Cow::Borrowed(uniform);
        }
        let mut filled = uniform.to_vec();
        for (offset, count) in counts {
            filled[*offset..][..size_of::<u32>()].copy_from_slice(&count.on_cpu().to_ne_bytes());
        }
        Cow::Owned(filled)
    }

    /// Declares that earlier dispatches have written all [`Count`]s that are used from here on.
    pub fn publish_counts(&self) {
        match &self.kind {
            DeviceKind::Cpu(_) => {}
            DeviceKind::Gpu(gpu) => gpu.publish_counts(),
            DeviceKind::Planner(planner) => planner.publish_counts(),
        }
    }

    /// Whether numbers should stay on the device: on a GPU, reading them means waiting.
    pub fn has_indirect_counts(&self) -> bool {
        !matches!(self.kind, DeviceKind::Cpu(_))
    }

    /// Runs `work`, which dispatches many kernels. On a CPU it runs in the kernels' thread pool, which is cheaper.
    pub fn run_in_pool<R: Send>(&self, work: impl FnOnce() -> R + Send) -> R {
        match &self.kind {
            DeviceKind::Cpu(cpu) => cpu.run_in_pool(work),
            _ => work(),
        }
    }

    /// Runs `work` for every item. On a CPU each thread takes one item at a time, so the data of an item stays in its
    /// core's caches. Items must not write to the same memory.
    ///
    /// # Errors
    /// The first error of `work`.
    pub fn parallel_for<T: Send, E: Send>(
        &self,
        items: impl Iterator<Item = T>,
        work: impl Fn(T) -> Result<(), E> + Sync,
    ) -> Result<(), E> {
        match &self.kind {
            DeviceKind::Cpu(cpu) => cpu.parallel_for(items.collect(), work),
            _ => items.into_iter().try_for_each(work),
        }
    }

    /// Like [`Device::parallel_for`], but with scratch memory from `scratches`. `new` makes more of it.
    ///
    /// # Errors
    /// The first error of `new` or `work`.
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

    /// Number of threads of a CPU; 1 for a GPU.
    pub fn threads(&self) -> usize {
        match &self.kind {
            DeviceKind::Cpu(cpu) => cpu.threads(),
            _ => 1,
        }
    }

    /// Whether a dispatch gets one workgroup more than its items need. Workgroups of one invocation have no excess,
    /// so they do not.
    fn has_extra_workgroup(&self, info: &KernelInfo) -> bool {
        self.extra_workgroup && info.workgroup_size != [1; 3]
    }

    /// Runs a kernel over at least `items` items along x and y, and `workgroups_z` workgroups along z. An invocation
    /// handles one item, or as many as the kernel declares.
    ///
    /// # Errors
    /// The same errors as [`Device::dispatch`].
    pub fn run<'a>(
        &self,
        kernel: &impl Dispatch<'a, Host>,
        items: u32,
        workgroups_z: u32,
    ) -> Result<()> {
        let info = kernel.info();
        let invocations = match self.kind {
            DeviceKind::Cpu(_) => items,
            _ => items.div_ceil(info.each),
        };
        let [x, y] = workgroups_for(info, invocations);
        let needed = [x, y, workgroups_z];
        if !self.has_extra_workgroup(info) || items == 0 {
            return self.dispatch(kernel, needed);
        }
        let [x, y] = workgroups_for(info, invocations.saturating_add(info.workgroup_size[0]));
        // there may be no room for another one
        let y = if y > MAX_WORKGROUPS { needed[1] } else { y };
        self.dispatch_with_extra(kernel, [x, y, workgroups_z], needed)
    }

    /// Runs a kernel with at least `size` invocations along x and y, and `size[2]` workgroups along z.
    ///
    /// # Errors
    /// The same errors as [`Device::dispatch`].
    pub fn run_over<'a>(&self, kernel: &impl Dispatch<'a, Host>, size: [u32; 3]) -> Result<()> {
        let [x, y, _] = kernel.info().workgroup_size;
        let extra = u32::from(self.has_extra_workgroup(kernel.info()) && !size.contains(&0));
        let needed = [size[0].div_ceil(x), size[1].div_ceil(y), size[2]];
        let with_extra =
            |workgroups: u32| workgroups + if workgroups < MAX_WORKGROUPS { extra } else { 0 };
        let all = [with_extra(needed[0]), with_extra(needed[1]), needed[2]];
        self.dispatch_with_extra(kernel, all, needed)
    }

    /// Runs a kernel over what it declares, `#[kernel(.., over(..))]`, of its parameters and of the lengths of its buffers.
    ///
    /// # Errors
    /// The same errors as [`Device::dispatch`], or an error if the kernel does not declare it.
    pub fn run_all<'a>(&self, kernel: &impl Dispatch<'a, Host>) -> Result<()> {
        let info = kernel.info();
        let mut buffers = Vec::with_capacity(info.bindings.len());
        kernel.bind(&mut |buffer| buffers.push(buffer));
        let over = info.over.ok_or_else(|| {
            let reason = "it does not say what it runs over: `#[kernel(.., over(..))]`".into();
            Error::Kernel { kernel: info.name.into(), reason }
        })?;
        match over(kernel.uniform(), &elements(info, &buffers)) {
            Items::Line(items, workgroups_z) => self.run(kernel, items, workgroups_z),
            Items::Grid(size) => self.run_over(kernel, size),
        }
    }

    /// Turns timing of a GPU's dispatches on or off. The CPU's times are always measured. A GPU writes timestamps, so nothing waits. On a GPU without timestamps, the host waits
    /// for each dispatch: a time then includes the way to the device and back, and everything takes longer.
    pub fn time_dispatches(&self, times: bool) {
        if let DeviceKind::Gpu(gpu) = &self.kind {
            let has_timestamps = gpu.time_dispatches(times);
            self.waits.store(!has_timestamps, Ordering::Relaxed);
        }
        self.times.store(times, Ordering::Relaxed);
    }

    /// Returns the times of kernels since the last call, by name. Waits for timed dispatches of a GPU. The list is
    /// empty if timing was not [turned on](Device::time_dispatches), or if the device is lost.
    #[must_use]
    pub fn take_timings(&self) -> Vec<KernelTime> {
        if let DeviceKind::Gpu(gpu) = &self.kind {
            for (kernel, time) in gpu.take_times() {
                self.timings.add(kernel, 0, time);
            }
        }
        self.timings.take()
    }

    /// Gives a GPU everything that is recorded, so that it works while the host goes on.
    pub fn submit(&self) {
        if let DeviceKind::Gpu(gpu) = &self.kind {
            gpu.submit();
        }
    }

    /// What a GPU was asked for since it was opened; zeros on another device.
    #[must_use]
    pub fn traffic(&self) -> Traffic {
        match &self.kind {
            DeviceKind::Gpu(gpu) => gpu.traffic(),
            _ => Traffic::default(),
        }
    }

    /// Makes the device fail like a lost one, for tests.
    #[doc(hidden)]
    pub fn lose(&self) {
        if let DeviceKind::Gpu(gpu) = &self.kind {
            gpu.lose();
        }
    }
}

/// What a GPU was asked for: see [`Device::traffic`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Traffic {
    /// Times that the host has waited for all that it had submitted.
    pub waits: u64,
    /// Submissions to the queue.
    pub submissions: u64,
    /// Dispatches in them.
    pub dispatches: u64,
    /// Bytes that the host has written, with the kernels' parameters.
    pub bytes_up: u64,
}

impl std::ops::Sub for Traffic {
    type Output = Self;

    fn sub(self, before: Self) -> Self {
        Self {
            waits: self.waits - before.waits,
            submissions: self.submissions - before.submissions,
            dispatches: self.dispatches - before.dispatches,
            bytes_up: self.bytes_up - before.bytes_up,
        }
    }
}

/// Fails if there are more workgroups than a GPU starts.
fn refuse_too_many(info: &KernelInfo, workgroups: [u32; 3]) -> Result<()> {
    if workgroups.iter().all(|&along| along <= MAX_WORKGROUPS) {
        return Ok(());
    }
    let [x, y, z] = workgroups;
    let reason = format!(
        "{x} x {y} x {z} workgroups, and a GPU starts at most {MAX_WORKGROUPS} along each axis: use `Device::run` for items along x, larger \
         workgroups, or several dispatches"
    );
    Err(Error::Kernel { kernel: info.name.into(), reason })
}

/// Fails if a buffer that is written is bound twice, or if two buffers are bound in each other's place.
fn refuse_mixed_up(info: &KernelInfo, buffers: &[&RawBuffer]) -> Result<()> {
    for (at, (binding, buffer)) in bound(info, buffers).enumerate() {
        for (other, other_buffer) in bound(info, buffers).take(at) {
            let [first, second] = [other.name, binding.name];
            // invocations race; wgpu also refuses it if one binding reads, even if the bound parts do not overlap
            let is_written = [binding, other].iter().any(|of| of.access == Access::Write);
            let are_one = is_written && buffer.memory.is(&other_buffer.memory);
            // in passes that take turns, one's output is the other's input
            let are_alike = binding.access == other.access;
            let are_swapped = buffer.label == first && other_buffer.label == second;
            let reason = if are_one {
                format!("`{first}` and `{second}` are one buffer, and it is written")
            } else if are_alike && are_swapped {
                format!(
                    "`{first}` is the buffer `{second}`, and `{second}` is the buffer `{first}`: they are swapped"
                )
            } else {
                continue;
            };
            return Err(Error::Kernel { kernel: info.name.into(), reason });
        }
    }
    Ok(())
}

/// Fails if a buffer ends within a vector of [`ReadFours`](muslin_kernel::memory::ReadFours): a GPU would not reach its end.
fn refuse_partial(info: &KernelInfo, buffers: &[&RawBuffer]) -> Result<()> {
    for (binding, buffer) in bound(info, buffers) {
        if !buffer.bytes.is_multiple_of(u64::from(binding.device_bytes)) {
            let reason = format!(
                "`{}` has {} elements, and is read four at a time: make it longer",
                binding.name,
                buffer.bytes / u64::from(binding.element_bytes)
            );
            return Err(Error::Kernel { kernel: info.name.into(), reason });
        }
    }
    Ok(())
}

/// Number of elements of each buffer, in the order of the bindings.
fn elements(info: &KernelInfo, buffers: &[&RawBuffer]) -> Vec<u64> {
    let count = |(binding, buffer): (&BindingInfo, &RawBuffer)| {
        buffer.bytes / u64::from(binding.element_bytes)
    };
    bound(info, buffers).map(count).collect()
}

/// The buffers, each with its binding.
fn bound<'a>(
    info: &'a KernelInfo,
    buffers: &'a [&RawBuffer],
) -> impl Iterator<Item = (&'a BindingInfo, &'a RawBuffer)> {
    let bindings = info.bindings.iter().filter(|binding| binding.access != Access::Uniform);
    bindings.zip(buffers.iter().copied())
}

/// The total cost of a kernel's dispatches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KernelTime {
    /// Name of the kernel.
    pub kernel: &'static str,
    /// Number of dispatches.
    pub dispatches: u64,
    /// Time of all dispatches, in seconds.
    pub seconds: f64,
}

/// The costs of kernels, by name.
#[derive(Debug, Default)]
pub struct Timings(Mutex<BTreeMap<&'static str, KernelTime>>);

impl Timings {
    fn kernels(&self) -> MutexGuard<'_, BTreeMap<&'static str, KernelTime>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Adds dispatches, or what is known later of some that were counted before.
    pub fn add(&self, kernel: &'static str, dispatches: u64, time: Duration) {
        let none = KernelTime { kernel, dispatches: 0, seconds: 0.0 };
        let mut kernels = self.kernels();
        let total = kernels.entry(kernel).or_insert(none);
        total.dispatches += dispatches;
        total.seconds += time.as_secs_f64();
    }

    /// Returns all costs, and forgets them.
    pub fn take(&self) -> Vec<KernelTime> {
        std::mem::take(&mut *self.kernels()).into_values().collect()
    }
}
