//! Makes infinity and NaN of integers: naga refuses them as constants, and so do browsers.
//!
//! A browser also computes what it can from constants. So the bits go through a variable.

use std::collections::HashMap;

use rspirv::dr::{Builder, Instruction, Module, Operand};
use rspirv::spirv::{Op, StorageClass, Word};

use crate::declarations::rename;

/// Replaces constants that are infinite or NaN, and vectors of them.
pub fn replace(module: &mut Module) {
    let mut builder = Builder::new_from_module(std::mem::take(module));
    let [float, word] = [builder.type_float(32, None), builder.type_int(32, 0)];
    let pointer = builder.type_pointer(None, StorageClass::Function, word);
    let mut functions = std::mem::take(&mut builder.module_mut().functions);
    let constants = builder.module_ref().types_global_values.clone();
    for function in &mut functions {
        let mut names = HashMap::new();
        let mut variables = Vec::new();
        let mut values = Vec::new();
        // what a vector consists of is declared before it
        for constant in &constants {
            let kind = constant.result_type;
            match (constant.class.opcode, &constant.operands[..]) {
                (Op::Constant, &[Operand::LiteralBit32(bits)])
                    if kind == Some(float) && !f32::from_bits(bits).is_finite() =>
                {
                    let literal = builder.constant_bit32(word, bits);
                    let [variable, loaded, value] = [(); 3].map(|()| builder.id());
                    let first = Operand::StorageClass(StorageClass::Function);
                    let first = vec![first, Operand::IdRef(literal)];
                    let [load, cast] = [variable, loaded].map(|id| vec![Operand::IdRef(id)]);
                    let new = Instruction::new;
                    variables.push(new(Op::Variable, Some(pointer), Some(variable), first));
                    values.push(new(Op::Load, Some(word), Some(loaded), load));
                    values.push(new(Op::Bitcast, kind, Some(value), cast));
                }
                (Op::ConstantComposite, operands)
                    if operands.iter().any(|of| is_renamed(of, &names)) =>
                {
                    let operands = operands.to_vec();
                    let vector = Op::CompositeConstruct;
                    let mut vector = Instruction::new(vector, kind, Some(builder.id()), operands);
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
    builder.module_mut().functions = functions;
    *module = builder.module();
}

fn is_renamed(operand: &Operand, names: &HashMap<Word, Word>) -> bool {
    operand.id_ref_any().is_some_and(|id| names.contains_key(&id))
}
