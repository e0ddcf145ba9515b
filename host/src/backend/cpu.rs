//! The CPU backend: the kernels as ordinary functions, workgroups spread over threads.

use std::alloc::{self, Layout};
use std::panic::{self, AssertUnwindSafe};
use std::ptr::NonNull;

use glam::UVec3;
use organza_kernels::kernel::{Access, CpuBinding, CpuRun, KernelInfo};
use rayon::prelude::*;

use super::buffer::{Memory, RawBuffer};
use super::coroutine;
use crate::error::{Error, Result};
use crate::memory;

/// The CPU as a device.
#[derive(Debug)]
pub struct Cpu {
    pool: rayon::ThreadPool,
}

impl Cpu {
    pub fn new(threads: Option<usize>) -> Result<Self> {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads.unwrap_or(0))
            .thread_name(|index| format!("organza-{index}"))
            .build()
            .map_err(|error| Error::Argument {
                reason: format!("cannot start threads: {error}"),
            })?;
        Ok(Self { pool })
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

    pub fn dispatch(
        &self,
        info: &'static KernelInfo,
        uniform: &[u8],
        buffers: &[&RawBuffer],
        workgroups: [u32; 3],
    ) -> Result<()> {
        let bindings = bind(info, uniform, buffers);
        let [x, y, z] = workgroups.map(u64::from);
        let size = UVec3::from(workgroups);
        let place = |index: u64| {
            UVec3::new((index % x) as u32, (index / x % y) as u32, (index / x / y) as u32)
        };
        let run = || {
            (0..x * y * z).into_par_iter().for_each(|index| match info.run {
                // SAFETY: the bindings are those of the typed dispatch, and kernels do not write to the same
                // element from two invocations without atomics
                CpuRun::Workgroup(run) => unsafe { run(&bindings, place(index), size) },
                CpuRun::Invocation(run) => {
                    coroutine::run_workgroup(info, run, &bindings, place(index), size)
                }
            });
        };
        panic::catch_unwind(AssertUnwindSafe(|| self.pool.install(run))).map_err(|payload| {
            let reason = payload
                .downcast_ref::<String>()
                .cloned()
                .or_else(|| payload.downcast_ref::<&str>().map(ToString::to_string))
                .unwrap_or_else(|| "it panicked".into());
            Error::Kernel { kernel: info.name.into(), reason }
        })
    }
}

/// The memory of every binding, in order.
fn bind(info: &KernelInfo, uniform: &[u8], buffers: &[&RawBuffer]) -> Vec<CpuBinding> {
    let mut buffers = buffers.iter();
    let binding = |binding: &organza_kernels::BindingInfo| match binding.access {
        Access::Uniform => CpuBinding { data: uniform.as_ptr().cast_mut(), bytes: uniform.len() },
        Access::Read | Access::Write => {
            let buffer = buffers.next().expect("the typed dispatch binds every buffer");
            let Memory::Cpu(memory) = &buffer.memory else {
                panic!("the buffer `{}` belongs to a GPU", buffer.label)
            };
            CpuBinding { data: memory.data.as_ptr(), bytes: buffer.bytes as usize }
        }
    };
    info.bindings.iter().map(binding).collect()
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
