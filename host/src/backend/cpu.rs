//! The CPU backend: the kernels as ordinary functions, workgroups spread over threads.

use std::alloc::{self, Layout};
use std::ptr::NonNull;

use glam::UVec3;
use organza_kernels::invocation::Invocation;
use organza_kernels::kernel::{
    Access, BindingInfo, CpuBinding, CpuRun, InstructionSet, KernelInfo,
};
use organza_kernels::memory::Watch;
use organza_kernels::place::unlinear;
use rayon::prelude::*;

use super::buffer::{Memory, RawBuffer};
use super::watch::Races;
use super::{coroutine, supervise};
use crate::error::{Error, Result};
use crate::memory;

/// The CPU as a device.
#[derive(Debug)]
pub struct Cpu {
    pool: rayon::ThreadPool,
    check_races: bool,
    instruction_set: InstructionSet,
}

impl Cpu {
    pub fn new(
        threads: Option<usize>,
        check_races: bool,
        instruction_set: Option<InstructionSet>,
    ) -> Result<Self> {
        // a watch sees one invocation at a time
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
        Ok(Self { pool, check_races, instruction_set })
    }

    pub fn instruction_set(&self) -> InstructionSet {
        self.instruction_set
    }

    pub fn threads(&self) -> usize {
        self.pool.current_num_threads()
    }

    pub fn allocate(&self, label: &'static str, bytes: u64) -> Result<CpuMemory> {
        let what = format!("the buffer `{label}`");
        memory::check(bytes, &what)?;
        let available = memory::available();
        CpuMemory::zeroed(bytes).ok_or(Error::OutOfMemory { needed: bytes, available, what })
    }

    pub fn clear(&self, memory: &CpuMemory) {
        // SAFETY: in range, and no dispatch runs: each returns when it is done
        unsafe { memory.data.as_ptr().write_bytes(0, memory.layout.size()) };
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
        let races = if self.check_races { races(info, &bindings, workgroups) } else { Vec::new() };
        for (binding, race) in bindings.iter_mut().zip(&races) {
            binding.watch = race.as_ref().map(|race| race as &dyn Watch);
        }
        let [x, y, z] = workgroups.map(u64::from);
        let size = UVec3::from(workgroups);
        let place = |index: u64| unlinear(index, size);
        let run_of_lanes = match info.run {
            CpuRun::Lanes(runs) => CpuRun::Workgroup(runs.of(self.instruction_set)),
            run => run,
        };
        let run = |index: u64| match run_of_lanes {
            CpuRun::Lanes(_) => unreachable!("replaced above"),
            CpuRun::Workgroup(run) => {
                // SAFETY: the bindings are those of the typed dispatch, and kernels do not write to the same
                // element from two invocations without atomics
                unsafe { run(&bindings, place(index), size) };
                Ok(())
            }
            CpuRun::Invocation(run) => {
                coroutine::run_workgroup(info, run, &bindings, place(index), size)
            }
        };
        let supervised = |index: u64| {
            let local = UVec3::from(info.workgroup_size);
            let first = Invocation::new(UVec3::ZERO, place(index), size, local);
            supervise::supervise(info.name, first, || run(index))
        };
        let layer = |z: u32| {
            let first = x * y * u64::from(z);
            (first..first + x * y).try_for_each(supervised)
        };
        let run_all = || match info.layers {
            true => (0..workgroups[2]).into_par_iter().with_max_len(1).try_for_each(layer),
            false => (0..x * y * z).into_par_iter().try_for_each(supervised),
        };
        self.pool.install(run_all).map_err(failed)
    }
}

/// The memory of every binding, in order.
fn bind(
    info: &KernelInfo,
    uniform: &[u8],
    buffers: &[&RawBuffer],
) -> Result<Vec<CpuBinding<'static>>, String> {
    let mut buffers = buffers.iter();
    let mut bindings = Vec::with_capacity(info.bindings.len());
    for binding in info.bindings {
        let (data, bytes) = match binding.access {
            Access::Uniform => (uniform.as_ptr().cast_mut(), uniform.len()),
            Access::Read | Access::Write => {
                let buffer = buffers.next().expect("the typed dispatch binds every buffer");
                let Memory::Cpu(memory) = &buffer.memory else {
                    panic!("the buffer `{}` belongs to a GPU", buffer.label)
                };
                (memory.data.as_ptr(), buffer.bytes as usize)
            }
        };
        bindings.push(CpuBinding { data, bytes, watch: None });
    }
    for (at, (binding, info_of)) in bindings.iter().zip(info.bindings).enumerate() {
        for (other, info_of_other) in bindings.iter().zip(info.bindings).take(at) {
            let written = [info_of, info_of_other].iter().any(|info| info.access == Access::Write);
            // GPUs refuse it, too
            if binding.data == other.data && written {
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

/// A watch for every binding that is written.
fn races(
    info: &KernelInfo,
    bindings: &[CpuBinding<'_>],
    workgroups: [u32; 3],
) -> Vec<Option<Races>> {
    let invocations = UVec3::from(workgroups) * UVec3::from(info.workgroup_size);
    let layers = info.layers;
    let watch = |(info, binding): (&BindingInfo, &CpuBinding<'_>)| {
        let written = info.access == Access::Write;
        written.then(|| Races::new(info, binding.bytes, invocations, layers))
    };
    info.bindings.iter().zip(bindings).map(watch).collect()
}

/// Aligned memory that kernels write through pointers.
#[derive(Debug)]
pub struct CpuMemory {
    data: NonNull<u8>,
    layout: Layout,
}

// SAFETY: plain bytes; kernels that run at the same time do not write to the same element
unsafe impl Send for CpuMemory {}
// SAFETY: as above
unsafe impl Sync for CpuMemory {}

impl CpuMemory {
    fn zeroed(bytes: u64) -> Option<Self> {
        // a cache line: enough for every element type, and for SIMD
        let layout = Layout::from_size_align(usize::try_from(bytes).ok()?.max(64), 64).ok()?;
        // SAFETY: the size is not zero
        let data = NonNull::new(unsafe { alloc::alloc_zeroed(layout) })?;
        Some(Self { data, layout })
    }

    pub fn bytes(&self) -> &[u8] {
        // SAFETY: initialized at allocation, and dispatches have returned before the host reads
        unsafe { std::slice::from_raw_parts(self.data.as_ptr(), self.layout.size()) }
    }

    pub fn bytes_mut(&mut self) -> &mut [u8] {
        // SAFETY: as above
        unsafe { std::slice::from_raw_parts_mut(self.data.as_ptr(), self.layout.size()) }
    }
}

impl Drop for CpuMemory {
    fn drop(&mut self) {
        // SAFETY: allocated with this layout
        unsafe { alloc::dealloc(self.data.as_ptr(), self.layout) }
    }
}
