//! Dispatches of the CPU backend.

use glam::{UVec3, Vec3Swizzles};
use muslin_kernel::invocation::Invocation;
use muslin_kernel::kernel::{CpuBinding, CpuRun, KernelInfo, SharedInfo};
use muslin_kernel::running::{RunningInvocation, begin, enter, unlinear};
use muslin_kernel::{regions, workgroup};
use rayon::prelude::*;

use crate::buffer::RawBuffer;
use crate::cpu::Cpu;
use crate::job::{KernelJob, RunMode, Workgroups, bind};
use crate::races::{Monitor, monitors};
use crate::thorough::Flushing;
use crate::{Error, Result, panics, thorough};

/// Workgroups that a thread runs in sequence, so that the cost of handing them over counts less.
const AT_ONCE: u64 = 8;

/// One run of a dispatch.
struct Launch<'a> {
    info: &'static KernelInfo,
    run: CpuRun,
    shared: &'static [SharedInfo],
    bindings: &'a [CpuBinding<'a>],
    /// Invocations of a workgroup.
    size: UVec3,
    workgroups: UVec3,
    /// The workgroups that are not additional.
    needed: UVec3,
    is_checked: bool,
    /// Number of lanes of a subgroup, in a kernel that declares them.
    subgroup_size: Option<u32>,
    mode: RunMode,
}

impl Launch<'_> {
    fn place(&self, index: u64) -> UVec3 {
        match self.info.z_innermost {
            // z is the fastest axis
            true => unlinear(index, self.workgroups.zxy()).yzx(),
            false => unlinear(index, self.workgroups),
        }
    }

    fn run(&self, index: u64) -> Result<(), String> {
        let place = self.place(index);
        let first = Invocation::new(UVec3::ZERO, place, self.workgroups, self.size);
        begin(Some(RunningInvocation {
            kernel: self.info.name,
            id: first,
            is_checked: self.is_checked,
            is_additional: place.cmpge(self.needed).any(),
        }));
        // each workgroup has an order of its own
        let count = u64::from(self.size.element_product());
        let order = self.mode.order.map(|order| order.permutation(count, 1 + index));
        self.run_at(place, order.as_deref())
    }

    fn run_at(&self, place: UVec3, order: Option<&[u64]>) -> Result<(), String> {
        let size = self.size;
        let changed = |change| self.info.run_arithmetic[change as usize];
        let run = match self.mode.arithmetic.and_then(changed) {
            Some(run) => CpuRun::Invocation(run),
            None => self.run,
        };
        let is_watched = self.is_checked || cfg!(debug_assertions);
        match run {
            CpuRun::Lanes(_) | CpuRun::LaneRegions(..) => {
                unreachable!("`run_of` has chosen an instruction set")
            }
            CpuRun::Workgroup(run) => {
                let run = |part| {
                    // SAFETY: the bindings come from the typed dispatch, and kernels do not write to the same
                    // element from two invocations without atomics. `Cpu::new` has checked the instruction set.
                    unsafe { run(self.bindings, place, self.workgroups, part) }
                };
                match order {
                    None => run([UVec3::ZERO, size]),
                    Some(order) => order.iter().for_each(|&index| {
                        let begin = unlinear(index, size);
                        run([begin, begin + 1]);
                    }),
                }
                Ok(())
            }
            // no invocation waits for another: it is a run with changed arithmetic
            CpuRun::Invocation(run) if self.run.waiting().is_none() => {
                let usual: Vec<_> = (0..u64::from(size.element_product())).collect();
                for &index in order.unwrap_or(&usual) {
                    enter(index as u32);
                    let local = unlinear(index, size);
                    let id = Invocation::new(local, place, self.workgroups, size).dispatched();
                    // SAFETY: as above
                    unsafe { run(self.bindings, id) };
                }
                Ok(())
            }
            // SAFETY: as above, and the workgroup memory is what this kernel declares
            CpuRun::Invocation(run) => unsafe {
                let places = [size, place, self.workgroups];
                workgroup::run_bound(
                    self.shared,
                    run,
                    self.bindings,
                    places,
                    order,
                    self.subgroup_size,
                    is_watched,
                )
            },
            // SAFETY: as above
            CpuRun::Regions(runs, _) => unsafe {
                let places = [size, place, self.workgroups];
                regions::run_regions(self.shared, runs, self.bindings, places, order, is_watched)
            },
        }
    }

    fn run_some(&self, mut indices: impl Iterator<Item = u64>) -> Result<(), String> {
        let _flushing = self.mode.is_flushing.then(Flushing::enable);
        panics::supervise(|| indices.try_for_each(|index| self.run(index)))
    }
}

impl Cpu {
    /// Runs a kernel, and returns when it is done.
    pub fn dispatch(
        &self,
        info: &'static KernelInfo,
        uniform: &[u8],
        buffers: &[&RawBuffer],
        workgroups: Workgroups,
    ) -> Result<()> {
        let bindings = bind(info, uniform, buffers);
        let job = KernelJob { info, bindings, buffers, workgroups };
        let mode = RunMode { is_flushing: self.flush_denormals, ..RunMode::default() };
        let result = match self.thorough {
            Some(seed) => thorough::run(self, &job, seed),
            None => self.run_once(&job, mode).map(drop),
        };
        result.map_err(|reason| Error::Kernel { kernel: info.name.into(), reason })
    }

    /// Runs a kernel once. Returns what has watched its bindings.
    pub fn run_once<'a>(
        &self,
        job: &KernelJob<'a>,
        mode: RunMode,
    ) -> Result<Vec<Option<Monitor<'a>>>, String> {
        let info = job.info;
        let monitors = match self.check_races {
            true => monitors(info, &job.bindings, job.buffers, job.workgroups),
            false => Vec::new(),
        };
        let mut bindings: Vec<CpuBinding<'_>> = job.bindings.clone();
        for (binding, monitor) in bindings.iter_mut().zip(&monitors) {
            binding.monitor = monitor.as_ref().map(Monitor::as_dyn);
        }
        let launch = Launch {
            info,
            run: self.run_of(info),
            shared: self.entry_point(info).shared,
            bindings: &bindings,
            size: info.workgroup_size.into(),
            workgroups: job.workgroups.all.into(),
            needed: job.workgroups.needed.into(),
            is_checked: self.check_races,
            subgroup_size: info
                .subgroups
                .then_some(mode.subgroup_size.unwrap_or(self.subgroup_size)),
            mode,
        };
        self.launch(&launch)?;
        self.refuse_nan(info, &bindings, &monitors)?;
        Ok(monitors)
    }

    /// The run of a kernel, or of its variant.
    fn run_of(&self, info: &KernelInfo) -> CpuRun {
        match info.run {
            _ if self.entry_point(info).name != info.name => match info.run_variant {
                Some(run) => CpuRun::Invocation(run),
                None => unreachable!("`entry_point` has looked"),
            },
            run => run.with(self.instruction_set()),
        }
    }

    /// Runs all workgroups, on the threads that there are.
    fn launch(&self, launch: &Launch<'_>) -> Result<(), String> {
        let [x, y, z] = launch.workgroups.to_array().map(u64::from);
        if let Some(order) = launch.mode.order {
            return launch.run_some(order.permutation(x * y * z, 0).into_iter());
        }
        // one thread runs all workgroups with the same z
        let (all, at_once) = match launch.info.z_serial {
            true => (z, x * y),
            false => ((x * y * z).div_ceil(AT_ONCE), AT_ONCE),
        };
        let some = |index: usize| {
            let first = index as u64 * at_once;
            launch.run_some(first..(first + at_once).min(x * y * z))
        };
        if Self::is_single_thread() {
            return (0..all as usize).try_for_each(some);
        }
        self.pool.install(|| match launch.info.z_serial {
            true => (0..all as usize).into_par_iter().with_max_len(1).try_for_each(some),
            false => (0..all as usize).into_par_iter().try_for_each(some),
        })
    }

    /// Fails if a kernel has written NaN, on a device that checks this.
    fn refuse_nan(
        &self,
        info: &KernelInfo,
        bindings: &[CpuBinding<'_>],
        monitors: &[Option<Monitor<'_>>],
    ) -> Result<(), String> {
        let bindings = info.bindings.iter().zip(bindings).zip(monitors);
        for ((info, binding), monitor) in bindings {
            let Some(Monitor::Written(races)) = monitor else { continue };
            // SAFETY: the buffer's bytes; the dispatch is over, so nothing writes them
            let data = unsafe { std::slice::from_raw_parts(binding.data, binding.bytes) };
            if let Some(fault) = races.nan(info, data) {
                return Err(fault);
            }
        }
        Ok(())
    }
}
