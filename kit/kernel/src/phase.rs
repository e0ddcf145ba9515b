//! The phases of the thread's workgroup: a phase lies between two barriers.

extern crate std;

use core::cell::{Cell, RefCell};
use core::panic::Location;
use std::format;
use std::string::String;

use glam::UVec3;

use crate::running::{self, unlinear};

std::thread_local! {
    /// Number of barriers and workgroups so far. Between two of them is a phase.
    static PHASE: Cell<u64> = const { Cell::new(1) };
    /// Number of invocations in the workgroup, per axis.
    static SIZE: Cell<UVec3> = const { Cell::new(UVec3::ONE) };
    /// The phase in which the workgroup began.
    static FIRST_PHASE: Cell<u64> = const { Cell::new(1) };
    /// The phase that began with the last storage barrier.
    static STORAGE_PHASE: Cell<u64> = const { Cell::new(1) };
    /// The first conflict of a phase in workgroup memory.
    static CONFLICT: RefCell<Option<String>> = const { RefCell::new(None) };
}

/// Begins a workgroup of this size.
pub fn begin(size: UVec3) {
    FIRST_PHASE.set(PHASE.get());
    SIZE.set(size);
    CONFLICT.set(None);
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

/// Records that an invocation uses workgroup memory wrongly. The workgroup fails at the end of the phase: only then
/// is it known whether the cause is a barrier that some invocations have not reached.
pub fn conflict(reason: &str, at: &'static Location<'static>) {
    CONFLICT.with_borrow_mut(|conflict| {
        conflict.get_or_insert_with(|| match running::current() {
            Some(place) => format!("{reason}, at {at}, in {place}"),
            None => {
                let invocation = unlinear(running::invocation().into(), size());
                format!("{reason}, at {at}, in invocation {invocation} of the workgroup")
            }
        });
    });
}

/// The first conflict since the last call.
pub fn take_conflict() -> Option<String> {
    CONFLICT.take()
}
