//! What went wrong in the memory of the thread's workgroup.

extern crate std;

use core::cell::RefCell;
use core::panic::Location;
use std::format;
use std::string::String;

use crate::phase::size;
use crate::running::{self, unlinear};

std::thread_local! {
    /// The first conflict of a phase in workgroup memory.
    static CONFLICT: RefCell<Option<String>> = const { RefCell::new(None) };
}

/// Records that an invocation uses workgroup memory wrongly. The workgroup fails at the end of the phase: only then
/// is it known whether the cause is a barrier that some invocations have not reached.
pub fn note(reason: &str, at: &'static Location<'static>) {
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
pub fn take() -> Option<String> {
    CONFLICT.take()
}
