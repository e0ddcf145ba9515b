//! Makes a loop end where it decides to.

use std::collections::HashMap;

use rspirv::dr::{Function, Instruction, Operand};
use rspirv::spirv::{Op, Word};

use crate::declarations::rename;

use super::exits::{Exit, Path};
use super::{Loop, block, block_mut, find, id, label, sources, targets, terminator};

/// A branch to the block after the loop.
struct Edge {
    from: Word,
    /// Number of exits on its path, the last join first.
    exits: usize,
    /// Whether the loop ends at the first of these exits, and not after it.
    ends: bool,
}

/// A value that a join chooses, resolved at each edge.
struct Chosen {
    value: Word,
    kind: Option<Word>,
    at_edges: Vec<Word>,
    /// The value in an iteration that does not end the loop.
    carried: Word,
}

/// Rewrites a loop; `bound` is the first free id. Returns the ids that were removed from the function.
pub fn apply(function: &mut Function, cycle: &Loop, path: &Path, bound: &mut Word) -> Vec<Word> {
    let edges = edges(function, path);
    let chosen = chosen(function, path, &edges);
    let mut unreached: Vec<Word> = path.exits.iter().map(|exit| exit.join).collect();
    rewrite_phis(function, cycle, &chosen, &edges);
    for exit in &path.exits {
        if is_empty(function, exit) {
            unreached.push(exit.side);
        }
        leave(function, cycle, exit);
    }
    branch_back(function, cycle, path);
    function.blocks.retain(|block| !unreached.contains(&label(block)));
    carry_out(function, cycle, &chosen, &edges, bound);
    join_head(function, cycle);
    chosen.iter().map(|chosen| chosen.value).collect()
}

/// Whether the side that ends the loop does nothing.
fn is_empty(function: &Function, exit: &Exit) -> bool {
    let only = exit.from == exit.side && block(function, exit.side).instructions.len() == 1;
    exit.side == exit.join || only
}

/// The paths out of the loop that go through its joins.
fn edges(function: &Function, path: &Path) -> Vec<Edge> {
    let mut edges = Vec::new();
    for (at, exit) in path.exits.iter().enumerate() {
        let from = if is_empty(function, exit) { exit.decider } else { exit.from };
        edges.push(Edge { from, exits: at + 1, ends: true });
    }
    if path.condition.is_some() {
        edges.push(Edge { from: path.from, exits: path.exits.len(), ends: false });
    }
    edges
}

/// Resolves a join's `value` on a path through the joins, backward from the last of them.
fn value_at(function: &Function, path: &Path, value: Word, edge: &Edge) -> Word {
    let mut value = value;
    for (at, exit) in path.exits[..edge.exits].iter().enumerate() {
        let ends = edge.ends && at + 1 == edge.exits;
        let onward = path.exits.get(at + 1).map_or(path.from, |next| next.join);
        value = exit.value(function, value, ends, if ends { exit.from } else { onward });
    }
    value
}

fn chosen(function: &Function, path: &Path, edges: &[Edge]) -> Vec<Chosen> {
    let onward = Edge { from: path.from, exits: path.exits.len(), ends: false };
    let mut all = Vec::new();
    for exit in &path.exits {
        for instruction in &block(function, exit.join).instructions {
            let Some(value) = instruction.result_id else { continue };
            all.push(Chosen {
                value,
                kind: instruction.result_type,
                at_edges: edges.iter().map(|edge| value_at(function, path, value, edge)).collect(),
                carried: value_at(function, path, value, &onward),
            });
        }
    }
    all
}

/// Gives the loop's first block the values that an iteration carries, and the block after the loop one value for each
/// edge.
fn rewrite_phis(function: &mut Function, cycle: &Loop, chosen: &[Chosen], edges: &[Edge]) {
    let find = |value: Word| chosen.iter().find(|chosen| chosen.value == value);
    for phi in phis(function, cycle.head) {
        for pair in phi.operands.chunks_exact_mut(2) {
            if pair[1] == Operand::IdRef(cycle.next) {
                let value = pair[0].id_ref_any().expect("a phi chooses between ids");
                pair[0] = Operand::IdRef(find(value).map_or(value, |chosen| chosen.carried));
            }
        }
    }
    for phi in phis(function, cycle.end) {
        let old = std::mem::take(&mut phi.operands);
        for pair in old.chunks_exact(2) {
            if pair[1] != Operand::IdRef(cycle.next) {
                phi.operands.extend_from_slice(pair);
                continue;
            }
            let value = pair[0].id_ref_any().expect("a phi chooses between ids");
            for (at, edge) in edges.iter().enumerate() {
                let value = find(value).map_or(value, |chosen| chosen.at_edges[at]);
                phi.operands.extend([Operand::IdRef(value), Operand::IdRef(edge.from)]);
            }
        }
    }
}

fn phis(function: &mut Function, of: Word) -> impl Iterator<Item = &mut Instruction> {
    block_mut(function, of).instructions.iter_mut().filter(|i| i.class.opcode == Op::Phi)
}

/// Makes the ending side of a condition leave the loop.
fn leave(function: &mut Function, cycle: &Loop, exit: &Exit) {
    let empty = is_empty(function, exit);
    if !empty {
        retarget(function, exit.from, exit.join, cycle.end);
    }
    let decider = block_mut(function, exit.decider);
    let merge = decider.instructions.len() - 2;
    if empty || exit.onward == exit.join {
        // A side that leaves the loop directly needs no merge block.
        decider.instructions.remove(merge);
    } else {
        decider.instructions[merge].operands[0] = Operand::IdRef(exit.onward);
    }
    if empty {
        retarget(function, exit.decider, exit.side, cycle.end);
    }
}

/// Ends the path of an iteration at the last block.
fn branch_back(function: &mut Function, cycle: &Loop, path: &Path) {
    let join = path.exits.last().expect("there is an exit").join;
    match path.condition {
        None => retarget(function, path.from, join, cycle.next),
        Some(condition) => {
            let (yes, no) =
                if cycle.again { (cycle.next, cycle.end) } else { (cycle.end, cycle.next) };
            let operands = [condition, yes, no].map(Operand::IdRef).to_vec();
            let branch = Instruction::new(Op::BranchConditional, None, None, operands);
            set_terminator(function, path.from, branch);
        }
    }
    let back = vec![Operand::IdRef(cycle.head)];
    set_terminator(function, cycle.next, Instruction::new(Op::Branch, None, None, back));
}

fn set_terminator(function: &mut Function, of: Word, branch: Instruction) {
    let last = block_mut(function, of).instructions.last_mut();
    *last.expect("a block ends in a branch") = branch;
}

fn retarget(function: &mut Function, of: Word, old: Word, new: Word) {
    let last = block_mut(function, of).instructions.last_mut();
    for operand in &mut last.expect("a block ends in a branch").operands {
        if *operand == Operand::IdRef(old) {
            *operand = Operand::IdRef(new);
        }
    }
}

/// Moves a join's choice to the loop's end, for code after the loop.
fn carry_out(
    function: &mut Function,
    cycle: &Loop,
    chosen: &[Chosen],
    edges: &[Edge],
    bound: &mut Word,
) {
    let mut new = HashMap::new();
    for chosen in chosen {
        let use_of = |operand: &Operand| *operand == Operand::IdRef(chosen.value);
        let mut all = function.blocks.iter().flat_map(|block| &block.instructions);
        if !all.any(|instruction| instruction.operands.iter().any(use_of)) {
            continue;
        }
        if chosen.at_edges.iter().all(|value| *value == chosen.at_edges[0]) {
            new.insert(chosen.value, chosen.at_edges[0]);
            continue;
        }
        let pairs = chosen.at_edges.iter().zip(edges);
        let operands = pairs.flat_map(|(&value, edge)| [value, edge.from]).map(Operand::IdRef);
        let phi = Instruction::new(Op::Phi, chosen.kind, Some(*bound), operands.collect());
        block_mut(function, cycle.end).instructions.insert(0, phi);
        new.insert(chosen.value, *bound);
        *bound += 1;
    }
    rename(function.all_inst_iter_mut(), &new);
}

/// If the loop can end before it does anything else, moves that decision to its first block. This is the form of a
/// `while`.
fn join_head(function: &mut Function, cycle: &Loop) {
    let head = block(function, cycle.head);
    let (Op::Branch, first) = (terminator(head).class.opcode, id(terminator(head), 0)) else {
        return;
    };
    let test = block(function, first);
    let merges = [Op::Phi, Op::SelectionMerge, Op::LoopMerge];
    if merges.iter().any(|&opcode| find(test, opcode).is_some())
        || terminator(test).class.opcode != Op::BranchConditional
        || !targets(terminator(test)).contains(&cycle.end)
        || sources(function, first) != [cycle.head]
    {
        return;
    }
    let mut moved = std::mem::take(&mut block_mut(function, first).instructions);
    function.blocks.retain(|block| label(block) != first);
    let head = block_mut(function, cycle.head);
    let merge = head.instructions.len() - 2;
    let branch = moved.pop().expect("a block ends in a branch");
    head.instructions.pop();
    head.instructions.splice(merge..merge, moved);
    head.instructions.push(branch);
    let phis = function.all_inst_iter_mut().filter(|i| i.class.opcode == Op::Phi);
    rename(phis, &HashMap::from([(first, cycle.head)]));
}
