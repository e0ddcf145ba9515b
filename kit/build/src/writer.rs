//! Writes the instructions of a module anew, for passes that put some in the place of others.

use rspirv::dr::{Instruction, Module, Operand};
use rspirv::spirv::{Op, Word};

/// The instructions of a block, as they are written.
#[derive(Default)]
pub struct Writer {
    bound: Word,
    pub instructions: Vec<Instruction>,
}

impl Writer {
    /// Adds an instruction, and returns its result.
    pub fn add(&mut self, op: Op, kind: Word, operands: &[Word]) -> Word {
        let id = self.bound;
        self.bound += 1;
        self.push(op, kind, id, operands);
        id
    }

    /// Adds an instruction with this result.
    pub fn push(&mut self, op: Op, kind: Word, id: Word, operands: &[Word]) {
        let operands = operands.iter().copied().map(Operand::IdRef).collect();
        self.instructions.push(Instruction::new(op, Some(kind), Some(id), operands));
    }
}

/// Writes every block of a module anew, one instruction after another.
pub fn rewrite(module: &mut Module, mut write: impl FnMut(&mut Writer, Instruction)) {
    let Some(header) = &mut module.header else { return };
    let mut writer = Writer { bound: header.bound, ..Writer::default() };
    for block in module.functions.iter_mut().flat_map(|function| &mut function.blocks) {
        block.instructions.drain(..).for_each(|instruction| write(&mut writer, instruction));
        block.instructions.append(&mut writer.instructions);
    }
    header.bound = writer.bound;
}
