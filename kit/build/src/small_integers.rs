//! Widens integers of 8 and 16 bits to 32 bits, because not every GPU has them. Rust makes them of an enum without `#[repr(u32)]`, of an
//! `Ordering`, and of `as i8`.
//!
//! The upper bits of a widened value are zero. An operation that can set them is followed by a mask, and one that needs a sign first
//! extends it.

use std::collections::{BTreeSet, HashMap};

use anyhow::{Context, Result, bail, ensure};
use rspirv::dr::{Instruction, Module, Operand};
use rspirv::spirv::{Capability, Op, StorageClass, Word};

use crate::declarations::{merge_types, rename};

/// The capabilities of the integers that are widened.
pub const CAPABILITIES: [Capability; 2] = [Capability::Int8, Capability::Int16];

/// Functions of GLSL.std.450 that need a sign: SAbs, SSign, SMin, SMax, SClamp and FindSMsb.
const SIGNED: [u32; 6] = [5, 7, 39, 42, 45, 74];
/// Those that need none: UMin, UMax, UClamp, FindILsb and FindUMsb.
const UNSIGNED: [u32; 5] = [38, 41, 44, 73, 75];

/// Widens all small integers of a module.
pub fn widen(module: &mut Module) -> Result<()> {
    let integers = module.types_global_values.iter().filter_map(integer);
    let small: HashMap<_, _> = integers.filter(|(_, integer)| integer.bits < 32).collect();
    let is_meant = |of: &Instruction| match of.operands[..] {
        [Operand::Capability(of)] => CAPABILITIES.contains(&of),
        _ => false,
    };
    module.capabilities.retain(|of| !is_meant(of));
    if small.is_empty() {
        return Ok(());
    }
    refuse_in_buffers(module, &small)?;
    let mut widening = Widening::new(module, &small)?;
    for function in &mut module.functions {
        for block in &mut function.blocks {
            let mut written = Vec::with_capacity(block.instructions.len());
            for instruction in block.instructions.drain(..) {
                widening.write(instruction, &mut written)?;
            }
            block.instructions = written;
        }
    }
    let Widening { bound, wide, declared, .. } = widening;
    module.types_global_values.extend(declared);
    let is_small = |of: &Instruction| of.result_id.is_some_and(|id| small.contains_key(&id));
    module.types_global_values.retain(|of| !is_small(of));
    for constant in &mut module.types_global_values {
        let of = constant.result_type.and_then(|of| small.get(&of));
        if let (Some(of), [Operand::LiteralBit32(value)]) = (of, &mut constant.operands[..]) {
            *value &= of.mask();
        }
    }
    let both = small.iter().map(|(id, of)| (*id, wide[usize::from(of.is_signed)]));
    rename(module.all_inst_iter_mut(), &both.collect());
    merge_types(module);
    if let Some(header) = &mut module.header {
        header.bound = bound;
    }
    Ok(())
}

/// A type of integers.
#[derive(Clone, Copy)]
struct Integer {
    bits: u32,
    is_signed: bool,
}

impl Integer {
    /// The bits of a widened value that can be set.
    fn mask(self) -> u32 {
        (1 << self.bits) - 1
    }
}

/// A type of integers and its id.
fn integer(of: &Instruction) -> Option<(Word, Integer)> {
    match (of.class.opcode, &of.operands[..]) {
        (Op::TypeInt, &[Operand::LiteralBit32(bits), Operand::LiteralBit32(sign)]) => {
            Some((of.result_id?, Integer { bits, is_signed: sign == 1 }))
        }
        _ => None,
    }
}

/// Fails if memory that the host fills has small integers: they would move.
fn refuse_in_buffers(module: &Module, small: &HashMap<Word, Integer>) -> Result<()> {
    let declared = |id: Word| {
        module.types_global_values.iter().find(move |instruction| instruction.result_id == Some(id))
    };
    let used = module.entry_points.iter().flat_map(|point| &point.operands);
    let variables = used.filter_map(Operand::id_ref_any).filter_map(declared);
    let of_host = variables.filter(|variable| match variable.operands.first() {
        Some(Operand::StorageClass(of)) => {
            matches!(of, StorageClass::StorageBuffer | StorageClass::Uniform)
        }
        _ => false,
    });
    let mut left: Vec<_> = of_host.filter_map(|variable| variable.result_type).collect();
    let mut seen = BTreeSet::new();
    while let Some(id) = left.pop() {
        ensure!(
            !small.contains_key(&id),
            "a buffer has integers of 8 or 16 bits, which not every GPU has: use `Packed<u8>`, `Packed<u16>` or `u32`"
        );
        if seen.insert(id) {
            let operands = declared(id).into_iter().flat_map(|of| &of.operands);
            left.extend(operands.filter_map(Operand::id_ref_any));
        }
    }
    Ok(())
}

/// What the pass knows of a module, and what it adds.
struct Widening<'a> {
    small: &'a HashMap<Word, Integer>,
    /// The small integers among the values.
    values: HashMap<Word, Integer>,
    bound: Word,
    /// The types `u32` and `i32`.
    wide: [Word; 2],
    constants: HashMap<u32, Word>,
    declared: Vec<Instruction>,
}

impl<'a> Widening<'a> {
    fn new(module: &Module, small: &'a HashMap<Word, Integer>) -> Result<Self> {
        let value = |of: &Instruction| Some((of.result_id?, *small.get(&of.result_type?)?));
        let values = module.all_inst_iter().filter_map(value).collect();
        let bound = module.header.as_ref().context("the module has no header")?.bound;
        let constants = HashMap::new();
        let mut widening =
            Self { small, values, bound, wide: [0; 2], constants, declared: Vec::new() };
        for is_signed in [false, true] {
            let mut integers = module.types_global_values.iter().filter_map(integer);
            let found = integers.find(|(_, of)| of.bits == 32 && of.is_signed == is_signed);
            let operands = [32, u32::from(is_signed)].map(Operand::LiteralBit32);
            widening.wide[usize::from(is_signed)] = match found {
                Some((id, _)) => id,
                None => widening.declare(Op::TypeInt, None, operands.into()),
            };
        }
        Ok(widening)
    }

    fn id(&mut self) -> Word {
        self.bound += 1;
        self.bound - 1
    }

    fn declare(&mut self, op: Op, ty: Option<Word>, operands: Vec<Operand>) -> Word {
        let id = self.id();
        self.declared.push(Instruction::new(op, ty, Some(id), operands));
        id
    }

    fn constant(&mut self, value: u32) -> Operand {
        let ty = self.wide[0];
        let known = self.constants.get(&value).copied();
        let id = known.unwrap_or_else(|| {
            self.declare(Op::Constant, Some(ty), vec![Operand::LiteralBit32(value)])
        });
        self.constants.insert(value, id);
        Operand::IdRef(id)
    }

    /// Writes an operation; returns its result.
    fn operation(
        &mut self,
        written: &mut Vec<Instruction>,
        op: Op,
        ty: Word,
        operands: Vec<Operand>,
    ) -> Operand {
        let id = self.id();
        written.push(Instruction::new(op, Some(ty), Some(id), operands));
        Operand::IdRef(id)
    }

    /// Extends the sign of an operand, if it is a small integer.
    fn extend(&mut self, operand: &mut Operand, written: &mut Vec<Instruction>) {
        let Some(of) = operand.id_ref_any().and_then(|id| self.values.get(&id)).copied() else {
            return;
        };
        let int = self.wide[1];
        let shift = self.constant(32 - of.bits);
        let value = self.operation(written, Op::Bitcast, int, vec![operand.clone()]);
        let up = vec![value, shift.clone()];
        let upper = self.operation(written, Op::ShiftLeftLogical, int, up);
        *operand = self.operation(written, Op::ShiftRightArithmetic, int, vec![upper, shift]);
    }

    /// Writes an operation whose result has other bits than its type, and then masks them.
    fn write_masked(
        &mut self,
        mut instruction: Instruction,
        of: Integer,
        written: &mut Vec<Instruction>,
    ) {
        let id = instruction.result_id.replace(self.id());
        let unmasked = instruction.result_id.into_iter().map(Operand::IdRef);
        let ty = instruction.result_type;
        let operands = unmasked.chain([self.constant(of.mask())]).collect();
        written.push(instruction);
        written.push(Instruction::new(Op::BitwiseAnd, ty, id, operands));
    }

    /// Writes an instruction in its wide form.
    fn write(&mut self, mut of: Instruction, written: &mut Vec<Instruction>) -> Result<()> {
        let ids = of.operands.iter().filter_map(Operand::id_ref_any);
        let operand = ids.filter_map(|id| self.values.get(&id)).next().copied();
        let result = of.result_type.and_then(|ty| self.small.get(&ty)).copied();
        let Some(either) = result.or(operand) else {
            written.push(of);
            return Ok(());
        };
        let function = match of.operands.get(1) {
            Some(&Operand::LiteralExtInstInteger(number)) => number,
            _ => 0,
        };
        let (needs_sign, sets_bits) = match of.class.opcode {
            Op::Load | Op::Store | Op::Phi | Op::Select | Op::CopyObject | Op::Undef => (0, false),
            Op::Variable | Op::AccessChain | Op::InBoundsAccessChain | Op::Bitcast => (0, false),
            Op::CompositeConstruct | Op::CompositeExtract | Op::CompositeInsert => (0, false),
            Op::FunctionCall | Op::ReturnValue | Op::IEqual | Op::INotEqual => (0, false),
            Op::BitwiseAnd | Op::BitwiseOr | Op::BitwiseXor | Op::BitCount => (0, false),
            Op::ShiftRightLogical | Op::UDiv | Op::UMod | Op::ConvertUToF => (0, false),
            Op::ULessThan | Op::ULessThanEqual | Op::UGreaterThan => (0, false),
            Op::UGreaterThanEqual => (0, false),
            Op::IAdd | Op::ISub | Op::IMul | Op::SNegate | Op::Not => (0, true),
            Op::ShiftLeftLogical | Op::ConvertFToU | Op::ConvertFToS => (0, true),
            Op::ShiftRightArithmetic => (1, true),
            // Rust-GPU takes the sign of the new type, and Rust that of the old one
            Op::UConvert | Op::SConvert => {
                (usize::from(operand.is_some_and(|of| of.is_signed)), true)
            }
            Op::SDiv | Op::SRem | Op::SMod => (2, true),
            Op::ConvertSToF => (1, false),
            Op::SLessThan | Op::SLessThanEqual | Op::SGreaterThan => (2, false),
            Op::SGreaterThanEqual => (2, false),
            Op::ExtInst if SIGNED.contains(&function) => (of.operands.len(), true),
            Op::ExtInst if UNSIGNED.contains(&function) => (0, false),
            Op::Switch => {
                for operand in &mut of.operands {
                    if let Operand::LiteralBit32(value) = operand {
                        *value &= either.mask();
                    }
                }
                (0, false)
            }
            other => {
                bail!("`{other:?}` of an integer of {} bits: use `u32` or `i32`", either.bits)
            }
        };
        for operand in of.operands.iter_mut().take(needs_sign) {
            self.extend(operand, written);
        }
        // a conversion between integers is a copy, but for its mask
        if matches!(of.class.opcode, Op::UConvert | Op::SConvert) {
            let ty = of.result_type;
            of = Instruction::new(Op::Bitcast, ty, of.result_id, of.operands);
        }
        match result.filter(|_| sets_bits) {
            Some(result) => self.write_masked(of, result, written),
            None => written.push(of),
        }
        Ok(())
    }
}

// what the pass computes is in the case of organza's kernel `core_functions`
#[cfg(test)]
mod tests {
    use rspirv::dr::Builder;
    use rspirv::spirv::{ExecutionModel, FunctionControl};

    use super::*;

    /// A module with a buffer of a struct of an integer.
    fn module(bits: u32) -> Module {
        let mut b = Builder::new();
        let [void, integer] = [b.type_void(), b.type_int(bits, 0)];
        let block = b.type_struct([integer]);
        let pointer = b.type_pointer(None, StorageClass::StorageBuffer, block);
        let buffer = b.variable(pointer, None, StorageClass::StorageBuffer, None);
        let ty = b.type_function(void, []);
        let function = b.begin_function(void, None, FunctionControl::NONE, ty).unwrap();
        b.begin_block(None).unwrap();
        b.ret().unwrap();
        b.end_function().unwrap();
        b.entry_point(ExecutionModel::GLCompute, function, "blur", [buffer]);
        b.module()
    }

    #[test]
    fn buffers_have_no_small_integers() {
        widen(&mut module(32)).unwrap();
        for bits in [8, 16] {
            let message = widen(&mut module(bits)).unwrap_err().to_string();
            assert!(message.contains("use `Packed<u8>`, `Packed<u16>` or `u32`"), "{message}");
        }
    }
}
