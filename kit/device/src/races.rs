//! Finds data races between invocations, whose results would depend on their order. Also finds reads of unwritten
//! elements.

use std::panic::Location;
use std::ptr;
use std::sync::Arc;
use std::sync::atomic::{AtomicPtr, AtomicU64, Ordering};

use glam::UVec3;
use muslin_kernel::invocation::Invocation;
use muslin_kernel::kernel::{Access, CpuBinding};
use muslin_kernel::memory::{AccessMonitor, Touch};
use muslin_kernel::running::{self, unlinear};
use muslin_kernel::{BindingInfo, KernelInfo};

use crate::buffer::{Memory, RawBuffer};
use crate::cpu_memory::{Ticket, Writer, Written};
use crate::job::Workgroups;

/// Watches the accesses to a binding.
pub enum Monitor<'a> {
    Written(Races<'a>),
    Read(Elements<'a>),
}

impl Monitor<'_> {
    pub fn as_dyn(&self) -> &dyn AccessMonitor {
        match self {
            Self::Written(races) => races,
            Self::Read(elements) => elements,
        }
    }
}

/// A monitor for every binding that is written, or that may have unwritten elements.
pub fn monitors<'a>(
    info: &KernelInfo,
    bindings: &[CpuBinding<'_>],
    buffers: &[&'a RawBuffer],
    workgroups: Workgroups,
) -> Vec<Option<Monitor<'a>>> {
    let mut buffers = buffers.iter();
    let ticket = Ticket::default();
    let monitor = |(binding_info, binding): (&BindingInfo, &CpuBinding<'_>)| {
        if binding_info.access == Access::Uniform {
            return None;
        }
        let buffer = buffers.next()?;
        let (written, begin): (Option<&Written>, _) = match &buffer.memory {
            Memory::Cpu(memory) => (memory.written(), buffer.begin as usize),
            _ => (None, 0),
        };
        let elements = written.map(|written| Elements::new(binding_info, written, begin));
        if binding_info.access != Access::Write {
            return elements.map(Monitor::Read);
        }
        if let Some(written) = written {
            let [kernel, name] = [info.name, binding_info.name];
            written.set_writer(Writer { kernel, name, ticket: Arc::clone(&ticket) });
        }
        let len = binding.bytes / binding_info.element_bytes as usize;
        Some(Monitor::Written(Races::new(info, len, workgroups, elements, Arc::clone(&ticket))))
    };
    info.bindings.iter().zip(bindings).map(monitor).collect()
}

/// The written elements of a binding.
pub struct Elements<'a> {
    written: &'a Written,
    begin: usize,
    bytes: usize,
}

impl<'a> Elements<'a> {
    /// `begin` is the offset of the binding's first byte in the buffer.
    pub fn new(info: &BindingInfo, written: &'a Written, begin: usize) -> Self {
        Self { written, begin, bytes: info.element_bytes as usize }
    }

    fn range(&self, index: u32) -> std::ops::Range<usize> {
        let first = self.begin + index as usize * self.bytes;
        first..first + self.bytes
    }

    fn has(&self, index: u32) -> bool {
        self.written.has(self.range(index))
    }

    fn set(&self, index: u32, is_additional: bool) {
        match is_additional {
            true => self.written.set_additional(self.range(index)),
            false => self.written.set(self.range(index), true),
        }
    }
}

/// Monitors a binding that is only read: parts of the buffer may be unwritten.
impl AccessMonitor for Elements<'_> {
    fn touch(
        &self,
        name: &&str,
        index: u32,
        _: Touch,
        _: &'static Location<'static>,
    ) -> Result<(), String> {
        match self.has(index) {
            true => Ok(()),
            false => Err(unwritten("reads", index, name)),
        }
    }
}

fn unwritten(does: &str, index: u32, name: &str) -> String {
    format!("{does} element {index} of `{name}`, which nothing has written")
}

/// Monitors a storage buffer during one dispatch: only storage barriers order the accesses of different invocations, and only of
/// one workgroup.
pub struct Races<'a> {
    workgroups: UVec3,
    /// Invocations of a workgroup, along each axis.
    size: UVec3,
    /// Whether the kernel has barriers.
    waits: bool,
    /// Whether workgroups with the same z run on one thread (`z_serial`).
    layers: bool,
    elements: Vec<Touched>,
    /// The written elements, if parts of the buffer may be unwritten.
    written: Option<Elements<'a>>,
    ticket: Ticket,
}

/// The invocations that have accessed an element in this dispatch, for each kind of access: none, or the first one,
/// with marks. An access of one kind does not hide others' accesses of another kind. Where only one workgroup has accessed it, the
/// accesses before its last storage barrier are forgotten when a new one comes.
#[derive(Default)]
struct Touched {
    writer: AtomicU64,
    atomic: AtomicU64,
    reader: AtomicU64,
    /// The place of the last write in the source.
    place: AtomicPtr<Location<'static>>,
}

impl Touched {
    /// Notes the place of a write: the last one is kept.
    fn note(&self, at: &'static Location<'static>) {
        self.place.store(ptr::from_ref(at).cast_mut(), Ordering::Relaxed);
    }

    fn place(&self) -> Option<&'static Location<'static>> {
        // SAFETY: null, or a place that `note` was given
        unsafe { self.place.load(Ordering::Relaxed).as_ref() }
    }
}

/// Marks accesses of several workgroups.
const WORKGROUPS: u64 = 1 << 63;

/// Marks accesses of several invocations, between two storage barriers of their workgroup.
const SEVERAL: u64 = 1 << 62;

/// Marks atomics that do not conflict with others of the same z.
const SERIAL: u64 = 1 << 61;

/// Number of bits of a mark for the invocation: a CPU would take days for more. They are counted from 1, workgroup by workgroup.
const INVOCATION_BITS: u32 = 42;

/// The bits of a mark between: the storage phase, modulo 2^19. A workgroup with more barriers takes too many iterations.
const PHASE: u64 = SERIAL - (1 << INVOCATION_BITS);

/// The invocation that left a mark first.
const fn who(mark: u64) -> u64 {
    mark & ((1 << INVOCATION_BITS) - 1)
}

impl<'a> Races<'a> {
    /// Monitors `len` elements. `written` are those that count as written.
    pub fn new(
        info: &KernelInfo,
        len: usize,
        workgroups: Workgroups,
        written: Option<Elements<'a>>,
        ticket: Ticket,
    ) -> Self {
        Self {
            workgroups: workgroups.all.into(),
            size: info.workgroup_size.into(),
            waits: info.run.waiting().is_some(),
            layers: info.z_serial,
            elements: (0..len).map(|_| Touched::default()).collect(),
            written,
            ticket,
        }
    }

    /// The mark of an invocation that runs.
    fn mark(&self, id: Invocation) -> u64 {
        let workgroup = linear(id.workgroup, self.workgroups);
        let first = workgroup * u64::from(self.size.element_product());
        let phase = running::storage_phase() << INVOCATION_BITS & PHASE;
        phase | (1 + first + linear(id.local, self.size))
    }

    /// The workgroup of a mark.
    fn workgroup(&self, mark: u64) -> u64 {
        (who(mark) - 1) / u64::from(self.size.element_product())
    }

    /// The place of a mark's invocation in the dispatch.
    fn place(&self, mark: u64) -> UVec3 {
        let workgroup = unlinear(self.workgroup(mark), self.workgroups);
        let local = (who(mark) - 1) % u64::from(self.size.element_product());
        workgroup * self.size + unlinear(local, self.size)
    }

    /// Adds a mark, and returns the previous content.
    fn leave(&self, slot: &AtomicU64, own: u64) -> u64 {
        let merge = |before: u64| {
            let both = before & (own | !SERIAL);
            match before {
                0 => own,
                // it conflicts with any other access already
                _ if before & WORKGROUPS != 0 => both,
                _ if who(before) == who(own) && before & PHASE == own & PHASE => both,
                _ if self.workgroup(before) != self.workgroup(own) => both | WORKGROUPS,
                // a storage barrier lies between
                _ if before & PHASE != own & PHASE => own,
                _ => both | SEVERAL,
            }
        };
        // the closure always returns a value
        slot.fetch_update(Ordering::SeqCst, Ordering::SeqCst, |before| Some(merge(before)))
            .unwrap_or(0)
    }

    /// Whether others than `own` have left a mark, and no storage barrier lies between.
    fn meets(&self, own: u64, found: u64) -> bool {
        let is_other = who(found) != who(own) || found & SEVERAL != 0;
        let is_now = found & PHASE == own & PHASE;
        found != 0 && (is_other && is_now || self.is_elsewhere(own, found))
    }

    /// Whether other workgroups have left a mark.
    fn is_elsewhere(&self, own: u64, found: u64) -> bool {
        found & WORKGROUPS != 0
            || who(found) != who(own) && self.workgroup(found) != self.workgroup(own)
    }

    fn is_written(&self, index: u32) -> bool {
        self.written.as_ref().is_none_or(|written| written.has(index))
    }

    /// Whether two atomics do not conflict, also on the CPU.
    fn agree(&self, own: u64, other: u64) -> bool {
        let layer = |mark| self.place(mark).z;
        (own | other) & SERIAL == 0
            || own & other & SERIAL != 0 && self.layers && layer(own) == layer(other)
    }

    fn conflict(&self, element: &str, does: &str, [own, found]: [u64; 2], did: &str) -> String {
        let who = match who(found) == who(own) {
            true => "other invocations have".to_owned(),
            false => format!("invocation {} of the dispatch has", self.place(found)),
        };
        let barrier = match self.is_elsewhere(own, found) {
            _ if !self.waits => "",
            true => ", and no barrier orders workgroups",
            false => ", and no storage barrier lies between",
        };
        format!("{does} {element}, which {who} {did} in the same dispatch{barrier}")
    }

    /// An error if the kernel has written NaN; `data` is the binding's.
    pub fn nan(&self, info: &BindingInfo, data: &[u8]) -> Option<String> {
        let element = info.element.rsplit("::").next().unwrap_or_default().trim();
        if !["f32", "Vec2", "Vec3", "Vec4"].contains(&element) {
            return None;
        }
        let elements = data.chunks_exact(info.element_bytes as usize).zip(&self.elements);
        let (index, _) = elements.enumerate().find(|(_, (bytes, touched))| {
            touched.writer.load(Ordering::SeqCst) != 0 && is_nan(bytes)
        })?;
        let name = info.name;
        Some(format!("writes NaN to element {index} of `{name}`{}", self.writer(index)))
    }

    /// Whether elements were changed atomically.
    pub fn has_atomics(&self) -> bool {
        self.elements.iter().any(|touched| touched.atomic.load(Ordering::SeqCst) != 0)
    }

    /// Where an element was written, and by whom: the end of a message.
    pub fn writer(&self, index: usize) -> String {
        let Some(touched) = self.elements.get(index) else { return String::new() };
        let marks = [&touched.writer, &touched.atomic].map(|slot| slot.load(Ordering::SeqCst));
        let Some(mark) = marks.into_iter().find(|mark| *mark != 0) else { return String::new() };
        let place = touched.place().map_or_else(String::new, |at| format!(", at {at}"));
        format!("{place}, in invocation {} of the dispatch", self.place(mark))
    }
}

/// Whether one of the `f32` in some bytes is NaN.
fn is_nan(bytes: &[u8]) -> bool {
    let (numbers, _) = bytes.as_chunks::<4>();
    numbers.iter().any(|number| f32::from_ne_bytes(*number).is_nan())
}

impl AccessMonitor for Races<'_> {
    // the second invocation sees the first, because each leaves its own mark before it looks for the other's
    fn touch(
        &self,
        name: &&str,
        index: u32,
        touch: Touch,
        at: &'static Location<'static>,
    ) -> Result<(), String> {
        let Some(place) = running::current() else { return Ok(()) };
        let touched = &self.elements[index as usize];
        let own = self.mark(place.id);
        let (does, slot, mark) = match touch {
            Touch::Read => ("reads", &touched.reader, own),
            Touch::Write => ("writes", &touched.writer, own),
            Touch::Atomic | Touch::Store => ("atomically changes", &touched.atomic, own),
            Touch::Serial => ("adds, for its z alone, to", &touched.atomic, own | SERIAL),
        };
        let before = self.leave(slot, mark);
        if touch != Touch::Read {
            touched.note(at);
        }
        let is_atomic = !matches!(touch, Touch::Read | Touch::Write);
        let others = [
            (&touched.writer, "written", true),
            (&touched.atomic, "atomically changed", !is_atomic || !self.agree(mark, before.max(1))),
            (&touched.reader, "read", touch != Touch::Read),
        ];
        for (slot, did, disturbs) in others {
            let found = slot.load(Ordering::SeqCst);
            if disturbs && self.meets(own, found) {
                let element = format!("element {index} of `{name}`");
                return Err(self.conflict(&element, does, [own, found], did));
            }
        }
        if !matches!(touch, Touch::Write | Touch::Store) && !self.is_written(index) {
            return Err(unwritten(does, index, name));
        }
        if is_atomic && place.is_additional {
            // the first one is kept
            let _ = self.ticket.set(at);
        }
        if let Some(written) = self.written.as_ref().filter(|_| touch != Touch::Read) {
            written.set(index, place.is_additional);
        }
        Ok(())
    }
}

/// The inverse of [`unlinear`].
fn linear(at: UVec3, size: UVec3) -> u64 {
    let [x, y, z] = at.to_array().map(u64::from);
    x + u64::from(size.x) * (y + u64::from(size.y) * z)
}
