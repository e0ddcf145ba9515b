//! The phases of the thread's workgroup: a phase lies between two barriers.

extern crate std;

use core::cell::Cell;

use glam::UVec3;

std::thread_local! {
    /// Number of barriers and workgroups so far. Between two of them is a phase.
    static PHASE: Cell<u64> = const { Cell::new(1) };
    /// Number of invocations in the workgroup, per axis.
    static SIZE: Cell<UVec3> = const { Cell::new(UVec3::ONE) };
    /// The phase in which the workgroup began.
    static FIRST_PHASE: Cell<u64> = const { Cell::new(1) };
    /// The phase that began with the last storage barrier.
    static STORAGE_PHASE: Cell<u64> = const { Cell::new(1) };
}

/// Begins a workgroup of this size.
pub fn begin(size: UVec3) {
    FIRST_PHASE.set(PHASE.get());
    SIZE.set(size);
}

/// The current phase of the thread's workgroup.
#[inline(always)]
pub fn current() -> u64 {
    PHASE.get()
}

/// The first phase of the thread's workgroup.
#[inline(always)]
pub fn first() -> u64 {
    FIRST_PHASE.get()
}

/// Number of invocations in the thread's workgroup, per axis.
pub fn size() -> UVec3 {
    SIZE.get()
}

/// Begins the next phase.
pub fn next() {
    PHASE.set(PHASE.get() + 1);
}

/// Orders storage buffers, too: an invocation says so when it goes on after a storage barrier. Each says the same.
pub fn begin_storage() {
    STORAGE_PHASE.set(PHASE.get());
}

/// Tells apart what lies between two storage barriers of the thread's workgroup. Plain barriers do not change it.
pub fn storage() -> u64 {
    STORAGE_PHASE.get()
}
