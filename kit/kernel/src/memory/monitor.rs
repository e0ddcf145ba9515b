//! Who sees what invocations do to memory.

extern crate std;

use core::panic::Location;
use std::string::String;

/// What an invocation does to an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Touch {
    /// Reads it.
    Read,
    /// Writes it.
    Write,
    /// Changes it atomically, or reads it atomically.
    Atomic,
    /// Writes it atomically, whatever was there.
    Store,
    /// Changes it atomically on a GPU. On the CPU no workgroup of another z changes it.
    Serial,
}

/// Sees every access to a binding that several invocations may write.
pub trait AccessMonitor: Sync {
    /// The current invocation touches an element of the buffer that the kernel calls `name`, at a place in the source.
    ///
    /// # Errors
    /// What is wrong with that.
    fn touch(
        &self,
        name: &str,
        index: u32,
        touch: Touch,
        at: &'static Location<'static>,
    ) -> Result<(), String>;

    /// What was written before the last barrier counts as unwritten: see [`Shared::begin_round`](super::Shared::begin_round).
    fn begin_round(&self) {}
}
