//! Numbers the ids of a module in order of appearance.
//!
//! The compiler numbers the ids of all kernels together. Without this, a change in one kernel would give others new
//! numbers.

use std::collections::HashMap;

use rspirv::dr::{Module, Operand};
use rspirv::spirv::Word;

/// Numbers all ids, starting at 1.
pub fn renumber(module: &mut Module) {
    let mut numbers: HashMap<Word, Word> = HashMap::new();
    let mut number = |id: &mut Word| {
        let next = numbers.len() as Word + 1;
        *id = *numbers.entry(*id).or_insert(next);
    };
    for instruction in module.all_inst_iter_mut() {
        instruction.result_type.iter_mut().for_each(&mut number);
        instruction.result_id.iter_mut().for_each(&mut number);
        for operand in &mut instruction.operands {
            match operand {
                Operand::IdRef(id) | Operand::IdScope(id) | Operand::IdMemorySemantics(id) => {
                    number(id);
                }
                _ => {}
            }
        }
    }
    let bound = numbers.len() as Word + 1;
    if let Some(header) = &mut module.header {
        header.bound = bound;
    }
}
