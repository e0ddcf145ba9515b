//! Finds the places where a loop decides to end.

use rspirv::dr::{Block, Function, Instruction};
use rspirv::spirv::{Op, Word};

use super::{Constants, Loop, block, find, id, incoming, label, sources, targets, terminator};

/// A condition that decides whether a loop ends. One side ends it, the other goes on, and both meet at a join.
pub struct Exit {
    /// The block that branches on the condition.
    pub decider: Word,
    /// The value of the condition that ends the loop.
    ends_if: bool,
    /// The block where both sides meet. It only chooses between values of the two sides.
    pub join: Word,
    /// The first block of the side that ends the loop. If that side has no block, it is the join.
    pub side: Word,
    /// The block from which that side branches to the join.
    pub from: Word,
    /// The first block of the side that goes on.
    pub onward: Word,
}

impl Exit {
    /// Resolves `value` at the join, for control that comes from the block `from`. With `ends`, the loop ends there.
    pub fn value(&self, function: &Function, value: Word, ends: bool, from: Word) -> Word {
        let taken = if ends { self.ends_if } else { !self.ends_if };
        value_in(block(function, self.join), value, taken, from)
    }
}

/// Resolves `value` at a join whose condition was `taken`, for control that comes from the block `from`.
fn value_in(join: &Block, value: Word, taken: bool, from: Word) -> Word {
    let found = join.instructions.iter().find(|i| i.result_id == Some(value));
    match found {
        Some(phi) if phi.class.opcode == Op::Phi => incoming(phi, from).unwrap_or(value),
        Some(select) => value_in(join, id(select, if taken { 1 } else { 2 }), taken, from),
        None => value,
    }
}

/// The path of an iteration that does not end the loop, backward.
pub struct Path {
    /// Exits on the path, the last join first. Each exit is in the side of the previous exit that continues the loop.
    pub exits: Vec<Exit>,
    /// The block before the end of this path.
    pub from: Word,
    /// The condition for another iteration there; `None` if it is certain.
    pub condition: Option<Word>,
}

/// Follows a loop backward from its last block, through all joins at which one side ends the loop.
pub fn follow(function: &Function, cycle: &Loop, constants: &Constants) -> Path {
    let mut path = Path { exits: Vec::new(), from: cycle.next, condition: Some(cycle.condition) };
    let [from] = sources(function, cycle.next)[..] else { return path };
    path.from = from;
    while let Some(condition) = path.condition {
        let Some(step) = step(function, cycle, constants, path.from, condition) else { break };
        path.from = step.from;
        path.condition = step.condition;
        path.exits.push(step.exit);
    }
    path
}

/// One join further back.
struct Step {
    exit: Exit,
    from: Word,
    condition: Option<Word>,
}

fn step(
    function: &Function,
    cycle: &Loop,
    constants: &Constants,
    join: Word,
    condition: Word,
) -> Option<Step> {
    if sources(function, join).len() != 2 {
        return None;
    }
    let decider = function
        .blocks
        .iter()
        .find(|block| find(block, Op::SelectionMerge).is_some_and(|merge| id(merge, 0) == join))?;
    let branch = terminator(decider);
    if branch.class.opcode != Op::BranchConditional
        || !only_chooses(block(function, join), id(branch, 0))
    {
        return None;
    }
    let sides = [true, false].map(|taken| {
        let start = id(branch, if taken { 1 } else { 2 });
        let from = source_of_side(function, cycle, label(decider), start, join)?;
        let value = value_in(block(function, join), condition, taken, from);
        let known = if value == id(branch, 0) { Some(taken) } else { constants.value(value) };
        Some(Side { start, from, value, taken, ends: known.map(|known| known != cycle.again) })
    });
    let (ending, onward) = match sides {
        [Some(a), Some(b)] if a.ends == Some(true) && b.ends != Some(true) => (a, b),
        [Some(b), Some(a)] if a.ends == Some(true) && b.ends != Some(true) => (a, b),
        _ => return None,
    };
    // The decider's own branch has no room for a second condition.
    if onward.from == label(decider) && onward.ends.is_none() {
        return None;
    }
    Some(Step {
        exit: Exit {
            decider: label(decider),
            ends_if: ending.taken,
            join,
            side: ending.start,
            from: ending.from,
            onward: onward.start,
        },
        from: onward.from,
        condition: onward.ends.is_none().then_some(onward.value),
    })
}

/// One side of a condition.
struct Side {
    start: Word,
    from: Word,
    /// The condition for another iteration on this side.
    value: Word,
    /// The condition's value on this side.
    taken: bool,
    /// Whether this side ends the loop, if known.
    ends: Option<bool>,
}

/// Whether a join only chooses between the values of its two sides: with phis, or by their condition.
fn only_chooses(join: &Block, condition: Word) -> bool {
    let (last, choices) = join.instructions.split_last().expect("a block ends in a branch");
    let chooses = |choice: &Instruction| match choice.class.opcode {
        Op::Phi => true,
        Op::Select => id(choice, 0) == condition,
        _ => false,
    };
    last.class.opcode == Op::Branch && choices.iter().all(chooses)
}

/// The block from which one side of a condition branches to its join.
fn source_of_side(
    function: &Function,
    cycle: &Loop,
    decider: Word,
    start: Word,
    join: Word,
) -> Option<Word> {
    if start == join {
        return Some(decider);
    }
    // A side can also leave the loop directly.
    let outside = [cycle.head, cycle.next, cycle.end];
    let mut seen = vec![start];
    let mut at = 0;
    while let Some(&inside) = seen.get(at) {
        let further = targets(terminator(block(function, inside)));
        if further.contains(&join) {
            return Some(inside);
        }
        for target in further {
            if !seen.contains(&target) && !outside.contains(&target) {
                seen.push(target);
            }
        }
        at += 1;
    }
    None
}
