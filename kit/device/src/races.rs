//! Finds data races between invocations: their results would depend on which one comes first.

use std::sync::atomic::{AtomicU32, AtomicU64, Ordering};

use glam::UVec3;
use organza_kernel::memory::{AccessMonitor, Touch};
use organza_kernel::running::{self, unlinear};
use organza_kernel::{BindingInfo, SharedInfo};

/// Monitors an array of workgroup memory: between two barriers, only the invocation that writes an element may read it.
///
/// The invocations of a workgroup take turns on one thread; atomics are here for the trait's sake.
pub struct WorkgroupMemory {
    name: &'static str,
    size: UVec3,
    barriers: AtomicU32,
    elements: Vec<Element>,
}

/// Who touched an element last, and between which barriers: two of the readers, and the writer.
#[derive(Default)]
struct Element {
    writer: AtomicU64,
    readers: [AtomicU64; 2],
}

impl WorkgroupMemory {
    pub fn new(info: &SharedInfo, size: UVec3) -> Self {
        let elements = (0..info.len).map(|_| Element::default()).collect();
        Self { name: info.name, size, barriers: AtomicU32::new(0), elements }
    }

    /// The workgroup has passed a barrier.
    pub fn pass_barrier(&self) {
        self.barriers.fetch_add(1, Ordering::Relaxed);
    }

    /// The invocation that runs now, as it is written into an element: never 0.
    fn stamp(&self) -> u64 {
        let invocation = 1 + running::invocation();
        u64::from(self.barriers.load(Ordering::Relaxed)) << 32 | u64::from(invocation)
    }

    /// The invocation that left a stamp, if it was another one and there was no barrier in between.
    fn other(&self, stamp: u64, own: u64) -> Option<UVec3> {
        let conflict = stamp != 0 && stamp != own && stamp >> 32 == own >> 32;
        conflict.then(|| unlinear(u64::from(stamp as u32 - 1), self.size))
    }

    fn read(&self, index: u32, element: &Element, own: u64) -> Result<(), String> {
        let name = self.name;
        let writer = element.writer.load(Ordering::Relaxed);
        if writer == 0 {
            return Err(format!(
                "reads element {index} of `{name}`, which no invocation has written"
            ));
        }
        if let Some(other) = self.other(writer, own) {
            return Err(format!(
                "reads element {index} of `{name}`, which invocation {other} of the workgroup has written, and no \
                 barrier lies between"
            ));
        }
        let first = element.readers[0].load(Ordering::Relaxed);
        let slot = usize::from(self.other(first, own).is_some());
        element.readers[slot].store(own, Ordering::Relaxed);
        Ok(())
    }

    fn write(&self, index: u32, element: &Element, own: u64) -> Result<(), String> {
        let name = self.name;
        let touched = [(&element.writer, "written"), (&element.readers[0], "read")];
        for (stamp, how) in touched.into_iter().chain([(&element.readers[1], "read")]) {
            if let Some(other) = self.other(stamp.load(Ordering::Relaxed), own) {
                return Err(format!(
                    "writes element {index} of `{name}`, which invocation {other} of the workgroup has {how}, and no \
                     barrier lies between"
                ));
            }
        }
        element.writer.store(own, Ordering::Relaxed);
        Ok(())
    }
}

impl AccessMonitor for WorkgroupMemory {
    fn touch(&self, index: u32, touch: Touch) -> Result<(), String> {
        let (element, own) = (&self.elements[index as usize], self.stamp());
        match touch {
            Touch::Read => self.read(index, element, own),
            Touch::Write | Touch::Atomic | Touch::Serial => self.write(index, element, own),
        }
    }
}

/// Monitors a storage buffer during one dispatch: no barrier orders what different invocations do to it.
pub struct Races {
    name: &'static str,
    invocations: UVec3,
    /// Whether the workgroups of one z run on one thread (`z_serial`).
    layers: bool,
    elements: Vec<Touched>,
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

impl Races {
    /// `invocations` are those of the dispatch, along each axis.
    pub fn new(info: &BindingInfo, bytes: usize, invocations: UVec3, layers: bool) -> Self {
        let len = bytes / info.element_bytes as usize;
        let elements = (0..len).map(|_| Touched::default()).collect();
        Self { name: info.name, invocations, layers, elements }
    }

    /// Whether two writers' marks let each other be: both change an element atomically, on the CPU too.
    fn agree(&self, own: u64, other: u64) -> bool {
        let layer = |mark| unlinear(who(mark) - 1, self.invocations).z;
        let atomic = own & other & ATOMIC != 0;
        atomic && ((own | other) & SERIAL == 0 || self.layers && layer(own) == layer(other))
    }

    fn conflict(&self, index: u32, does: &str, mark: u64, did: &str) -> String {
        let who = match who(mark) {
            MANY => "other invocations have".to_owned(),
            who => {
                format!("invocation {} of the dispatch has", unlinear(who - 1, self.invocations))
            }
        };
        let name = self.name;
        format!("{does} element {index} of `{name}`, which {who} {did} in the same dispatch")
    }
}

impl AccessMonitor for Races {
    // who comes second sees the first: each leaves its own mark before it looks for the other's
    fn touch(&self, index: u32, touch: Touch) -> Result<(), String> {
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
                true => Err(self.conflict(index, "reads", writer, "written")),
                false => Ok(()),
            };
        }
        let (does, mark) = match touch {
            Touch::Serial => ("adds, for its z alone, to", own | ATOMIC | SERIAL),
            Touch::Atomic => ("atomically changes", own | ATOMIC),
            Touch::Read | Touch::Write => ("writes", own),
        };
        let writer = element.writer.swap(mark, Ordering::SeqCst);
        if is_other(writer) && !self.agree(mark, writer) {
            return Err(self.conflict(index, does, writer, "written"));
        }
        let reader = element.reader.load(Ordering::SeqCst);
        match is_other(reader) {
            true => Err(self.conflict(index, does, reader, "read")),
            false => Ok(()),
        }
    }
}

/// The inverse of [`unlinear`].
fn linear(at: UVec3, size: UVec3) -> u64 {
    let [x, y, z] = at.to_array().map(u64::from);
    x + u64::from(size.x) * (y + u64::from(size.y) * z)
}
