//! The CPU backend: kernels are ordinary functions, and workgroups are spread over threads.

use std::cell::Cell;
use std::ops::Range;

use glam::{UVec3, Vec3Swizzles};
use organza_kernel::invocation::Invocation;
use organza_kernel::kernel::{
    Access, BindingInfo, CpuBinding, CpuRun, EntryPoint, InstructionSet, KernelInfo,
};
use organza_kernel::memory::AccessMonitor;
use organza_kernel::running::{RunningInvocation, begin, unlinear};
use organza_kernel::workgroup;
use rayon::prelude::*;

use crate::buffer::{Memory, RawBuffer};
use crate::cpu_memory::{CpuMemory, MemoryPool};
use crate::error::{Error, Result};
use crate::open::DeviceOptions;
use crate::races::{Races, Reads};
use crate::written::Written;
use crate::{memory, supervise};

thread_local! {
    /// Number of threads that work independently, including this one; 0 if a dispatch uses all threads.
    static SINGLE_THREAD: Cell<u32> = const { Cell::new(0) };
}

/// While this value lives, the thread runs its dispatches alone.
struct SingleThread;

impl SingleThread {
    fn among(threads: u32) -> Self {
        SINGLE_THREAD.set(threads);
        Self
    }
}

impl Drop for SingleThread {
    fn drop(&mut self) {
        SINGLE_THREAD.set(0);
    }
}

/// Workgroups that a thread runs in sequence, so that the cost of handing them over counts less.
const AT_ONCE: u64 = 8;

/// Fills unwritten memory: as an `f32` it is NaN, and as an index it is out of range.
const NOT_A_NUMBER: u8 = 0xff;

/// The CPU backend.
#[derive(Debug)]
pub struct Cpu {
    pool: rayon::ThreadPool,
    check_races: bool,
    check_nan: bool,
    /// Whether kernels run as their variants.
    variants: bool,
    instruction_set: InstructionSet,
    pool_memory: MemoryPool,
}

impl Cpu {
    pub fn new(options: &DeviceOptions) -> Result<Self> {
        let DeviceOptions { threads, check_races, check_nan, instruction_set, .. } = *options;
        // a monitor handles one invocation at a time
        let best = if check_races { InstructionSet::Scalar } else { InstructionSet::best() };
        let instruction_set = instruction_set.unwrap_or(best);
        if !instruction_set.is_available() {
            let reason = format!("this CPU does not have {}", instruction_set.as_str());
            return Err(Error::Argument { reason });
        }
        supervise::install();
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads.unwrap_or(0))
            .thread_name(|index| format!("organza-{index}"))
            .build()
            .map_err(|error| Error::Argument {
                reason: format!("cannot start threads: {error}"),
            })?;
        let variants = check_races && options.variants == Some(true);
        let pool_memory = MemoryPool::default();
        Ok(Self { pool, check_races, check_nan, variants, instruction_set, pool_memory })
    }

    /// The entry point that runs. It is the variant only if a test asks for it.
    pub fn entry_point(&self, kernel: &KernelInfo) -> EntryPoint {
        let variant = kernel.variant.filter(|_| self.variants && kernel.run_variant.is_some());
        variant.unwrap_or(kernel.plain())
    }

    /// Marks bytes as unwritten, if that is checked.
    pub fn forget(&self, memory: &CpuMemory, begin: u64, bytes: u64) {
        if self.check_races {
            memory.forget(begin as usize..(begin + bytes) as usize);
        }
    }

    /// Marks bytes as written by the host.
    pub fn wrote(memory: &CpuMemory, begin: u64, bytes: u64) {
        if let Some(written) = memory.written() {
            written.set(begin as usize..(begin + bytes) as usize, true);
        }
    }

    pub fn instruction_set(&self) -> InstructionSet {
        self.instruction_set
    }

    pub fn threads(&self) -> usize {
        self.pool.current_num_threads()
    }

    /// Allocates memory for a buffer. Without `zeros` it can contain anything. Debug builds fill it with bytes that
    /// show up.
    pub fn allocate(&self, label: &'static str, bytes: u64, zeros: bool) -> Result<CpuMemory> {
        let (mut memory, is_new) = match self.pool_memory.take(bytes) {
            Some(memory) => (memory, false),
            None => (self.allocate_new(label, bytes)?, true),
        };
        let unwritten = if cfg!(debug_assertions) { Some(NOT_A_NUMBER) } else { None };
        let fill = if zeros { (!is_new).then_some(0) } else { unwritten };
        if let Some(fill) = fill {
            memory.bytes_mut()[..bytes as usize].fill(fill);
        }
        Ok(memory)
    }

    /// Allocates zeros.
    fn allocate_new(&self, label: &'static str, bytes: u64) -> Result<CpuMemory> {
        let what = format!("the buffer `{label}`");
        // unused memory counts, too
        memory::check(bytes, &what).or_else(|_| {
            self.pool_memory.clear();
            memory::check(bytes, &what)
        })?;
        let memory = self.pool_memory.allocate(bytes).or_else(|| {
            self.pool_memory.clear();
            self.pool_memory.allocate(bytes)
        });
        memory.ok_or_else(|| Error::OutOfMemory {
            needed: bytes,
            available: memory::available(),
            what,
        })
    }

    pub fn clear(&self, memory: &CpuMemory, begin: u64, bytes: u64) {
        assert!(begin + bytes <= memory.bytes().len() as u64);
        // SAFETY: in range, and no dispatch runs: each returns when it is done
        unsafe { memory.data().add(begin as usize).write_bytes(0, bytes as usize) };
        Self::wrote(memory, begin, bytes);
    }

    pub fn write(&self, to: &CpuMemory, begin: u64, bytes: &[u8]) {
        let begin = begin as usize;
        assert!(begin + bytes.len() <= to.bytes().len());
        // SAFETY: in range, and no dispatch runs: each returns when it is done
        unsafe { to.data().add(begin).copy_from(bytes.as_ptr(), bytes.len()) };
        Self::wrote(to, begin as u64, bytes.len() as u64);
    }

    pub fn copy(&self, from: &CpuMemory, range: Range<u64>, to: &CpuMemory, begin: u64) {
        let bytes = (range.end - range.start) as usize;
        assert!(range.end <= from.bytes().len() as u64);
        assert!(begin as usize + bytes <= to.bytes().len());
        // SAFETY: in range, and no dispatch runs: each returns when it is done
        unsafe {
            to.data().add(begin as usize).copy_from(from.data().add(range.start as usize), bytes)
        };
        if let Some(written) = to.written() {
            let range = range.start as usize..range.end as usize;
            written.copy(from.written(), range, begin as usize);
        }
    }

    pub fn dispatch(
        &self,
        info: &'static KernelInfo,
        uniform: &[u8],
        buffers: &[&RawBuffer],
        workgroups: [u32; 3],
    ) -> Result<()> {
        let failed = |reason| Error::Kernel { kernel: info.name.into(), reason };
        let mut bindings = bind(info, uniform, buffers).map_err(failed)?;
        let monitors = match self.check_races {
            true => monitors(info, &bindings, buffers, workgroups),
            false => Vec::new(),
        };
        for (binding, monitor) in bindings.iter_mut().zip(&monitors) {
            binding.monitor = monitor.as_ref().map(Monitor::as_dyn);
        }
        let point = self.entry_point(info);
        let [x, y, z] = workgroups.map(u64::from);
        let size = UVec3::from(workgroups);
        let local = UVec3::from(info.workgroup_size);
        let place = |index: u64| match info.z_innermost {
            // z is the fastest axis
            true => unlinear(index, size.zxy()).yzx(),
            false => unlinear(index, size),
        };
        let run_of_lanes = match info.run {
            _ if point.name != info.name => match info.run_variant {
                Some(run) => CpuRun::Invocation(run),
                None => unreachable!("`entry_point` has looked"),
            },
            CpuRun::Lanes(runs) => CpuRun::Workgroup(runs.of(self.instruction_set)),
            run => run,
        };
        let run = |index: u64| match run_of_lanes {
            CpuRun::Lanes(_) => unreachable!("replaced above"),
            CpuRun::Workgroup(run) => {
                // SAFETY: the bindings are those of the typed dispatch, and kernels do not write to the same
                // element from two invocations without atomics. `new` has checked the instruction set.
                unsafe { run(&bindings, place(index), size) };
                Ok(())
            }
            CpuRun::Invocation(run) => {
                let shared = point.shared;
                // SAFETY: as above, and the workgroup memory is what this kernel declares
                unsafe { workgroup::run_bound(shared, local, run, &bindings, place(index), size) }
            }
        };
        let run_some = |mut indices: Range<u64>| {
            supervise::supervise(|| {
                indices.try_for_each(|index| {
                    let first = Invocation::new(UVec3::ZERO, place(index), size, local);
                    begin(Some(RunningInvocation { kernel: info.name, id: first }));
                    run(index)
                })
            })
        };
        // one thread runs all workgroups with the same z
        let (all, at_once) = match info.z_serial {
            true => (z, x * y),
            false => ((x * y * z).div_ceil(AT_ONCE), AT_ONCE),
        };
        let some = |index: usize| {
            let first = index as u64 * at_once;
            run_some(first..(first + at_once).min(x * y * z))
        };
        if SINGLE_THREAD.get() > 0 {
            let result = (0..all as usize).try_for_each(some);
            return result
                .and_then(|()| self.refuse_nan(info, &bindings, &monitors))
                .map_err(failed);
        }
        let run_all = || match info.z_serial {
            true => (0..all as usize).into_par_iter().with_max_len(1).try_for_each(some),
            false => (0..all as usize).into_par_iter().try_for_each(some),
        };
        let result = self.pool.install(run_all);
        result.and_then(|()| self.refuse_nan(info, &bindings, &monitors)).map_err(failed)
    }

    /// Fails if a kernel has written NaN, on a device that checks this.
    fn refuse_nan(
        &self,
        info: &KernelInfo,
        bindings: &[CpuBinding<'_>],
        monitors: &[Option<Monitor<'_>>],
    ) -> Result<(), String> {
        let bindings = info.bindings.iter().zip(bindings).zip(monitors);
        for ((info, binding), monitor) in bindings.filter(|_| self.check_nan) {
            let Some(Monitor::Written(races)) = monitor else { continue };
            // SAFETY: the buffer's bytes; the dispatch is over, so nothing writes them
            let data = unsafe { std::slice::from_raw_parts(binding.data, binding.bytes) };
            if let Some(fault) = races.nan(info, data) {
                return Err(fault);
            }
        }
        Ok(())
    }

    /// Runs `work` for every item, on all threads at once. An item's dispatches run on its thread.
    pub fn parallel_for<T: Send, E: Send>(
        &self,
        items: Vec<T>,
        work: impl Fn(T) -> Result<(), E> + Sync,
    ) -> Result<(), E> {
        let at_once = self.threads().min(items.len()) as u32;
        let alone = |item| {
            let _alone = SingleThread::among(at_once);
            work(item)
        };
        self.pool.install(|| items.into_par_iter().with_max_len(1).try_for_each(alone))
    }

    /// Number of threads that share the device with this one: more than one in [`Cpu::parallel_for`].
    pub fn concurrent_threads() -> u32 {
        SINGLE_THREAD.get().max(1)
    }

    /// Runs `work` on one of the device's threads, so that its dispatches need not wake one.
    pub fn run_in_pool<R: Send>(&self, work: impl FnOnce() -> R + Send) -> R {
        self.pool.install(work)
    }
}

/// The memory of every binding, in order.
fn bind(
    info: &KernelInfo,
    uniform: &[u8],
    buffers: &[&RawBuffer],
) -> Result<Vec<CpuBinding<'static>>, String> {
    refuse_swapped(info, buffers)?;
    let mut buffers = buffers.iter();
    let mut bindings = Vec::with_capacity(info.bindings.len());
    let mut memories = Vec::with_capacity(info.bindings.len());
    for binding in info.bindings {
        let (whole, data, bytes) = match binding.access {
            Access::Uniform => (uniform.as_ptr(), uniform.as_ptr().cast_mut(), uniform.len()),
            Access::Read | Access::Write => {
                let buffer = buffers.next().expect("the typed dispatch binds every buffer");
                let Memory::Cpu(memory) = &buffer.memory else {
                    panic!("the buffer `{}` belongs to a GPU", buffer.label)
                };
                let whole = memory.data();
                let begin = whole.wrapping_add(buffer.begin as usize);
                (whole.cast_const(), begin, buffer.bytes as usize)
            }
        };
        bindings.push(CpuBinding { data, bytes, monitor: None });
        memories.push(whole);
    }
    for (at, (memory, info_of)) in memories.iter().zip(info.bindings).enumerate() {
        for (other, info_of_other) in memories.iter().zip(info.bindings).take(at) {
            let written = [info_of, info_of_other].iter().any(|info| info.access == Access::Write);
            // GPUs also refuse it, even if the bound parts do not overlap
            if memory == other && written {
                let names = (info_of_other.name, info_of.name);
                return Err(format!(
                    "`{}` and `{}` are one buffer, and it is written",
                    names.0, names.1
                ));
            }
        }
    }
    Ok(bindings)
}

/// Fails if two buffers are bound in each other's place: each has the other binding's name as its label.
fn refuse_swapped(info: &KernelInfo, buffers: &[&RawBuffer]) -> Result<(), String> {
    let bindings = || info.bindings.iter().filter(|info| info.access != Access::Uniform);
    for (at, (info, buffer)) in bindings().zip(buffers).enumerate() {
        for (other, other_buffer) in bindings().zip(buffers).take(at) {
            let are_swapped = buffer.label == other.name && other_buffer.label == info.name;
            // in passes that take turns, one's output is the other's input
            if are_swapped && info.access == other.access {
                let first = other.name;
                let second = info.name;
                return Err(format!(
                    "`{first}` is the buffer `{second}`, and `{second}` is the buffer `{first}`: they are swapped"
                ));
            }
        }
    }
    Ok(())
}

/// Watches the accesses to a binding.
enum Monitor<'a> {
    Written(Races<'a>),
    Read(Reads<'a>),
}

impl Monitor<'_> {
    fn as_dyn(&self) -> &dyn AccessMonitor {
        match self {
            Self::Written(races) => races,
            Self::Read(reads) => reads,
        }
    }
}

/// A monitor for every binding that is written, or that may have unwritten elements.
fn monitors<'a>(
    info: &KernelInfo,
    bindings: &[CpuBinding<'_>],
    buffers: &[&'a RawBuffer],
    workgroups: [u32; 3],
) -> Vec<Option<Monitor<'a>>> {
    let invocations = UVec3::from(workgroups) * UVec3::from(info.workgroup_size);
    let layers = info.z_serial;
    let mut buffers = buffers.iter();
    let monitor = |(info, binding): (&BindingInfo, &CpuBinding<'_>)| {
        if info.access == Access::Uniform {
            return None;
        }
        let buffer = buffers.next()?;
        let (written, begin): (Option<&Written>, _) = match &buffer.memory {
            Memory::Cpu(memory) => (memory.written(), buffer.begin as usize),
            _ => (None, 0),
        };
        let monitor = match info.access {
            Access::Write => {
                let bytes = binding.bytes;
                Monitor::Written(Races::new(info, bytes, invocations, layers, written, begin))
            }
            _ => Monitor::Read(Reads::new(info, written?, begin)),
        };
        Some(monitor)
    };
    info.bindings.iter().zip(bindings).map(monitor).collect()
}
