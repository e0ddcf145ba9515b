//! Where the invocations of a workgroup wait for each other.

extern crate std;

use core::panic::Location;
use std::borrow::ToOwned;
use std::format;
use std::string::String;
use std::vec::Vec;

use glam::{UVec3, UVec4};

use crate::path::Step;
use crate::running::unlinear;
use crate::subgroup::Operation;

/// What an invocation waits at: a barrier, or an operation of its subgroup.
#[derive(Clone, Copy, PartialEq)]
pub struct Stop {
    /// Place in the source.
    pub at: &'static Location<'static>,
    /// The branches and loops around it. The waiting coroutine owns it, so it lives until that is resumed or dropped.
    pub path: &'static [Step],
    /// The subgroup's operation; `None` at a barrier.
    pub operation: Option<Operation>,
}

/// Runs the operations that subgroups wait at: their lanes go on, with the results. Returns whether there was one.
pub fn subgroups_meet(
    subgroup_size: u32,
    size: UVec3,
    stops: &mut [Option<Stop>],
    values: &mut [UVec4],
) -> Result<bool, String> {
    let mut met = false;
    let lanes = subgroup_size as usize;
    for (subgroup, (stops, values)) in
        stops.chunks_mut(lanes).zip(values.chunks_mut(lanes)).enumerate()
    {
        let Some(operation) = stops.iter().flatten().find_map(|stop| stop.operation) else {
            continue;
        };
        if stops.iter().any(|stop| *stop != stops[0]) {
            let reason = divergence("a subgroup's operation", stops, subgroup * lanes, size);
            return Err(format!("{reason}, in a subgroup of {subgroup_size}"));
        }
        let bits: Vec<_> = values.iter().map(|value| value.x).collect();
        values.fill(operation.of(&bits));
        stops.fill(None);
        met = true;
    }
    Ok(met)
}

/// Lists which invocations wait at which barrier or operation, if they do not all wait at the same one. `begin` is the first one's index.
pub fn divergence(what: &str, stops: &[Option<Stop>], begin: usize, size: UVec3) -> String {
    let (first, others): (Vec<_>, Vec<_>) =
        (0..stops.len()).partition(|&index| stops[index] == stops[0]);
    let ways = [stops[first[0]], stops[others[0]]];
    let side = |indices: &[usize]| {
        let place = unlinear((begin + indices[0]) as u64, size);
        let does = match stops[indices[0]] {
            Some(stop) => {
                let kind = if stop.operation.is_some() { "operation" } else { "barrier" };
                format!("waits at the {kind} of {}{}", stop.at, way(stop, ways))
            }
            None => "has ended".to_owned(),
        };
        match indices.len() - 1 {
            0 => format!("invocation {place} {does}"),
            more => format!("invocation {place} (with {more} more) {does}"),
        }
    };
    let first = side(&first);
    let others = side(&others);
    format!("{what} in divergent control flow: {first}, while {others}")
}

/// How an invocation came to its stop, if two came to the same one on different paths.
fn way(own: Stop, ways: [Option<Stop>; 2]) -> String {
    let [Some(first), Some(second)] = ways else { return String::new() };
    if first.at != second.at {
        return String::new();
    }
    let same = first.path.iter().zip(second.path).take_while(|(one, other)| one == other).count();
    own.path.get(same).map_or_else(String::new, |step| format!(" {step}"))
}
