//! Workgroups whose invocations wait for one another: each invocation is a coroutine that yields at barriers.

use std::cell::{Cell, RefCell};
use std::ptr;

use corosensei::stack::DefaultStack;
use corosensei::{Coroutine, CoroutineResult, Yielder};
use glam::UVec3;
use organza_kernels::KernelInfo;
use organza_kernels::invocation::Invocation;
use organza_kernels::kernel::CpuBinding;

/// Stack of an invocation, in bytes: kernels keep little, panics and unoptimized builds want more.
const STACK: usize = 64 << 10;

/// What workgroup memory holds before a kernel writes it: no kernel may rely on it.
const UNWRITTEN: u8 = 0xcd;

thread_local! {
    static STACKS: RefCell<Vec<DefaultStack>> = const { RefCell::new(Vec::new()) };
    static CURRENT: Cell<*const Yielder<(), ()>> = const { Cell::new(ptr::null()) };
}

/// Where a coroutine waits for its workgroup.
fn wait() {
    let yielder = CURRENT.get();
    assert!(!yielder.is_null(), "a barrier outside of a workgroup");
    // SAFETY: set by the coroutine that runs now, whose yielder lives as long as it
    unsafe { &*yielder }.suspend(());
    // others ran meanwhile
    CURRENT.set(yielder);
}

/// Runs the invocations of one workgroup, from barrier to barrier.
pub fn run_workgroup(
    info: &KernelInfo,
    run: unsafe fn(&[CpuBinding], Invocation),
    bindings: &[CpuBinding],
    workgroup: UVec3,
    workgroups: UVec3,
) {
    let words: usize = info.shared.iter().map(|shared| shared.bytes.div_ceil(16) as usize).sum();
    let mut memory = vec![u128::from_ne_bytes([UNWRITTEN; 16]); words];
    let mut bindings = bindings.to_vec();
    let mut rest = memory.as_mut_slice();
    for shared in info.shared {
        let (head, tail) = rest.split_at_mut(shared.bytes.div_ceil(16) as usize);
        bindings.push(CpuBinding { data: head.as_mut_ptr().cast(), bytes: shared.bytes as usize });
        rest = tail;
    }
    let bindings = bindings.as_slice();

    let size = UVec3::from(info.workgroup_size);
    let invocations = (0..size.element_product())
        .map(|index| {
            let local =
                UVec3::new(index % size.x, index / size.x % size.y, index / size.x / size.y);
            let mut id = Invocation::new(local, workgroup, workgroups, size);
            id.wait = wait;
            let body = move |yielder: &Yielder<(), ()>, ()| {
                CURRENT.set(yielder);
                // SAFETY: the caller's bindings, and workgroup memory of the declared types; the coroutines of
                // a workgroup share a thread, so that only one touches memory at a time
                unsafe { run(bindings, id) };
            };
            // SAFETY: `run_to_end` drops the coroutines, which unwinds those that have not ended, before what they
            // borrow
            unsafe { Coroutine::with_stack_unchecked(take_stack(), body) }
        })
        .collect();
    run_to_end(info, invocations);
}

fn run_to_end(info: &KernelInfo, mut invocations: Vec<Coroutine<(), (), (), DefaultStack>>) {
    loop {
        let mut waiting = 0;
        for invocation in &mut invocations {
            if !invocation.done() {
                waiting += usize::from(matches!(invocation.resume(()), CoroutineResult::Yield(())));
            }
        }
        CURRENT.set(ptr::null());
        if waiting == 0 {
            break;
        }
        assert_eq!(
            waiting,
            invocations.len(),
            "kernel `{}`: some invocations of a workgroup wait at a barrier that others do not reach",
            info.name
        );
    }
    for invocation in invocations {
        STACKS.with_borrow_mut(|stacks| stacks.push(invocation.into_stack()));
    }
}

fn take_stack() -> DefaultStack {
    STACKS
        .with_borrow_mut(Vec::pop)
        .unwrap_or_else(|| DefaultStack::new(STACK).expect("memory for a coroutine's stack"))
}
