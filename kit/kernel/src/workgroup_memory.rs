//! Watches workgroup memory: between two barriers, only the invocation that writes an element may read it.
//! Debug builds do so, and devices that check races: it takes most of the time of a kernel that hardly does anything else.

extern crate std;

use core::cell::RefCell;
use core::panic::Location;
use core::sync::atomic::{AtomicU64, Ordering};
use std::format;
use std::string::String;
use std::vec::Vec;

use glam::UVec3;

use crate::binding::SharedInfo;
use crate::conflict;
use crate::memory::{AccessMonitor, Touch};
use crate::phase;
use crate::running::{self, unlinear};

/// Number of bits in a stamp for the invocation, which is counted from 1.
const INVOCATION_BITS: u32 = 16;

/// A byte of workgroup memory before a kernel writes it: as floats it is NaN, and as indices it is out of range.
pub const UNWRITTEN: u8 = u8::MAX;

std::thread_local! {
    /// What watched the arrays of the thread's last workgroups.
    static SPARE: RefCell<Vec<WorkgroupMemory>> = const { RefCell::new(Vec::new()) };
}

/// What watches the arrays of a workgroup.
pub fn take(arrays: &[SharedInfo]) -> Vec<WorkgroupMemory> {
    let mut watches = SPARE.take();
    watches.resize_with(arrays.len(), || WorkgroupMemory::new(0));
    for (watch, array) in watches.iter_mut().zip(arrays) {
        // stamps of earlier workgroups have earlier phases
        watch.elements.resize_with(array.len as usize, Element::default);
    }
    watches
}

/// Keeps it for the next workgroup.
pub fn give_back(watches: Vec<WorkgroupMemory>) {
    SPARE.set(watches);
}

/// Watches an array of workgroup memory.
///
/// The invocations of a workgroup take turns on one thread. The fields are atomic only because the trait requires it.
pub struct WorkgroupMemory {
    elements: Vec<Element>,
    /// The phase in which the current round began. Earlier writes count as unwritten.
    round: AtomicU64,
}

/// The last accesses to an element, with their phases. If several invocations may make the same access in one phase,
/// two of them are kept, so that the one that asks does not hide another.
#[derive(Default)]
struct Element {
    writer: AtomicU64,
    atomics: [AtomicU64; 2],
    readers: [AtomicU64; 2],
}

impl Element {
    /// The stamps of its writes.
    fn changes(&self) -> impl Iterator<Item = u64> {
        self.atomics.iter().chain([&self.writer]).map(load)
    }
}

/// An access that may conflict with others to the same element in the same phase.
#[derive(Clone, Copy)]
enum Did {
    Written,
    Changed,
    Read,
}

impl Did {
    const fn as_str(self) -> &'static str {
        match self {
            Self::Written => "written",
            Self::Changed => "atomically changed",
            Self::Read => "read",
        }
    }
}

impl WorkgroupMemory {
    /// Watches an array of `len` elements.
    pub fn new(len: u32) -> Self {
        let elements = (0..len).map(|_| Element::default()).collect();
        Self { elements, round: AtomicU64::new(0) }
    }

    /// The running invocation and the phase, as stored in an element. It is never 0.
    #[inline(always)]
    fn stamp() -> u64 {
        phase::current() << INVOCATION_BITS | (1 + u64::from(running::invocation()))
    }

    /// The first phase whose writes count.
    #[inline(always)]
    fn begin(&self) -> u64 {
        phase::first().max(self.round.load(Ordering::Relaxed))
    }

    /// Whether nothing was written since the workgroup and the round began.
    fn is_unwritten(&self, element: &Element) -> bool {
        element.changes().all(|stamp| stamp >> INVOCATION_BITS < self.begin())
    }

    /// Looks whether an access is wrong, and records it.
    #[cold]
    #[inline(never)]
    fn look(
        &self,
        name: &&str,
        index: u32,
        touch: Touch,
        at: &'static Location<'static>,
    ) -> Result<(), String> {
        let element = &self.elements[index as usize];
        let own = Self::stamp();
        if let Some(fault) = self.fault(element, touch, own) {
            let does = match touch {
                Touch::Read => "reads",
                Touch::Write => "writes",
                Touch::Atomic | Touch::Store | Touch::Serial => "atomically changes",
            };
            conflict::note(&format!("{does} element {index} of `{name}`, {fault}"), at);
        }
        match touch {
            Touch::Read => leave(&element.readers, own),
            Touch::Write => element.writer.store(own, Ordering::Relaxed),
            Touch::Atomic | Touch::Store | Touch::Serial => leave(&element.atomics, own),
        }
        Ok(())
    }

    /// The error of an access to an element, if it is wrong.
    fn fault(&self, element: &Element, touch: Touch, own: u64) -> Option<String> {
        if !matches!(touch, Touch::Write | Touch::Store) && self.is_unwritten(element) {
            let before = element.changes().map(|stamp| stamp >> INVOCATION_BITS).max().unwrap_or(0);
            let when = if before >= phase::first() { "in this round" } else { "yet" };
            return Some(format!(
                "which no invocation has written {when}: is a write missing, or a barrier?"
            ));
        }
        let [first, second] = &element.atomics;
        let [reader, another] = &element.readers;
        let marks = [
            (&element.writer, Did::Written),
            (first, Did::Changed),
            (second, Did::Changed),
            (reader, Did::Read),
            (another, Did::Read),
        ];
        let (did, other) = marks.into_iter().find_map(|(stamp, did)| {
            let agree = match touch {
                Touch::Read => matches!(did, Did::Read),
                Touch::Atomic | Touch::Store | Touch::Serial => matches!(did, Did::Changed),
                Touch::Write => false,
            };
            if agree { None } else { Some((did, other(load(stamp), own)?)) }
        })?;
        Some(format!(
            "which invocation {other} of the workgroup has {}, and no barrier lies between",
            did.as_str()
        ))
    }
}

#[inline(always)]
fn load(stamp: &AtomicU64) -> u64 {
    stamp.load(Ordering::Relaxed)
}

/// The invocation that left a stamp, if it was another one in the same phase.
fn other(stamp: u64, own: u64) -> Option<UVec3> {
    let conflict = stamp != 0 && stamp != own && stamp >> INVOCATION_BITS == own >> INVOCATION_BITS;
    let invocation = (stamp & ((1 << INVOCATION_BITS) - 1)).wrapping_sub(1);
    conflict.then(|| unlinear(invocation, phase::size()))
}

/// Adds a stamp, and keeps one other invocation's.
#[inline(always)]
fn leave([last, before]: &[AtomicU64; 2], own: u64) {
    let found = load(last);
    if found != own {
        before.store(found, Ordering::Relaxed);
        last.store(own, Ordering::Relaxed);
    }
}

impl AccessMonitor for WorkgroupMemory {
    fn touch(
        &self,
        name: &&str,
        index: u32,
        touch: Touch,
        at: &'static Location<'static>,
    ) -> Result<(), String> {
        // nearly always, the phase has no other access yet: this takes less time than to look
        let Some(element) = self.elements.get(index as usize) else {
            unreachable!("a view checks it")
        };
        let own = Self::stamp();
        let phase = own & !((1 << INVOCATION_BITS) - 1);
        // of two accesses that are kept, the first one here is the later one
        let last = load(&element.writer).max(load(&element.atomics[0]));
        let reader = load(&element.readers[0]);
        match touch {
            Touch::Read if last < phase && last >= self.begin() << INVOCATION_BITS => {
                leave(&element.readers, own);
                Ok(())
            }
            Touch::Write
                if last < phase
                    && (reader < phase || reader == own && load(&element.readers[1]) < phase) =>
            {
                element.writer.store(own, Ordering::Relaxed);
                Ok(())
            }
            _ => self.look(name, index, touch, at),
        }
    }

    fn begin_round(&self) {
        self.round.store(phase::current(), Ordering::Relaxed);
    }
}
