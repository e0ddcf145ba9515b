//! Makes infinity and NaN of integers: naga refuses them as constants, and so do browsers.
//!
//! A browser also computes what it can from constants. So the bits go through a variable.

use std::collections::HashMap;

use anyhow::{Context, Result};
use rspirv::dr::{Instruction, Module, Operand};
use rspirv::spirv::{Op, StorageClass, Word};

use crate::declarations::{merge_types, rename};

/// Replaces constants that are infinite or NaN, and vectors of them. Only what functions use is declared.
pub fn replace(module: &mut Module) -> Result<()> {
    let mut bound = module.header.as_ref().context("the module has no header")?.bound;
    let mut id = || {
        bound += 1;
        bound - 1
    };
    let [word, pointer] = [id(), id()];
    let integer = [32, 0].map(Operand::LiteralBit32);
    let in_function = || Operand::StorageClass(StorageClass::Function);
    let mut declared = vec![
        Instruction::new(Op::TypeInt, None, Some(word), integer.into()),
        Instruction::new(
            Op::TypePointer,
            None,
            Some(pointer),
            vec![in_function(), Operand::IdRef(word)],
        ),
    ];
    let types: HashMap<_, _> =
        module.types_global_values.iter().map(|of| (of.result_id, of.class.opcode)).collect();
    for function in &mut module.functions {
        let mut names = HashMap::new();
        let mut variables = Vec::new();
        let mut values = Vec::new();
        // what a vector consists of is declared before it
        for constant in &module.types_global_values {
            let kind = constant.result_type;
            match (constant.class.opcode, &constant.operands[..]) {
                (Op::Constant, &[Operand::LiteralBit32(bits)])
                    if types.get(&kind) == Some(&Op::TypeFloat)
                        && !f32::from_bits(bits).is_finite() =>
                {
                    let [literal, variable, loaded] = [id(), id(), id()];
                    let bits = Operand::LiteralBit32(bits);
                    let first = vec![in_function(), Operand::IdRef(literal)];
                    let [load, cast] = [variable, loaded].map(|id| vec![Operand::IdRef(id)]);
                    let new = Instruction::new;
                    declared.push(new(Op::Constant, Some(word), Some(literal), vec![bits]));
                    let pointer = Some(pointer);
                    variables.push(new(Op::Variable, pointer, Some(variable), first));
                    values.push(new(Op::Load, Some(word), Some(loaded), load));
                    values.push(new(Op::Bitcast, kind, Some(id()), cast));
                }
                (Op::ConstantComposite, operands)
                    if operands.iter().any(|of| is_renamed(of, &names)) =>
                {
                    let operands = operands.to_vec();
                    let vector = Op::CompositeConstruct;
                    let mut vector = Instruction::new(vector, kind, Some(id()), operands);
                    rename([&mut vector], &names);
                    values.push(vector);
                }
                _ => continue,
            }
            let value = values.last().and_then(|of| of.result_id);
            names.extend(constant.result_id.zip(value));
        }
        rename(function.all_inst_iter_mut(), &names);
        if let Some(first) = function.blocks.first_mut() {
            let is_variable = |of: &Instruction| of.class.opcode == Op::Variable;
            let end = first.instructions.iter().take_while(|of| is_variable(of)).count();
            first.instructions.splice(end..end, variables.into_iter().chain(values));
        }
    }
    if declared.len() > 2 {
        module.types_global_values.extend(declared);
        merge_types(module);
        if let Some(header) = &mut module.header {
            header.bound = bound;
        }
    }
    Ok(())
}

fn is_renamed(operand: &Operand, names: &HashMap<Word, Word>) -> bool {
    operand.id_ref_any().is_some_and(|id| names.contains_key(&id))
}
