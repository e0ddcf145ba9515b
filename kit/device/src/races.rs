//! Finds data races between invocations: their results would depend on which one comes first. And reads of what nothing was
//! written to.

use std::panic::Location;
use std::sync::atomic::{AtomicU64, Ordering};

use glam::UVec3;
use organza_kernel::BindingInfo;
use organza_kernel::memory::{AccessMonitor, Touch};
use organza_kernel::running::{self, unlinear};

use crate::written::Written;

/// Monitors what is only read: parts of the buffer may be unwritten.
pub struct Reads<'a> {
    written: Elements<'a>,
}

impl<'a> Reads<'a> {
    /// `begin` is the binding's first byte in the buffer.
    pub fn new(info: &BindingInfo, written: &'a Written, begin: usize) -> Self {
        let bytes = info.element_bytes as usize;
        Self { written: Elements { written, begin, bytes } }
    }
}

impl AccessMonitor for Reads<'_> {
    fn touch(
        &self,
        name: &str,
        index: u32,
        _: Touch,
        _: &'static Location<'static>,
    ) -> Result<(), String> {
        match self.written.has(index) {
            true => Ok(()),
            false => Err(unwritten("reads", index, name)),
        }
    }
}

/// Which elements of a binding were written.
struct Elements<'a> {
    written: &'a Written,
    begin: usize,
    bytes: usize,
}

impl Elements<'_> {
    fn range(&self, index: u32) -> std::ops::Range<usize> {
        let first = self.begin + index as usize * self.bytes;
        first..first + self.bytes
    }

    fn has(&self, index: u32) -> bool {
        self.written.has(self.range(index))
    }

    fn set(&self, index: u32) {
        self.written.set(self.range(index), true);
    }
}

fn unwritten(does: &str, index: u32, name: &str) -> String {
    format!("{does} element {index} of `{name}`, which nothing has written")
}

/// Monitors a storage buffer during one dispatch: no barrier orders what different invocations do to it.
pub struct Races<'a> {
    invocations: UVec3,
    /// Whether the workgroups of one z run on one thread (`z_serial`).
    layers: bool,
    elements: Vec<Touched>,
    /// Where parts of the buffer may be unwritten.
    written: Option<Elements<'a>>,
}

/// Who wrote an element last, and one who read it.
#[derive(Default)]
struct Touched {
    writer: AtomicU64,
    reader: AtomicU64,
}

/// Marks a writer that did so atomically: atomics do not disturb each other.
const ATOMIC: u64 = 1 << 63;

/// With `ATOMIC`, marks a writer that does not disturb others of the same z.
const SERIAL: u64 = 1 << 62;

/// Stands for several readers.
const MANY: u64 = SERIAL - 1;

/// Who left a mark.
const fn who(mark: u64) -> u64 {
    mark & !(ATOMIC | SERIAL)
}

impl<'a> Races<'a> {
    /// `invocations` are those of the dispatch, along each axis; `begin` is the binding's first byte in the buffer.
    pub fn new(
        info: &BindingInfo,
        bytes: usize,
        invocations: UVec3,
        layers: bool,
        written: Option<&'a Written>,
        begin: usize,
    ) -> Self {
        let element = info.element_bytes as usize;
        let elements = (0..bytes / element).map(|_| Touched::default()).collect();
        let written = written.map(|written| Elements { written, begin, bytes: element });
        Self { invocations, layers, elements, written }
    }

    fn is_written(&self, index: u32) -> bool {
        self.written.as_ref().is_none_or(|written| written.has(index))
    }

    /// Whether two writers' marks let each other be: both change an element atomically, on the CPU too.
    fn agree(&self, own: u64, other: u64) -> bool {
        let layer = |mark| unlinear(who(mark) - 1, self.invocations).z;
        let atomic = own & other & ATOMIC != 0;
        atomic && ((own | other) & SERIAL == 0 || self.layers && layer(own) == layer(other))
    }

    fn conflict(&self, name: &str, index: u32, does: &str, mark: u64, did: &str) -> String {
        let who = match who(mark) {
            MANY => "other invocations have".to_owned(),
            who => {
                format!("invocation {} of the dispatch has", unlinear(who - 1, self.invocations))
            }
        };
        format!("{does} element {index} of `{name}`, which {who} {did} in the same dispatch")
    }
}

impl AccessMonitor for Races<'_> {
    // who comes second sees the first: each leaves its own mark before it looks for the other's
    fn touch(
        &self,
        name: &str,
        index: u32,
        touch: Touch,
        _: &'static Location<'static>,
    ) -> Result<(), String> {
        let Some(place) = running::current() else { return Ok(()) };
        let element = &self.elements[index as usize];
        let own = 1 + linear(place.id.global(), self.invocations);
        let is_other = |mark: u64| mark != 0 && who(mark) != own;
        if touch == Touch::Read {
            let before =
                element.reader.compare_exchange(0, own, Ordering::SeqCst, Ordering::SeqCst);
            if before.is_err_and(is_other) {
                element.reader.store(MANY, Ordering::SeqCst);
            }
            let writer = element.writer.load(Ordering::SeqCst);
            return match is_other(writer) {
                true => Err(self.conflict(name, index, "reads", writer, "written")),
                // no other invocation has written it, or wants to
                false => match self.is_written(index) {
                    true => Ok(()),
                    false => Err(unwritten("reads", index, name)),
                },
            };
        }
        let (does, mark) = match touch {
            Touch::Serial => ("adds, for its z alone, to", own | ATOMIC | SERIAL),
            Touch::Atomic | Touch::Store => ("atomically changes", own | ATOMIC),
            Touch::Read | Touch::Write => ("writes", own),
        };
        if matches!(touch, Touch::Atomic | Touch::Serial) && !self.is_written(index) {
            return Err(unwritten(does, index, name));
        }
        let writer = element.writer.swap(mark, Ordering::SeqCst);
        if is_other(writer) && !self.agree(mark, writer) {
            return Err(self.conflict(name, index, does, writer, "written"));
        }
        let reader = element.reader.load(Ordering::SeqCst);
        if is_other(reader) {
            return Err(self.conflict(name, index, does, reader, "read"));
        }
        if let Some(written) = &self.written {
            written.set(index);
        }
        Ok(())
    }
}

/// The inverse of [`unlinear`].
fn linear(at: UVec3, size: UVec3) -> u64 {
    let [x, y, z] = at.to_array().map(u64::from);
    x + u64::from(size.x) * (y + u64::from(size.y) * z)
}
