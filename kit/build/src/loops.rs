//! Gives loops the form that compilers in drivers expect.
//!
//! Rust-GPU writes every loop as `do { body } while (again)`. A `while` then has its condition twice: in its body,
//! around everything it does, and again at its end. In between, phis choose between the body's values and undefined
//! values. Drivers keep two copies of all values that such a loop carries, and copy one to the other in each
//! iteration. With this pass, the condition leaves the loop itself:
//!
//! ```text
//! head: phis; branch test                         head: phis
//! test: c = ..; c ? body : else, merging at join        c = ..; c ? body : end
//! body: ..; branch join                           body: ..; branch next
//! else: branch join
//! join: phis (body's value, undefined); branch next
//! next: c ? head : end                            next: branch head
//! end:  ..                                        end:  ..
//! ```
//!
//! A `break` or a second condition becomes another way to `end`, and the path through the loop has one join less. All
//! computations and their order stay the same.
//!
//! The kernel `loops` of `kit/language` has loops of all these forms.

mod exits;
mod rewrite;

use anyhow::{Context, Result};
use rspirv::dr::{Block, Function, Instruction, Module, Operand};
use rspirv::spirv::{Op, Word};

/// A loop as Rust-GPU writes it: its last block branches on a value of its body.
struct Loop {
    /// The block with the phis, in which each iteration starts.
    head: Word,
    /// The block that branches back to the head, and does nothing else.
    next: Word,
    /// The block after the loop.
    end: Word,
    /// The condition of the last block's branch.
    condition: Word,
    /// The value of the condition that starts another iteration.
    again: bool,
}

/// Makes all loops of a module end at their conditions.
pub fn end_at_conditions(module: &mut Module) -> Result<()> {
    let constants = Constants::from_module(module);
    let header = module.header.as_mut().context("the module has no header")?;
    let mut gone = Vec::new();
    for function in &mut module.functions {
        let heads = function.blocks.iter().filter(|block| find(block, Op::LoopMerge).is_some());
        for head in heads.map(label).collect::<Vec<_>>() {
            let Some(cycle) = Loop::at(function, head) else { continue };
            let path = exits::follow(function, &cycle, &constants);
            if !path.exits.is_empty() {
                gone.extend(rewrite::apply(function, &cycle, &path, &mut header.bound));
            }
        }
    }
    // names and decorations of removed phis
    let names = |i: &Instruction| matches!(i.operands[0], Operand::IdRef(id) if gone.contains(&id));
    module.annotations.retain(|annotation| !names(annotation));
    module.debug_names.retain(|name| !names(name));
    Ok(())
}

impl Loop {
    /// The loop with this head, if its last block only branches on a condition.
    fn at(function: &Function, head: Word) -> Option<Self> {
        let merge = find(block(function, head), Op::LoopMerge)?;
        let end = id(merge, 0);
        let next = id(merge, 1);
        let [branch] = block(function, next).instructions.as_slice() else { return None };
        if branch.class.opcode != Op::BranchConditional {
            return None;
        }
        let again = id(branch, 1) == head;
        (targets(branch).contains(&head) && targets(branch).contains(&end)).then_some(Self {
            head,
            next,
            end,
            condition: id(branch, 0),
            again,
        })
    }
}

/// The module's constants of type bool. A module may have several of each value.
struct Constants(Vec<(Word, bool)>);

impl Constants {
    fn from_module(module: &Module) -> Self {
        let values = module.types_global_values.iter().filter_map(|i| match i.class.opcode {
            Op::ConstantTrue => Some((i.result_id?, true)),
            Op::ConstantFalse => Some((i.result_id?, false)),
            _ => None,
        });
        Self(values.collect())
    }

    fn value(&self, id: Word) -> Option<bool> {
        self.0.iter().find(|(constant, _)| *constant == id).map(|(_, value)| *value)
    }
}

fn label(block: &Block) -> Word {
    block.label.as_ref().and_then(|label| label.result_id).expect("a block has a label")
}

fn block(function: &Function, id: Word) -> &Block {
    let found = function.blocks.iter().find(|block| label(block) == id);
    found.expect("a label belongs to a block")
}

fn block_mut(function: &mut Function, id: Word) -> &mut Block {
    let found = function.blocks.iter_mut().find(|block| label(block) == id);
    found.expect("a label belongs to a block")
}

/// The first instruction of a kind.
fn find(block: &Block, opcode: Op) -> Option<&Instruction> {
    block.instructions.iter().find(|instruction| instruction.class.opcode == opcode)
}

fn terminator(block: &Block) -> &Instruction {
    block.instructions.last().expect("a block ends in a branch")
}

/// An operand that must be an id.
fn id(instruction: &Instruction, at: usize) -> Word {
    instruction.operands[at].id_ref_any().expect("an operand of this kind is an id")
}

/// The possible targets of a branch.
fn targets(branch: &Instruction) -> Vec<Word> {
    let conditions = match branch.class.opcode {
        Op::Branch => 0,
        Op::BranchConditional | Op::Switch => 1,
        _ => return Vec::new(),
    };
    branch.operands.iter().skip(conditions).filter_map(Operand::id_ref_any).collect()
}

/// The blocks that can branch to a block.
fn sources(function: &Function, to: Word) -> Vec<Word> {
    let all = function.blocks.iter().filter(|block| targets(terminator(block)).contains(&to));
    all.map(label).collect()
}

/// The value of a phi, for control that comes from a block.
fn incoming(phi: &Instruction, from: Word) -> Option<Word> {
    phi.operands.chunks_exact(2).find(|pair| pair[1] == Operand::IdRef(from))?[0].id_ref_any()
}
