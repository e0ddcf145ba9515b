//! Workgroups with barriers: each invocation is a coroutine that yields at them.

use std::cell::{Cell, RefCell};
use std::panic::Location;
use std::ptr;

use corosensei::stack::DefaultStack;
use corosensei::{Coroutine, Yielder};
use glam::UVec3;
use organza_kernel::KernelInfo;
use organza_kernel::invocation::Invocation;
use organza_kernel::kernel::CpuBinding;
use organza_kernel::running::{self, unlinear};

use crate::races::WorkgroupMemory;

/// Stack of an invocation, in bytes: kernels need little, panics and unoptimized builds more.
const STACK: usize = 64 << 10;

/// What workgroup memory holds before a kernel writes it: no kernel may rely on it.
const UNWRITTEN: u8 = 0xcd;

/// Where in the source an invocation waits.
type Barrier = &'static Location<'static>;

thread_local! {
    static STACKS: RefCell<Vec<DefaultStack>> = const { RefCell::new(Vec::new()) };
    static CURRENT: Cell<*const Yielder<(), Barrier>> = const { Cell::new(ptr::null()) };
}

/// Where a coroutine waits for its workgroup.
fn wait(at: &'static Location<'static>) {
    let yielder = CURRENT.get();
    assert!(!yielder.is_null(), "a barrier outside of a workgroup");
    let invocation = running::invocation();
    // SAFETY: set by the coroutine that runs now, whose yielder lives as long as it
    unsafe { &*yielder }.suspend(at);
    // others ran meanwhile
    CURRENT.set(yielder);
    running::enter(invocation);
}

/// Runs the invocations of one workgroup, from barrier to barrier.
pub fn run_workgroup(
    info: &KernelInfo,
    run: unsafe fn(&[CpuBinding], Invocation),
    bindings: &[CpuBinding],
    workgroup: UVec3,
    workgroups: UVec3,
) -> Result<(), String> {
    let size = UVec3::from(info.workgroup_size);
    let watches: Vec<_> =
        info.shared.iter().map(|shared| WorkgroupMemory::new(shared, size)).collect();
    let words: usize = info.shared.iter().map(|shared| shared.bytes.div_ceil(16) as usize).sum();
    let mut memory = vec![u128::from_ne_bytes([UNWRITTEN; 16]); words];
    let mut bindings = bindings.to_vec();
    let mut rest = memory.as_mut_slice();
    for (shared, monitor) in info.shared.iter().zip(&watches) {
        let (head, tail) = rest.split_at_mut(shared.bytes.div_ceil(16) as usize);
        bindings.push(CpuBinding {
            data: head.as_mut_ptr().cast(),
            bytes: shared.bytes as usize,
            monitor: Some(monitor),
        });
        rest = tail;
    }
    let bindings = bindings.as_slice();

    let invocations = (0..size.element_product())
        .map(|index| {
            let mut id = Invocation::new(unlinear(index.into(), size), workgroup, workgroups, size);
            id.wait = wait;
            let body = move |yielder: &Yielder<(), Barrier>, ()| {
                CURRENT.set(yielder);
                running::enter(index);
                // SAFETY: the caller's bindings, and workgroup memory of the declared types; the coroutines of
                // a workgroup share a thread, so that only one touches memory at a time
                unsafe { run(bindings, id) };
            };
            // SAFETY: `run_to_end` drops the coroutines, which unwinds those that have not ended, before what they
            // borrow
            unsafe { Coroutine::with_stack_unchecked(take_stack(), body) }
        })
        .collect();
    run_to_end(invocations, size, || watches.iter().for_each(WorkgroupMemory::pass_barrier))
        .map_err(|reason| format!("{reason}, in workgroup {workgroup}"))
}

/// Runs all invocations from barrier to barrier: every one waits at the same, or none.
fn run_to_end(
    mut invocations: Vec<Coroutine<(), Barrier, (), DefaultStack>>,
    size: UVec3,
    pass_barrier: impl Fn(),
) -> Result<(), String> {
    loop {
        let mut waiting = Vec::with_capacity(invocations.len());
        for invocation in &mut invocations {
            let barrier = match invocation.done() {
                true => None,
                false => invocation.resume(()).as_yield(),
            };
            waiting.push(barrier);
        }
        CURRENT.set(ptr::null());
        match waiting[0] {
            _ if waiting.iter().any(|barrier| *barrier != waiting[0]) => {
                return Err(divergence(&waiting, size));
            }
            None => break,
            Some(_) => pass_barrier(),
        }
    }
    for invocation in invocations {
        STACKS.with_borrow_mut(|stacks| stacks.push(invocation.into_stack()));
    }
    Ok(())
}

/// Who waits where, when the invocations of a workgroup do not wait together.
fn divergence(waiting: &[Option<Barrier>], size: UVec3) -> String {
    let (first, others): (Vec<_>, Vec<_>) =
        (0..waiting.len()).partition(|&index| waiting[index] == waiting[0]);
    let side = |indices: &[usize]| {
        let place = unlinear(indices[0] as u64, size);
        let does = match waiting[indices[0]] {
            Some(barrier) => format!("waits at the barrier of {barrier}"),
            None => "has ended".to_owned(),
        };
        match indices.len() - 1 {
            0 => format!("invocation {place} {does}"),
            more => format!("invocation {place} (with {more} more) {does}"),
        }
    };
    let (first, others) = (side(&first), side(&others));
    format!("a barrier in divergent control flow: {first}, while {others}")
}

fn take_stack() -> DefaultStack {
    STACKS
        .with_borrow_mut(Vec::pop)
        .unwrap_or_else(|| DefaultStack::new(STACK).expect("memory for a coroutine's stack"))
}
