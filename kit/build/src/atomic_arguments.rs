//! Copies arguments of atomics and of subgroups' operations that come from another block.
//!
//! naga's SPIR-V reader uses an atomic's argument directly, even if it was computed in a loop that has ended. It then
//! refuses the module: "NotInScope". On such an argument of a subgroup's operation, it panics. For every other instruction, it carries such a value out of the loop in a
//! variable. So this pass copies the argument first, next to the instruction.

use std::collections::HashMap;

use rspirv::dr::{Instruction, Module, Operand};
use rspirv::spirv::{Op, Word};

use crate::rewrite::rewrite;

/// Copies the arguments of all these instructions that were computed in another block.
pub fn copy(module: &mut Module) {
    // the block that computes each value; parameters and constants are in scope everywhere
    let mut computed = HashMap::new();
    let blocks = module.functions.iter().flat_map(|function| &function.blocks);
    for (number, block) in blocks.enumerate() {
        let value = |of: &Instruction| Some((of.result_id?, (number, of.result_type?)));
        computed.extend(block.instructions.iter().filter_map(value));
    }
    rewrite(module, |writer, mut instruction| {
        for argument in arguments(&mut instruction) {
            if let Some(&(number, kind)) = computed.get(argument)
                && number != writer.block
            {
                *argument = writer.add(Op::CopyObject, kind, &[*argument]);
            }
        }
        writer.instructions.push(instruction);
    });
}

/// The arguments of an atomic, after its pointer, or of a subgroup's operation, after its scope.
fn arguments(instruction: &mut Instruction) -> impl Iterator<Item = &mut Word> {
    let name = instruction.class.opname;
    let is_meant = name.starts_with("Atomic") || name.starts_with("GroupNonUniform");
    let operands = instruction.operands.iter_mut().skip(1).filter(move |_| is_meant);
    operands.filter_map(|operand| match operand {
        Operand::IdRef(id) => Some(id),
        _ => None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lower::{bytes, count_fill};
    use rspirv::dr::Builder;
    use rspirv::spirv::{Capability, Decoration, GroupOperation, LoopControl, StorageClass};

    /// A kernel that adds `n` to a counter, which a loop has counted up to 3; or the sum of a subgroup's `n`.
    fn counted_in_a_loop(by_subgroup: bool) -> Module {
        let mut b = Builder::new();
        let uint = b.type_int(32, 0);
        let bool = b.type_bool();
        let block = b.type_struct([uint]);
        let storage = b.type_pointer(None, StorageClass::StorageBuffer, block);
        let element = b.type_pointer(None, StorageClass::StorageBuffer, uint);
        let counter = b.variable(storage, None, StorageClass::StorageBuffer, None);
        b.decorate(block, Decoration::Block, []);
        b.member_decorate(block, 0, Decoration::Offset, [Operand::LiteralBit32(0)]);
        b.decorate(counter, Decoration::DescriptorSet, [Operand::LiteralBit32(0)]);
        b.decorate(counter, Decoration::Binding, [Operand::LiteralBit32(0)]);
        let [zero, one, three] = [0, 1, 3].map(|value| b.constant_bit32(uint, value));
        count_fill(b, &[], |b| {
            let [entry, head, body, next, end, n, more] = [(); 7].map(|()| b.id());
            b.branch(entry).unwrap();
            b.begin_block(Some(entry)).unwrap();
            b.branch(head).unwrap();
            b.begin_block(Some(head)).unwrap();
            let before = b.phi(uint, None, [(zero, entry), (n, next)]).unwrap();
            b.loop_merge(end, next, LoopControl::NONE, []).unwrap();
            b.branch(body).unwrap();
            b.begin_block(Some(body)).unwrap();
            b.i_add(uint, Some(n), before, one).unwrap();
            b.u_less_than(bool, Some(more), n, three).unwrap();
            b.branch_conditional(more, next, end, []).unwrap();
            b.begin_block(Some(next)).unwrap();
            b.branch(head).unwrap();
            b.begin_block(Some(end)).unwrap();
            let at = b.access_chain(element, None, counter, [zero]).unwrap();
            if by_subgroup {
                b.capability(Capability::GroupNonUniformArithmetic);
                let sum = GroupOperation::Reduce;
                let sum = b.group_non_uniform_i_add(uint, None, three, sum, n, None);
                b.store(at, sum.unwrap(), None, []).unwrap();
            } else {
                b.atomic_i_add(uint, None, at, one, zero, n).unwrap();
            }
        })
    }

    /// Copies one value, after which naga takes the module.
    fn assert_copied(mut module: Module) {
        copy(&mut module);
        crate::validate::check(&bytes(&module)).unwrap();
        let count = |op| module.all_inst_iter().filter(|i| i.class.opcode == op).count();
        assert_eq!(count(Op::CopyObject), 1);
        // a second run finds nothing to copy
        let once = bytes(&module);
        copy(&mut module);
        assert_eq!(bytes(&module), once);
    }

    #[test]
    fn naga_takes_an_argument_that_comes_out_of_a_loop() {
        let module = counted_in_a_loop(false);
        let refused = crate::validate::check(&bytes(&module)).unwrap_err().to_string();
        assert!(refused.contains("NotInScope"), "naga takes it now: this pass can go: {refused}");
        assert_copied(module);
    }

    #[test]
    fn naga_panics_on_a_value_that_comes_out_of_a_loop() {
        let module = counted_in_a_loop(true);
        let check = || crate::validate::check(&bytes(&module));
        assert!(std::panic::catch_unwind(check).is_err(), "naga takes it now");
        assert_copied(module);
    }
}
