//! Makes integers of the `bool`s in workgroup memory: through naga, an NVIDIA H200 reads `false` there, whatever was written.

use std::collections::{BTreeMap, BTreeSet};

use anyhow::{Context, Result};
use rspirv::dr::{Instruction, Module, Operand};
use rspirv::spirv::{Op, StorageClass};

use crate::declarations::merge_types;

/// Widens single values and arrays. A value is 1 or 0.
pub fn widen(module: &mut Module) -> Result<()> {
    let mut bound = module.header.as_ref().context("the module has no header")?.bound;
    let mut id = || {
        bound += 1;
        bound - 1
    };
    let new = Instruction::new;
    let [word, zero, one] = [id(), id(), id()];
    let mut wide = BTreeMap::new();
    let mut declared = vec![
        new(Op::TypeInt, None, Some(word), [32, 0].map(Operand::LiteralBit32).into()),
        new(Op::Constant, Some(word), Some(zero), vec![Operand::LiteralBit32(0)]),
        new(Op::Constant, Some(word), Some(one), vec![Operand::LiteralBit32(1)]),
    ];
    for of in &module.types_global_values {
        match (of.class.opcode, of.result_id, &of.operands[..]) {
            (Op::TypeBool, Some(boolean), _) => {
                wide.insert(boolean, word);
            }
            (Op::TypeArray, Some(array), [Operand::IdRef(element), len])
                if wide.contains_key(element) =>
            {
                let widened = id();
                let operands = vec![Operand::IdRef(wide[element]), len.clone()];
                declared.push(new(Op::TypeArray, None, Some(widened), operands));
                wide.insert(array, widened);
            }
            _ => {}
        }
    }
    let mut pointers = BTreeSet::new();
    for of in &mut module.types_global_values {
        if let (
            Op::TypePointer,
            Some(pointer),
            [Operand::StorageClass(StorageClass::Workgroup), Operand::IdRef(to)],
        ) = (of.class.opcode, of.result_id, &mut of.operands[..])
            && let Some(widened) = wide.get(to)
        {
            *to = *widened;
            pointers.insert(pointer);
        }
    }
    if pointers.is_empty() {
        return Ok(());
    }
    let is_place = |of: &&Instruction| of.result_type.is_some_and(|of| pointers.contains(&of));
    let places: BTreeSet<_> =
        module.all_inst_iter().filter(is_place).filter_map(|of| of.result_id).collect();
    for block in module.functions.iter_mut().flat_map(|function| &mut function.blocks) {
        let mut written = Vec::with_capacity(block.instructions.len());
        for mut of in block.instructions.drain(..) {
            match (of.class.opcode, &mut of.operands[..]) {
                (Op::Load, [Operand::IdRef(place), ..]) if places.contains(place) => {
                    let loaded = id();
                    let operands = [loaded, zero].map(Operand::IdRef).into();
                    written.push(new(Op::Load, Some(word), Some(loaded), of.operands));
                    written.push(new(Op::INotEqual, of.result_type, of.result_id, operands));
                }
                (Op::Store, [Operand::IdRef(place), Operand::IdRef(value), ..])
                    if places.contains(place) =>
                {
                    let chosen = id();
                    let operands = [*value, one, zero].map(Operand::IdRef).into();
                    written.push(new(Op::Select, Some(word), Some(chosen), operands));
                    *value = chosen;
                    written.push(of);
                }
                _ => written.push(of),
            }
        }
        block.instructions = written;
    }
    module.types_global_values.extend(declared);
    merge_types(module);
    if let Some(header) = &mut module.header {
        header.bound = bound;
    }
    Ok(())
}
