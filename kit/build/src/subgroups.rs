//! What modules with operations of subgroups need, and others must not have.

use anyhow::{Context, Result};
use rspirv::dr::{Instruction, Module, Operand};
use rspirv::spirv::{BuiltIn, Capability, Decoration, Op, Word};

use crate::capabilities;

/// What operations and built-ins of subgroups need.
const CAPABILITIES: [Capability; 2] =
    [Capability::GroupNonUniform, Capability::GroupNonUniformArithmetic];

/// The operations that kernels use.
const OPERATIONS: [Op; 2] = [Op::GroupNonUniformIAdd, Op::GroupNonUniformUMax];

/// Makes a module one that devices and naga take.
pub fn lower(module: &mut Module) -> Result<()> {
    if !uses_subgroups(module) {
        capabilities::forget(module, &CAPABILITIES);
    }
    copy_arguments(module)
}

fn uses_subgroups(module: &Module) -> bool {
    let blocks = module.functions.iter().flat_map(|function| &function.blocks);
    let mut code = blocks.flat_map(|block| &block.instructions);
    let is_built_in = |annotation: &Instruction| {
        annotation.operands[1..]
            == [Operand::Decoration(Decoration::BuiltIn), Operand::BuiltIn(BuiltIn::SubgroupId)]
    };
    code.any(|instruction| OPERATIONS.contains(&instruction.class.opcode))
        || module.annotations.iter().any(is_built_in)
}

/// Has every operation take a copy of its argument, made right before it: naga's reader panics where the argument comes
/// from another block, such as a loop before.
fn copy_arguments(module: &mut Module) -> Result<()> {
    let header = module.header.as_mut().context("the module has no header")?;
    let blocks = module.functions.iter_mut().flat_map(|function| &mut function.blocks);
    for block in blocks {
        let mut instructions = Vec::with_capacity(block.instructions.len());
        for mut instruction in std::mem::take(&mut block.instructions) {
            if OPERATIONS.contains(&instruction.class.opcode) {
                let copy = header.bound;
                header.bound += 1;
                instructions.push(copy_of(&mut instruction, copy)?);
            }
            instructions.push(instruction);
        }
        block.instructions = instructions;
    }
    Ok(())
}

/// Gives an operation, whose last operand is its argument, a copy of it.
fn copy_of(operation: &mut Instruction, copy: Word) -> Result<Instruction> {
    let argument = operation.operands.last_mut().context("an operation has an argument")?;
    let value = std::mem::replace(argument, Operand::IdRef(copy));
    Ok(Instruction::new(Op::CopyObject, operation.result_type, Some(copy), vec![value]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use rspirv::dr::Builder;
    use rspirv::spirv::{FunctionControl, GroupOperation};

    /// A function that adds up ones, in the subgroup or not at all.
    fn module(operation: bool) -> Module {
        let mut b = Builder::new();
        b.capability(Capability::Shader);
        CAPABILITIES.into_iter().for_each(|capability| b.capability(capability));
        let (void, number) = (b.type_void(), b.type_int(32, 0));
        let (one, scope) = (b.constant_bit32(number, 1), b.constant_bit32(number, 3));
        let function = b.type_function(void, vec![]);
        b.begin_function(void, None, FunctionControl::NONE, function).unwrap();
        b.begin_block(None).unwrap();
        if operation {
            let reduce = GroupOperation::Reduce;
            b.group_non_uniform_i_add(number, None, scope, reduce, one, None).unwrap();
        }
        b.ret().unwrap();
        b.end_function().unwrap();
        b.module()
    }

    #[test]
    fn a_module_without_operations_needs_no_capability() {
        let mut module = module(false);
        lower(&mut module).unwrap();
        assert_eq!(module.capabilities.len(), 1);
        assert_eq!(module.capabilities[0].operands, [Operand::Capability(Capability::Shader)]);
    }

    #[test]
    fn an_operation_takes_a_copy() {
        let mut module = module(true);
        let bound = module.header.as_ref().unwrap().bound;
        lower(&mut module).unwrap();
        assert_eq!(module.capabilities.len(), 3);
        let [copy, operation, _] = &module.functions[0].blocks[0].instructions[..] else {
            panic!("a copy, an operation and a return");
        };
        assert_eq!(copy.class.opcode, Op::CopyObject);
        assert_eq!(copy.result_id, Some(bound));
        assert_eq!(operation.operands.last(), Some(&Operand::IdRef(bound)));
        assert_eq!(module.header.unwrap().bound, bound + 1);
    }
}
