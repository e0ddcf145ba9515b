//! The path of an invocation to a barrier: the branches and the rounds of loops that it is in.
//!
//! A barrier is reached by all invocations of a workgroup on the same path, or by none. The place of the barrier alone does not tell: a
//! helper can be called from two branches, and a loop can reach its barrier in another round. In debug builds, `#[kernel]` and
//! `#[loops]` note both.

extern crate std;

use core::cell::RefCell;
use core::fmt;
use core::mem::{self, ManuallyDrop};
use core::panic::Location;
use std::vec::Vec;

/// A branch or a loop that an invocation is in.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) struct Step {
    place: &'static Location<'static>,
    /// The round of a loop, counted from 1; 0 for a branch.
    round: u32,
}

impl fmt::Display for Step {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.round {
            0 => write!(f, "in the branch of {}", self.place),
            round => write!(f, "in round {round} of the loop of {}", self.place),
        }
    }
}

std::thread_local! {
    /// The path of the thread's invocation. A thread-local value without a destructor is reached without a call, and [`take`] frees it.
    static PATH: RefCell<ManuallyDrop<Vec<Step>>> = const { RefCell::new(ManuallyDrop::new(Vec::new())) };
}

/// Takes the path of the thread's invocation. The next one starts without any.
pub(crate) fn take() -> Vec<Step> {
    PATH.with_borrow_mut(|path| mem::take(&mut **path))
}

/// Sets the path of the thread's invocation.
pub(crate) fn set(path: Vec<Step>) {
    PATH.with_borrow_mut(|current| **current = path);
}

/// While it lives, its invocation is in a branch or a loop. It does nothing in a function without barriers.
pub struct Scope {
    /// Number of steps of the path before.
    before: Option<usize>,
}

impl Scope {
    /// The branch or the loop of the caller's place begins.
    #[inline(always)]
    #[track_caller]
    pub fn new(has_barriers: bool) -> Self {
        if has_barriers { Self::enter(Location::caller()) } else { Self { before: None } }
    }

    fn enter(place: &'static Location<'static>) -> Self {
        PATH.with_borrow_mut(|path| {
            path.push(Step { place, round: 0 });
            Self { before: Some(path.len() - 1) }
        })
    }

    /// A round of the loop begins.
    #[inline(always)]
    pub fn round(&mut self) {
        if let Some(before) = self.before {
            PATH.with_borrow_mut(|path| path[before].round += 1);
        }
    }
}

impl Drop for Scope {
    #[inline(always)]
    fn drop(&mut self) {
        if let Some(before) = self.before {
            PATH.with_borrow_mut(|path| path.truncate(before));
        }
    }
}
