//! Where the invocations of a workgroup wait for each other, and the path on which each came there.

extern crate std;

use core::cell::RefCell;
use core::mem::{self, ManuallyDrop};
use core::panic::Location;
use core::{fmt, ptr};
use std::borrow::ToOwned;
use std::format;
use std::string::String;
use std::vec::Vec;

use glam::{UVec3, UVec4};

use crate::running::unlinear;
use crate::subgroup::operation::Operation;

/// What an invocation waits at: a barrier, or an operation of its subgroup. It is small, because each wait copies it.
#[derive(Clone, Copy)]
pub struct Stop {
    /// Place in the source.
    pub at: &'static Location<'static>,
    /// The branches and loops around it. The waiting coroutine owns it, so it lives until that is resumed or dropped.
    pub path: &'static [Step],
}

/// What an invocation gives to an operation of its subgroup, and then the result.
#[derive(Clone, Copy)]
pub struct Meeting {
    pub operation: Operation,
    /// What [`Operation::of`] takes or gives.
    pub value: UVec4,
}

/// A stop, and the subgroup's operation there, if it is no barrier; `None` for an invocation that has ended.
type Place = Option<(Stop, Option<Operation>)>;

impl PartialEq for Stop {
    fn eq(&self, other: &Self) -> bool {
        // mostly it is one place in memory: its text takes longer to compare than an invocation to wait
        (ptr::eq(self.at, other.at) || self.at == other.at) && self.path == other.path
    }
}

/// Runs the operations that subgroups wait at: their lanes go on, with the results. Returns whether there was one.
pub fn subgroups_meet(
    size: UVec3,
    subgroup_size: u32,
    stops: &mut [Option<Stop>],
    meetings: &mut [Option<Meeting>],
) -> Result<bool, String> {
    let mut met = false;
    let lanes = subgroup_size as usize;
    let subgroups = stops.chunks_mut(lanes).zip(meetings.chunks_mut(lanes));
    for (subgroup, (stops, meetings)) in subgroups.enumerate() {
        if meetings.iter().all(Option::is_none) {
            continue;
        }
        let place = |(stop, meeting): (&Option<Stop>, &Option<Meeting>)| -> Place {
            stop.map(|stop| (stop, meeting.map(|meeting| meeting.operation)))
        };
        let places: Vec<_> = stops.iter().zip(&*meetings).map(place).collect();
        let Some((stop, Some(operation))) =
            places[0].filter(|_| places.iter().all(|of| *of == places[0]))
        else {
            let reason = divergence("a subgroup's operation", &places, subgroup * lanes, size);
            return Err(format!("{reason}, in a subgroup of {subgroup_size}"));
        };
        let given: Vec<_> = meetings.iter().flatten().map(|meeting| meeting.value).collect();
        for (lane, meeting) in meetings.iter_mut().enumerate() {
            let value = operation.of(lane, &given).map_err(|asked| {
                let place = unlinear((subgroup * lanes + lane) as u64, size);
                let present = given.len();
                format!(
                    "invocation {place} asks for the value of lane {asked} of its subgroup, which has {present} lanes, at {}",
                    stop.at
                )
            })?;
            *meeting = Some(Meeting { operation, value });
        }
        stops.fill(None);
        met = true;
    }
    Ok(met)
}

/// Fails if not all invocations wait at one barrier, and not all have ended.
pub fn barrier_is_reached(size: UVec3, stops: &[Option<Stop>]) -> Result<(), String> {
    if stops.iter().all(|stop| *stop == stops[0]) {
        return Ok(());
    }
    let places: Vec<_> = stops.iter().map(|stop| stop.map(|stop| (stop, None))).collect();
    Err(divergence("a barrier", &places, 0, size))
}

/// Lists which invocations wait at which barrier or operation, if they do not all wait at the same one. `begin` is the first one's index.
fn divergence(what: &str, places: &[Place], begin: usize, size: UVec3) -> String {
    let (first, others): (Vec<_>, Vec<_>) =
        (0..places.len()).partition(|&index| places[index] == places[0]);
    let ways = [places[first[0]], places[others[0]]];
    let side = |indices: &[usize]| {
        let does = match places[indices[0]] {
            Some((stop, operation)) => {
                let kind = if operation.is_some() { "operation" } else { "barrier" };
                format!("waits at the {kind} of {}{}", stop.at, way(stop, ways))
            }
            None => "has ended".to_owned(),
        };
        side([begin + indices[0], indices.len()], size, &does)
    };
    let first = side(&first);
    let others = side(&others);
    format!("{what} in divergent control flow: {first}, while {others}")
}

/// What some invocations do, in a message: the index of the first, and their number.
pub fn side([first, count]: [usize; 2], size: UVec3, does: &str) -> String {
    let place = unlinear(first as u64, size);
    match count - 1 {
        0 => format!("invocation {place} {does}"),
        more => format!("invocation {place} (with {more} more) {does}"),
    }
}

/// How an invocation came to its stop, if two came to the same one on different paths.
fn way(own: Stop, ways: [Place; 2]) -> String {
    let [Some((first, _)), Some((second, _))] = ways else { return String::new() };
    if first.at != second.at {
        return String::new();
    }
    let same = first.path.iter().zip(second.path).take_while(|(one, other)| one == other).count();
    own.path.get(same).map_or_else(String::new, |step| format!(" {step}"))
}

// The path of an invocation to a barrier: the branches and the rounds of loops that it is in.
//
// A barrier is reached by all invocations of a workgroup on the same path, or by none. The place of the barrier alone does not tell: a
// helper can be called from two branches, and a loop can reach its barrier in another round. In debug builds, `#[kernel]` and
// `#[loops]` note both.

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
    /// The path of the thread's invocation. A thread-local value without a destructor is reached without a call, and [`take_path`] frees it.
    static PATH: RefCell<ManuallyDrop<Vec<Step>>> = const { RefCell::new(ManuallyDrop::new(Vec::new())) };
}

/// Takes the path of the thread's invocation. The next one starts without any.
pub(crate) fn take_path() -> Vec<Step> {
    PATH.with_borrow_mut(|path| mem::take(&mut **path))
}

/// Sets the path of the thread's invocation.
pub(crate) fn set_path(path: Vec<Step>) {
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
