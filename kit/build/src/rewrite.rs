//! Replaces instructions of a module, for the passes.

use rspirv::dr::{Instruction, Module, Operand};
use rspirv::spirv::{GlslStd450Op, Op, Word};

/// The instructions of a block, as they are written.
#[derive(Default)]
pub struct Writer {
    bound: Word,
    /// The number of the block among the blocks of all functions.
    pub block: usize,
    pub instructions: Vec<Instruction>,
}

impl Writer {
    /// A new id.
    pub fn id(&mut self) -> Word {
        self.bound += 1;
        self.bound - 1
    }

    /// Adds an instruction, and returns its result.
    pub fn add(&mut self, op: Op, kind: Word, operands: &[Word]) -> Word {
        let id = self.id();
        self.push(op, kind, id, operands);
        id
    }

    /// Adds a call of one of GLSL's functions, and returns its result.
    pub fn add_function(&mut self, of: GlslStd450Op, kind: Word, library: Word, x: Word) -> Word {
        let id = self.add(Op::ExtInst, kind, &[library, x]);
        if let Some(last) = self.instructions.last_mut() {
            last.operands.insert(1, Operand::LiteralExtInstInteger(of as u32));
        }
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
    let blocks = module.functions.iter_mut().flat_map(|function| &mut function.blocks);
    for (number, block) in blocks.enumerate() {
        writer.block = number;
        block.instructions.drain(..).for_each(|instruction| write(&mut writer, instruction));
        block.instructions.append(&mut writer.instructions);
    }
    header.bound = writer.bound;
}
