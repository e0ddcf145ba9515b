//! Workgroups with barriers on the CPU: each invocation is a coroutine that yields at them.
//!
//! A device runs a kernel this way if `#[kernel]` cannot cut it into [regions]. So does [`Workgroup`], for a unit test beside
//! a kernel. In a debug build it runs the regions of a kernel that is cut, if all invocations call that with the same arguments:
//!
//! ```
//! # extern crate muslin_kernel as muslin;
//! use muslin::prelude::*;
//! use muslin::workgroup::{SharedMemory, Workgroup};
//!
//! /// Reverses the values of a workgroup.
//! #[kernel(threads(64))]
//! pub fn reverse(id: Invocation, data: Write<u32>, values: Shared<u32, 64>) {
//!     values.write(id.local.x, data.read(id.index()));
//!     id.barrier();
//!     data.write(id.index(), values.read(63 - id.local.x));
//! }
//!
//! # fn main() {
//! let mut data: Vec<u32> = (0..64).collect();
//! let (view, values) = (Write::from(&mut data[..]), SharedMemory::new());
//! Workgroup::new([64, 1, 1]).run(|id| reverse(id, view, values.view()));
//! assert!(data.into_iter().eq((0..64).rev()));
//! # }
//! ```

extern crate std;

use core::cell::{Cell, RefCell, UnsafeCell};
use core::panic::Location;
use core::ptr;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::string::String;
use std::vec;
use std::vec::Vec;

use bytemuck::Pod;
use corosensei::stack::DefaultStack;
use corosensei::{Coroutine, Yielder};
use glam::{UVec3, UVec4};

use crate::binding::{CpuBinding, SharedInfo};
use crate::conflict;
use crate::invocation::Invocation;
use crate::memory::{AccessMonitor, Shared};
use crate::regions::{self, Failure, RegionsRun};
use crate::running::{self, PanicContext, unlinear};
use crate::stop::{Meeting, Stop, barrier_is_reached, subgroups_meet};
use crate::subgroup::operation::Operation;
use crate::workgroup_memory::{self, UNWRITTEN, WorkgroupMemory};
use crate::{phase, stop};

/// Stack of an invocation, in bytes: kernels need little, but panics and unoptimized builds need more.
const STACK: usize = 64 << 10;

/// An invocation.
type Body = Coroutine<(), Stop, (), DefaultStack>;

std::thread_local! {
    static STACKS: RefCell<Vec<DefaultStack>> = const { RefCell::new(Vec::new()) };
    static CURRENT: Cell<*const Yielder<(), Stop>> = const { Cell::new(ptr::null()) };
    /// Number of lanes of a subgroup, in a kernel that declares them.
    static SUBGROUP_SIZE: Cell<Option<u32>> = const { Cell::new(None) };
    /// What the invocation that stops gives to its subgroup, and what the one that goes on gets from it.
    static MEETING: Cell<Option<Meeting>> = const { Cell::new(None) };
    /// What the invocation that stops calls.
    static CALL: Cell<*const Call<'static>> = const { Cell::new(ptr::null()) };
    /// Whether what the invocations called has run.
    static HAS_RUN: Cell<bool> = const { Cell::new(false) };
}

/// A call of a kernel that is cut into regions.
struct Call<'a> {
    kernel: &'static str,
    run: RegionsRun,
    id: Invocation,
    /// The arguments: bindings, and then workgroup memory.
    bindings: &'a [CpuBinding<'a>],
}

impl Call<'_> {
    /// Whether another invocation calls the same kernel with the same arguments.
    fn is_same(&self, other: &Self) -> bool {
        let monitor = |binding: &CpuBinding<'_>| {
            binding.monitor.map_or(ptr::null(), |monitor| ptr::from_ref(monitor).cast::<()>())
        };
        let same = |(one, other): (&CpuBinding<'_>, &CpuBinding<'_>)| {
            (one.data, one.bytes, monitor(one)) == (other.data, other.bytes, monitor(other))
        };
        ptr::fn_addr_eq(self.run, other.run)
            && self.bindings.len() == other.bindings.len()
            && self.bindings.iter().zip(other.bindings).all(same)
    }
}

/// Runs the kernel that an invocation of a test calls, together with all other invocations, region by region. Returns whether it has run: if
/// they do not all call the same, each runs its own.
#[doc(hidden)]
pub fn run_together(
    kernel: &'static str,
    run: RegionsRun,
    id: Invocation,
    bindings: &[CpuBinding<'_>],
) -> bool {
    // a device has chosen already
    if CURRENT.get().is_null() || running::current().is_some() {
        return false;
    }
    let call = Call { kernel, run, id, bindings };
    CALL.set(ptr::from_ref(&call).cast());
    suspend(Location::caller());
    HAS_RUN.get()
}

/// Runs what all invocations of a workgroup call, if all call the same. `place` is the first invocation.
fn run_called(calls: &[&Call<'_>], place: Invocation) -> std::thread::Result<Result<(), Failure>> {
    let Some(first) = calls.first() else { return Ok(Ok(())) };
    let is_usual = |(index, call): (u64, &&Call<'_>)| {
        let id = call.id;
        let parts = |id: Invocation| [id.workgroup, id.workgroups, id.size, UVec3::splat(id.each)];
        let is_own = id.local == unlinear(index, place.size) && parts(id) == parts(place);
        is_own && ptr::fn_addr_eq(id.wait, wait as fn(_)) && call.is_same(first)
    };
    let all = calls.len() == place.size.element_product() as usize;
    HAS_RUN.set(all && (0..).zip(calls).all(is_usual));
    if !HAS_RUN.get() {
        return Ok(Ok(()));
    }
    running::enter(0);
    // SAFETY: the arguments of a call of this kernel, whose invocations wait
    let result = unsafe { regions::run_watched(first.run, first.bindings, place, None, &[]) };
    if result.is_err() {
        let local = unlinear(running::invocation().into(), place.size);
        let id = Invocation { local, ..place };
        PanicContext::new(first.kernel, id, place.size.to_array()).tell();
    }
    result
}

/// Suspends the current coroutine until its workgroup has reached the barrier.
fn wait(at: &'static Location<'static>) {
    suspend(at);
}

/// Suspends the current coroutine until its subgroup has reached the operation, to which it gives at most four words. Returns the
/// operation's result.
#[track_caller]
pub(crate) fn meet(operation: Operation, given: &[u32]) -> UVec4 {
    subgroup_size();
    let mut value = UVec4::ZERO;
    value.as_mut()[..given.len()].copy_from_slice(given);
    MEETING.set(Some(Meeting { operation, value }));
    suspend(Location::caller());
    MEETING.take().expect("a subgroup goes on with a result").value
}

/// Number of lanes of a subgroup.
#[track_caller]
pub(crate) fn subgroup_size() -> u32 {
    let size = SUBGROUP_SIZE.get().filter(|_| !CURRENT.get().is_null());
    size.unwrap_or_else(|| match running::current() {
        Some(_) => panic!("a kernel with subgroups says so, `#[kernel(.., subgroups)]`"),
        None => panic!(
            "a subgroup, and no other invocation runs: a test calls a kernel with subgroups through `muslin::workgroup::Workgroup`"
        ),
    })
}

#[inline(always)]
fn suspend(at: &'static Location<'static>) {
    let yielder = CURRENT.get();
    assert!(!yielder.is_null(), "a barrier outside of a workgroup");
    let invocation = running::invocation();
    let left = running::iterations_left();
    let path = stop::take_path();
    // SAFETY: it is not read after this coroutine was resumed or dropped, and until then `path` is not touched
    let steps = unsafe { core::slice::from_raw_parts(path.as_ptr(), path.len()) };
    // SAFETY: set by the coroutine that runs now, whose yielder lives as long as it
    unsafe { &*yielder }.suspend(Stop { at, path: steps });
    // other coroutines ran meanwhile
    CURRENT.set(yielder);
    running::enter(invocation);
    running::allow_iterations(left);
    stop::set_path(path);
}

/// Runs the invocations of one workgroup in a dispatch, from barrier to barrier. `run` takes the workgroup memory
/// `shared` after the bindings, and every access to it is checked if it `is_watched`. `order` has the indices of the invocations, if it
/// is not the usual one. `subgroup_size` is set for a kernel with subgroups.
///
/// # Errors
/// A mistake in its use of barriers or memory.
///
/// # Safety
/// The same as for [`CpuRun`](crate::kernel::CpuRun), with the bindings alone. `run` is the run of a kernel that
/// declares `shared`.
#[doc(hidden)]
pub unsafe fn run_bound(
    shared: &[SharedInfo],
    run: unsafe fn(&[CpuBinding], Invocation),
    bindings: &[CpuBinding],
    [size, workgroup, workgroups]: [UVec3; 3],
    order: Option<&[u64]>,
    subgroup_size: Option<u32>,
    is_watched: bool,
) -> Result<(), String> {
    let watches = workgroup_memory::take(if is_watched { shared } else { &[] });
    let words: usize = shared.iter().map(|shared| shared.bytes.div_ceil(16) as usize).sum();
    // where it is watched, no kernel can see what is there: it must not read unwritten elements
    let mut memory = vec![u128::from_ne_bytes([UNWRITTEN; 16]); words];
    let mut bindings = bindings.to_vec();
    let mut rest = memory.as_mut_slice();
    for (at, shared) in shared.iter().enumerate() {
        let (head, tail) = rest.split_at_mut(shared.bytes.div_ceil(16) as usize);
        bindings.push(CpuBinding {
            data: head.as_mut_ptr().cast(),
            bytes: shared.bytes as usize,
            monitor: watches.get(at).map(|watch| watch as &dyn AccessMonitor),
        });
        rest = tail;
    }
    let bindings = bindings.as_slice();
    // SAFETY: the caller's bindings, and workgroup memory of the declared types. The coroutines of a workgroup share
    // a thread, so only one at a time touches memory.
    let body = |id| unsafe { run(bindings, id) };
    let place = Invocation::new(UVec3::ZERO, workgroup, workgroups, size);
    let result = run_to_end(place, &body, order, subgroup_size);
    workgroup_memory::give_back(watches);
    result.map_err(|failure| failure.message(workgroup))
}

/// Runs all invocations of a workgroup from barrier to barrier. Either all wait at the same barrier, or none waits.
/// `place` is the first invocation.
fn run_to_end(
    place: Invocation,
    run: &dyn Fn(Invocation),
    order: Option<&[u64]>,
    subgroup_size: Option<u32>,
) -> Result<(), Failure> {
    let size = place.size;
    phase::next();
    phase::begin(size);
    conflict::take();
    SUBGROUP_SIZE.set(subgroup_size);
    let new = |index: u32| {
        let id = Invocation { local: unlinear(index.into(), size), wait, ..place };
        let body = move |yielder: &Yielder<(), Stop>, ()| {
            CURRENT.set(yielder);
            running::enter(index);
            run(id);
        };
        // SAFETY: the coroutines are dropped below, which unwinds those that have not ended, before what they borrow
        unsafe { Coroutine::with_stack_unchecked(take_stack(), body) }
    };
    let mut invocations: Vec<Body> = (0..size.element_product()).map(new).collect();
    let mut stops = vec![None; invocations.len()];
    // empty without subgroups
    let mut meetings = vec![None; subgroup_size.map_or(0, |_| invocations.len())];
    loop {
        let calls = go_on(&mut invocations, &mut stops, &mut meetings, order);
        let called = calls.and_then(|calls| Ok((run_called(&calls, place)?, !calls.is_empty())));
        let subgroups = |of| subgroups_meet(size, of, &mut stops, &mut meetings);
        let failure = match called {
            Err(panic) => match conflict::take() {
                // it may have panicked because of a wrong value
                Some(conflict) => Some(Failure::Memory(conflict)),
                None => {
                    give_up(invocations);
                    resume_unwind(panic)
                }
            },
            Ok((Err(failure), _)) => Some(failure),
            Ok((Ok(()), true)) => continue,
            Ok((Ok(()), false)) => match subgroup_size.map_or(Ok(false), subgroups) {
                // those that wait at barriers go on waiting
                Ok(true) => continue,
                Ok(false) => match barrier_is_reached(size, &stops) {
                    Ok(()) => conflict::take().map(Failure::Memory),
                    Err(reason) => Some(Failure::Divergence(reason)),
                },
                Err(reason) => Some(Failure::Divergence(reason)),
            },
        };
        if let Some(failure) = failure {
            give_up(invocations);
            return Err(failure);
        }
        if stops[0].is_none() {
            break;
        }
        stops.fill(None);
        phase::next();
    }
    for invocation in invocations {
        STACKS.with_borrow_mut(|stacks| stacks.push(invocation.into_stack()));
    }
    stop::take_path();
    Ok(())
}

/// Runs each invocation that does not wait to its next stop, or to its end. Returns the calls that some stop at: these go on next time.
#[inline(always)]
fn go_on(
    invocations: &mut [Body],
    stops: &mut [Option<Stop>],
    meetings: &mut [Option<Meeting>],
    order: Option<&[u64]>,
) -> std::thread::Result<Vec<&'static Call<'static>>> {
    let mut calls = Vec::new();
    for step in 0..invocations.len() {
        let index = order.map_or(step, |order| order[step] as usize);
        let invocation = &mut invocations[index];
        if invocation.done() || stops[index].is_some() {
            continue;
        }
        if let Some(meeting) = meetings.get(index) {
            MEETING.set(*meeting);
        }
        let stop = catch_unwind(AssertUnwindSafe(|| invocation.resume(()).as_yield()))?;
        // SAFETY: null, or what the coroutine keeps while it waits
        match unsafe { CALL.replace(ptr::null()).as_ref() } {
            Some(call) => calls.push(call),
            None => stops[index] = stop,
        }
        if let Some(meeting) = meetings.get_mut(index) {
            *meeting = MEETING.take();
        }
    }
    CURRENT.set(ptr::null());
    Ok(calls)
}

/// Ends invocations that are still waiting.
fn give_up(invocations: Vec<Body>) {
    CURRENT.set(ptr::null());
    running::silence(true);
    drop(invocations);
    running::silence(false);
}

fn take_stack() -> DefaultStack {
    STACKS
        .with_borrow_mut(Vec::pop)
        .unwrap_or_else(|| DefaultStack::new(STACK).expect("memory for a coroutine's stack"))
}

/// One workgroup of a kernel, in a test that calls the kernel as a function.
///
/// The invocations wait for each other at barriers. A device runs whole dispatches, and finds more mistakes.
#[derive(Clone, Copy, Debug)]
pub struct Workgroup {
    size: UVec3,
    place: UVec3,
    among: UVec3,
    subgroup_size: u32,
}

impl Workgroup {
    /// The only workgroup of a dispatch. `size` is the kernel's `threads`.
    #[must_use]
    pub fn new(size: [u32; 3]) -> Self {
        Self { size: size.into(), place: UVec3::ZERO, among: UVec3::ONE, subgroup_size: 32 }
    }

    /// Places the workgroup at `place` in a dispatch of `among` workgroups.
    #[must_use]
    pub fn at(self, place: [u32; 3], among: [u32; 3]) -> Self {
        Self { place: place.into(), among: among.into(), ..self }
    }

    /// Divides the workgroup into subgroups of `size`: one of [`SIZES`](crate::subgroup::SIZES). Otherwise they have 32 lanes.
    #[must_use]
    pub fn subgroups(self, size: u32) -> Self {
        Self { subgroup_size: size, ..self }
    }

    /// Calls `kernel` for every invocation.
    ///
    /// # Panics
    /// If the kernel panics, if invocations do not reach the same barrier, or if a barrier is missing between two
    /// accesses to an element of workgroup memory.
    #[track_caller]
    pub fn run(&self, kernel: impl Fn(Invocation)) {
        let place = Invocation::new(UVec3::ZERO, self.place, self.among, self.size);
        match run_to_end(place, &kernel, None, Some(self.subgroup_size)) {
            Ok(()) => {}
            Err(Failure::Divergence(reason) | Failure::Memory(reason)) => panic!("{reason}"),
        }
    }
}

/// Workgroup memory for [`Workgroup::run`]: a kernel must write an element before it reads it.
pub struct SharedMemory<T, const N: usize> {
    elements: UnsafeCell<Vec<T>>,
    monitor: WorkgroupMemory,
}

impl<T: Pod, const N: usize> SharedMemory<T, N> {
    /// Unwritten memory.
    #[must_use]
    pub fn new() -> Self {
        Self {
            elements: UnsafeCell::new(vec![T::zeroed(); N]),
            monitor: WorkgroupMemory::new(N as u32),
        }
    }

    /// The array as a parameter of a kernel.
    pub fn view(&self) -> Shared<'_, T, N> {
        // SAFETY: N values, which only the views touch, on one thread, as an `UnsafeCell` is not shared between threads
        let view = unsafe { Shared::from_raw((*self.elements.get()).as_mut_ptr()) };
        view.monitored(Some(&self.monitor))
    }
}

impl<T: Pod, const N: usize> Default for SharedMemory<T, N> {
    fn default() -> Self {
        Self::new()
    }
}
