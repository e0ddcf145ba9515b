//! Workgroups with barriers on the CPU, without coroutines: `#[kernel]` cuts a kernel at its barriers into regions, and each region is a loop
//! over the invocations. What lives across a barrier is in arrays, [`PerInvocation`].
//!
//! A kernel that cannot be cut runs as [coroutines](crate::workgroup). Both find the same mistakes. `#[kernel]` sees no types, so it does not see
//! what a method of one's own borrows. Rust tells it, and then the kernel says `coroutines`:
//!
//! ```compile_fail,E0597
//! # extern crate muslin_kernel as muslin;
//! use muslin::prelude::*;
//!
//! struct Sum(u32);
//!
//! impl Sum {
//!     fn place(&mut self) -> &mut u32 {
//!         &mut self.0
//!     }
//! }
//!
//! #[kernel(threads(64), storage_barriers)]
//! pub fn keeps_a_borrow(id: Invocation, data: Write<u32>) {
//!     let mut sum = Sum(1);
//!     let place = sum.place();
//!     id.storage_barrier();
//!     *place += 1;
//!     data.write(id.index(), sum.0);
//! }
//! # fn main() {}
//! ```

extern crate std;

use core::cell::{Cell, RefCell, UnsafeCell};
use core::marker::PhantomData;
use core::mem::{self, MaybeUninit};
use core::panic::Location;
use std::boxed::Box;
use std::format;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::string::String;
use std::vec::Vec;

use bytemuck::Pod;
use glam::UVec3;

use crate::binding::{CpuBinding, SharedInfo};
use crate::conflict;
use crate::invocation::Invocation;
use crate::lane::Lane;
use crate::memory::{AccessMonitor, Shared};
use crate::phase;
use crate::running::{self, unlinear};
use crate::stop::side;
use crate::workgroup_memory::{self, UNWRITTEN, WorkgroupMemory};

/// The reason why a workgroup fails.
pub enum Failure {
    /// Not all invocations came to a barrier.
    Divergence(String),
    /// A wrong use of workgroup memory.
    Memory(String),
}

impl Failure {
    /// The message.
    pub fn message(self, workgroup: UVec3) -> String {
        match self {
            Self::Divergence(reason) => format!("{reason}, in workgroup {workgroup}"),
            Self::Memory(reason) => reason,
        }
    }
}

/// A workgroup that runs region by region. Where a method's parameter `PLAIN` is true, nothing is watched, and invocations have their
/// usual order: such code is as short as a loop that somebody writes. Otherwise, what is not generic is faster in debug builds, where a
/// project's kernels are not optimized.
pub struct Regions<'a> {
    first: Invocation,
    order: Option<&'a [u64]>,
    watches: &'a [WorkgroupMemory],
    turns: &'a [Turn],
    /// Most iterations of an invocation.
    max: Cell<u32>,
    /// The iterations that all have run together, in loops with barriers.
    common: Cell<u32>,
    /// Most other iterations that an invocation has run.
    most: Cell<u32>,
    /// The iterations that the invocation had left when it began its part of a region.
    left: Cell<u32>,
}

/// Runs a workgroup region by region.
///
/// # Safety
/// The same as for [`CpuRun`](crate::kernel::CpuRun), with the bindings alone: where it is watched, workgroup memory may follow them.
pub type RegionsRun = unsafe fn(&Regions<'_>, &[CpuBinding]) -> Result<(), Failure>;

/// A kernel that is cut at its barriers.
#[derive(Clone, Copy)]
pub struct RegionRuns {
    /// Runs it where nothing is watched.
    pub plain: RegionsRun,
    /// Runs it where accesses are watched, iterations counted, or invocations have an order.
    pub watched: RegionsRun,
}

/// An invocation of a workgroup that is not plain.
struct Turn {
    local: UVec3,
    /// The iterations that it has run, but for those that all have run together.
    own: Cell<u32>,
}

std::thread_local! {
    /// The invocations of the thread's last workgroup, and its size.
    static TURNS: RefCell<(UVec3, Vec<Turn>)> = const { RefCell::new((UVec3::ZERO, Vec::new())) };
}

/// The invocations of a workgroup.
fn turns(size: UVec3) -> Vec<Turn> {
    let (last, turns) = TURNS.take();
    if last == size {
        return turns;
    }
    let turn = |index| Turn { local: unlinear(index, size), own: Cell::new(0) };
    (0..u64::from(size.element_product())).map(turn).collect()
}

/// Runs one workgroup of a dispatch, region by region. It takes what [`run_bound`](crate::workgroup::run_bound) takes.
///
/// # Errors
/// A mistake in its use of barriers or memory.
///
/// # Safety
/// The same as for [`CpuRun`](crate::kernel::CpuRun), with the bindings alone. `runs` are those of a kernel that declares `shared`.
#[doc(hidden)]
pub unsafe fn run_regions(
    shared: &[SharedInfo],
    runs: RegionRuns,
    bindings: &[CpuBinding],
    [size, workgroup, workgroups]: [UVec3; 3],
    order: Option<&[u64]>,
    is_watched: bool,
) -> Result<(), String> {
    let first = Invocation::new(UVec3::ZERO, workgroup, workgroups, size);
    running::enter(order.map_or(0, |order| order[0] as u32));
    if !is_watched && order.is_none() {
        let regions = Regions::new(first, order, &[], &[]);
        // SAFETY: the caller's
        let result = unsafe { (runs.plain)(&regions, bindings) };
        return result.map_err(|failure| failure.message(workgroup));
    }
    phase::next();
    phase::begin(size);
    conflict::take();
    let watches = workgroup_memory::take(if is_watched { shared } else { &[] });
    // SAFETY: the caller's
    let result = unsafe { run_watched(runs.watched, bindings, first, order, &watches) };
    workgroup_memory::give_back(watches);
    if let Ok(Err(failure)) = result {
        return Err(failure.message(workgroup));
    }
    match (conflict::take(), result) {
        // it may have panicked because of a wrong value
        (Some(conflict), _) => Err(conflict),
        (None, Err(panic)) => resume_unwind(panic),
        (None, Ok(_)) => Ok(()),
    }
}

/// Runs a workgroup in its phase. `first` is its first invocation.
///
/// # Safety
/// The same as for [`RegionsRun`].
pub(crate) unsafe fn run_watched(
    run: RegionsRun,
    bindings: &[CpuBinding],
    first: Invocation,
    order: Option<&[u64]>,
    watches: &[WorkgroupMemory],
) -> std::thread::Result<Result<(), Failure>> {
    let turns = turns(first.size);
    let regions = Regions::new(first, order, watches, &turns);
    // SAFETY: the caller's
    let result = catch_unwind(AssertUnwindSafe(|| unsafe { run(&regions, bindings) }));
    TURNS.set((first.size, turns));
    result
}

impl<'a> Regions<'a> {
    #[inline(always)]
    fn new(
        first: Invocation,
        order: Option<&'a [u64]>,
        watches: &'a [WorkgroupMemory],
        turns: &'a [Turn],
    ) -> Self {
        let [common, most, left] = [(); 3].map(|()| Cell::new(0));
        Self { first, order, watches, turns, max: Cell::new(u32::MAX), common, most, left }
    }
}

impl Regions<'_> {
    /// The first invocation. The workgroup's size is a constant, for the compiler.
    #[inline(always)]
    pub fn first(&self, size: [u32; 3]) -> Invocation {
        Invocation { size: UVec3::from_array(size), ..self.first }
    }

    /// A binding, with what watches it.
    #[inline(always)]
    pub fn binding<'a, const PLAIN: bool>(&self, binding: &CpuBinding<'a>) -> CpuBinding<'a> {
        if PLAIN { CpuBinding { monitor: None, ..*binding } } else { *binding }
    }

    /// What watches an array of workgroup memory.
    #[inline(always)]
    pub fn watch<const PLAIN: bool>(&self, array: usize) -> Option<&dyn AccessMonitor> {
        if PLAIN { None } else { self.watches.get(array).map(|watch| watch as &dyn AccessMonitor) }
    }

    /// Whether all invocations run in lanes, which takes that they are below a kernel's number of `items`. In an order of their own, they do not.
    #[inline(always)]
    pub fn fill_lanes(&self, first: &Invocation, items: u32) -> bool {
        self.order.is_none() && first.are_among(first.size.x, items)
    }

    /// The first and the end of the steps of a region that does something for a part of the `count` invocations, of which `width` take a step
    /// together. In an order of their own, all have a step.
    #[inline(always)]
    pub fn steps<const PLAIN: bool>(
        &self,
        width: u32,
        [begin, end]: [u32; 2],
        count: u32,
    ) -> [u32; 2] {
        if PLAIN || self.order.is_none() {
            [begin - begin % width, if end < count { end } else { count }]
        } else {
            [0, count]
        }
    }

    /// The invocation of a step begins its part of a region: it is the place of `id`.
    #[inline(always)]
    pub fn enter<const PLAIN: bool>(&self, step: u32, id: &mut Invocation) -> Entered<PLAIN> {
        if !PLAIN {
            return Entered { index: self.enter_watched(step, id) };
        }
        let [x, y, _] = id.size.to_array();
        id.local = UVec3::new(step % x, step / x % y, step / (x * y));
        Entered { index: step }
    }

    fn enter_watched(&self, step: u32, id: &mut Invocation) -> u32 {
        let index = self.order.map_or(step, |order| order[step as usize] as u32);
        let turn = &self.turns[index as usize];
        id.local = turn.local;
        running::enter(index);
        let left = self.max.get() - self.common.get() - turn.own.get();
        running::allow_iterations(left);
        self.left.set(left);
        index
    }

    /// It has come to the end of the region.
    #[inline(always)]
    pub fn leave<const PLAIN: bool>(&self, entered: Entered<PLAIN>) {
        if !PLAIN {
            self.leave_watched(entered.index);
        }
        mem::forget(entered);
    }

    fn leave_watched(&self, index: u32) {
        if running::iterations_left() == self.left.get() {
            return;
        }
        let own = self.max.get() - self.common.get() - running::iterations_left();
        self.turns[index as usize].own.set(own);
        self.most.set(self.most.get().max(own));
    }

    /// Sets the iterations that each invocation may run.
    pub fn allow_iterations(&self, max: u32) {
        self.max.set(max);
        self.turns.iter().for_each(|turn| turn.own.set(0));
    }

    /// Each invocation runs one round of a loop with a barrier.
    #[track_caller]
    pub fn iterate(&self) {
        if self.common.get() + self.most.get() < self.max.get() {
            self.common.set(self.common.get() + 1);
            return;
        }
        // one of them has none left
        let mut id = self.first;
        for step in 0..self.turns.len() as u32 {
            self.enter_watched(step, &mut id);
            running::iterate();
        }
    }

    /// All invocations have reached a barrier.
    ///
    /// # Errors
    /// If one has used workgroup memory wrongly.
    #[inline(always)]
    pub fn barrier<const PLAIN: bool>(&self) -> Result<(), Failure> {
        if PLAIN { Ok(()) } else { next_phase() }
    }

    /// All invocations have reached a storage barrier.
    ///
    /// # Errors
    /// As [`Self::barrier`].
    #[inline(always)]
    pub fn storage_barrier<const PLAIN: bool>(&self) -> Result<(), Failure> {
        self.barrier::<PLAIN>()?;
        if !PLAIN {
            phase::begin_storage();
        }
        Ok(())
    }
}

fn next_phase() -> Result<(), Failure> {
    match conflict::take() {
        Some(conflict) => Err(Failure::Memory(conflict)),
        None => {
            phase::next();
            Ok(())
        }
    }
}

/// An invocation that runs its part of a region. If that panics, the thread knows whose it was.
pub struct Entered<const PLAIN: bool> {
    /// Its index in the workgroup.
    pub index: u32,
}

impl<const PLAIN: bool> Drop for Entered<PLAIN> {
    #[cold]
    fn drop(&mut self) {
        running::enter(self.index);
    }
}

/// A variable of each of `N` invocations, which run in lanes `L`: several have one value then. Larger ones than a vector of each invocation are
/// on the heap, so that the stack is large enough for all.
pub struct PerInvocation<T, const N: usize, L> {
    vectors: UnsafeCell<MaybeUninit<Vectors<N>>>,
    heap: Option<Box<[UnsafeCell<MaybeUninit<T>>]>>,
    lanes: PhantomData<L>,
}

/// Memory for four numbers of each invocation, where vectors lie in one line of a cache.
#[repr(align(64))]
#[derive(Clone, Copy)]
struct Vectors<const N: usize>([[u8; 16]; N]);

impl<T, const N: usize, L: Lane> PerInvocation<T, N, L> {
    const IS_VECTOR: bool =
        size_of::<T>() <= 16 * L::WIDTH as usize && align_of::<T>() <= align_of::<Vectors<N>>();

    /// Without values.
    #[inline(always)]
    #[expect(clippy::new_without_default, reason = "generated code calls it")]
    pub fn new() -> Self {
        const {
            assert!(
                !mem::needs_drop::<T>(),
                "what a kernel keeps across a barrier is dropped: say `#[kernel(.., coroutines)]`"
            );
        }
        let uninit = || UnsafeCell::new(MaybeUninit::uninit());
        let heap = if Self::IS_VECTOR { None } else { Some((0..N).map(|_| uninit()).collect()) };
        Self { vectors: UnsafeCell::new(MaybeUninit::uninit()), heap, lanes: PhantomData }
    }

    #[inline(always)]
    fn at(&self, index: u32) -> *mut T {
        let first = match &self.heap {
            Some(heap) if !Self::IS_VECTOR => heap.as_ptr().cast_mut().cast::<T>(),
            _ => self.vectors.get().cast::<T>(),
        };
        first.wrapping_add((index / L::WIDTH) as usize)
    }

    /// The value of an invocation, which then has none.
    ///
    /// # Safety
    /// `index` is below `N`, and this invocation has put a value. Taken again, it is a copy.
    #[inline(always)]
    pub unsafe fn take(&self, index: u32) -> T {
        // SAFETY: the caller's
        unsafe { self.at(index).read() }
    }

    /// Sets the value of an invocation.
    ///
    /// # Safety
    /// `index` is below `N`.
    #[inline(always)]
    pub unsafe fn put(&self, index: u32, value: T) {
        // SAFETY: the caller's
        unsafe { self.at(index).write(value) }
    }
}

/// The type of a variable that several regions compute.
pub struct Same<T>(PhantomData<T>);

impl<T> Same<T> {
    /// A type that is not known yet.
    #[inline(always)]
    #[expect(clippy::new_without_default, reason = "generated code calls it")]
    pub const fn new() -> Self {
        Self(PhantomData)
    }

    /// The value, which has this type.
    #[inline(always)]
    pub fn of(&self, value: T) -> T {
        value
    }
}

/// An array of workgroup memory.
pub struct Memory<T, const N: usize>(UnsafeCell<MaybeUninit<[T; N]>>);

impl<T: Pod, const N: usize> Memory<T, N> {
    /// Memory before a kernel writes it.
    #[inline(always)]
    pub const fn unwritten() -> Self {
        let mut memory = MaybeUninit::<[T; N]>::uninit();
        // SAFETY: its own bytes
        unsafe { memory.as_mut_ptr().write_bytes(UNWRITTEN, 1) };
        Self(UnsafeCell::new(memory))
    }

    /// The array as a parameter of a kernel.
    #[inline(always)]
    pub fn view<'a>(&'a self, monitor: Option<&'a dyn AccessMonitor>) -> Shared<'a, T, N> {
        // SAFETY: N values, of which all bytes are set, and which only views touch, on one thread
        unsafe { Shared::from_raw(self.0.get().cast()) }.monitored(monitor)
    }
}

/// What the invocations of a workgroup decide: all take a branch or a loop with a barrier, or none does.
pub struct Votes<const N: usize>([bool; N]);

impl<const N: usize> Votes<N> {
    /// Before all have voted.
    #[inline(always)]
    #[expect(clippy::new_without_default, reason = "generated code calls it")]
    pub const fn new() -> Self {
        Self([false; N])
    }

    /// An invocation votes, for as many as run with it.
    #[inline(always)]
    pub fn set(&mut self, index: u32, width: u32, vote: bool) {
        self.0[index as usize..][..width as usize].fill(vote);
    }

    /// What all have voted.
    ///
    /// # Errors
    /// If they do not agree.
    #[inline(always)]
    pub fn decide(&self, fork: &Fork<'_>) -> Result<bool, Failure> {
        decide(&self.0, fork)
    }
}

fn decide(votes: &[bool], fork: &Fork<'_>) -> Result<bool, Failure> {
    let yes: u32 = votes.iter().map(|&vote| u32::from(vote)).sum();
    match yes as usize {
        0 => Ok(false),
        all if all == votes.len() => Ok(true),
        _ => Err(fork.divergence(votes)),
    }
}

/// A branch, or the beginning of a round of a loop.
pub struct Fork<'a> {
    /// The workgroup.
    pub regions: &'a Regions<'a>,
    /// Its place.
    pub at: &'static Location<'static>,
    /// The first barrier of those who take it, and of those who do not.
    pub barriers: [Option<&'static Location<'static>>; 2],
    /// The round of a loop, counted from 1; 0 for a branch.
    pub round: u32,
}

impl Fork<'_> {
    #[cold]
    fn divergence(&self, votes: &[bool]) -> Failure {
        let Self { at, barriers, round, .. } = self;
        let does = |vote: bool| match (barriers[usize::from(!vote)], round, vote) {
            (Some(barrier), 0, _) => format!("waits at the barrier of {barrier}"),
            (Some(barrier), round, _) => {
                format!("waits at the barrier of {barrier} in round {round} of the loop of {at}")
            }
            (None, 0, true) => format!("takes the branch of {at}"),
            (None, 0, false) => format!("does not take the branch of {at}"),
            (None, round, _) => format!("leaves the loop of {at} before round {round}"),
        };
        let voters = |vote| {
            let mut indices = (0..votes.len()).filter(|&index| votes[index] == vote);
            let first = indices.next().unwrap_or_default();
            side([first, 1 + indices.count()], self.regions.first.size, &does(vote))
        };
        // who waits comes first
        let first = barriers[0].is_some() && (votes[0] || barriers[1].is_none());
        let [one, other] = [first, !first].map(voters);
        Failure::Divergence(format!("a barrier in divergent control flow: {one}, while {other}"))
    }
}

/// The place in the source that calls it.
#[inline(always)]
#[track_caller]
pub const fn here() -> &'static Location<'static> {
    Location::caller()
}
