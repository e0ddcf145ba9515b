//! The CPU backend: kernels are ordinary functions, and workgroups are spread over threads.

use std::cell::Cell;
use std::ops::Range;

use muslin_kernel::KernelInfo;
use muslin_kernel::kernel::{EntryPoint, InstructionSet};
use rayon::prelude::*;

use crate::cpu_memory::{CpuMemory, MemoryPool};
use crate::{DeviceOptions, Error, Result, memory, panics};

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

/// Fills unwritten memory: as an `f32` it is NaN, and as an index it is out of range.
const NOT_A_NUMBER: u8 = 0xff;

/// The CPU backend.
#[derive(Debug)]
pub struct Cpu {
    pub(crate) pool: rayon::ThreadPool,
    pub(crate) check_races: bool,
    pub(crate) thorough: Option<u64>,
    pub(crate) flush_denormals: bool,
    pub(crate) subgroup_size: u32,
    /// Whether kernels run as their variants.
    variants: bool,
    instruction_set: InstructionSet,
    pool_memory: MemoryPool,
}

impl Cpu {
    pub fn new(options: &DeviceOptions) -> Result<Self> {
        let DeviceOptions { threads, check_races, instruction_set, .. } = *options;
        // a monitor handles one invocation at a time
        let best = if check_races { InstructionSet::Scalar } else { InstructionSet::best() };
        let instruction_set = instruction_set.unwrap_or(best);
        if !instruction_set.is_available() {
            let reason = format!("this CPU does not have {}", instruction_set.as_str());
            return Err(Error::Argument { reason });
        }
        let sizes = muslin_kernel::subgroup::SIZES;
        let of_seed = |seed| sizes[(seed % sizes.len() as u64) as usize];
        let subgroup_size =
            options.subgroup_size.unwrap_or_else(|| options.thorough.map_or(32, of_seed));
        if !sizes.contains(&subgroup_size) {
            let reason =
                format!("no subgroup has {subgroup_size} lanes: its size is one of {sizes:?}");
            return Err(Error::Argument { reason });
        }
        panics::install();
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads.unwrap_or(0))
            .thread_name(|index| format!("muslin-{index}"))
            .build()
            .map_err(|error| Error::Argument {
                reason: format!("cannot start threads: {error}"),
            })?;
        let variants = check_races && options.variants == Some(true);
        let pool_memory = MemoryPool::default();
        Ok(Self {
            pool,
            check_races,
            thorough: options.thorough,
            flush_denormals: options.flush_denormals,
            subgroup_size,
            variants,
            instruction_set,
            pool_memory,
        })
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

    /// Whether this thread runs its dispatches alone.
    pub fn is_single_thread() -> bool {
        SINGLE_THREAD.get() > 0
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
