//! Monitors of the accesses to memory.

extern crate std;

use core::panic::Location;
use std::string::String;

/// An access of an invocation to an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Touch {
    /// Reads it.
    Read,
    /// Writes it.
    Write,
    /// Changes it atomically, or reads it atomically.
    Atomic,
    /// Writes it atomically, independent of the old value.
    Store,
    /// Changes it atomically on a GPU. On the CPU, no workgroup with another z changes it.
    Serial,
}

/// Sees every access to a binding that several invocations may write.
pub trait AccessMonitor: Sync {
    /// Reports that the current invocation accesses an element of the buffer that the kernel calls `name`, at a place
    /// in the source.
    ///
    /// # Errors
    /// The reason, if the access is wrong.
    fn touch(
        &self,
        name: &str,
        index: u32,
        touch: Touch,
        at: &'static Location<'static>,
    ) -> Result<(), String>;

    /// Everything written before the last barrier counts as unwritten: see
    /// [`Shared::begin_round`](super::Shared::begin_round).
    fn begin_round(&self) {}
}
