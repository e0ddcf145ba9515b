//! Widens integers of 8 and 16 bits to 32 bits, because not every GPU has them. Rust makes them of an enum without `#[repr(u32)]`, of an
//! `Ordering`, and of `as i8`.
//!
//! The upper bits of a widened value are zero. An operation that can set them is followed by a mask, and one that needs a sign first
//! extends it. Other operations than these need are refused.

use std::collections::HashMap;

use anyhow::{Result, bail, ensure};
use rspirv::dr::{Builder, Instruction, Module, Operand};
use rspirv::spirv::{Capability, GlslStd450Op, Op, Word};

use crate::declarations::{host_types, merge_types, rename};
use crate::expand::definitions;
use crate::rewrite::{Writer, rewrite};

/// The capabilities of the integers that are widened.
pub const CAPABILITIES: [Capability; 2] = [Capability::Int8, Capability::Int16];

/// Widens all small integers of a module.
pub fn widen(module: &mut Module) -> Result<()> {
    let integers = module.types_global_values.iter().filter_map(integer);
    let small: HashMap<_, _> = integers.filter(|(_, integer)| integer.bits < 32).collect();
    let is_meant = |of: &Instruction| match of.operands[..] {
        [Operand::Capability(of)] => CAPABILITIES.contains(&of),
        _ => false,
    };
    module.capabilities.retain(|of| !is_meant(of));
    refuse_leading_zeros(module, &small)?;
    if small.is_empty() {
        return Ok(());
    }
    let of_host = host_types(module);
    ensure!(
        !small.keys().any(|id| of_host.contains(id)),
        "a buffer has integers of 8 or 16 bits, which not every GPU has: use `Packed<u8>`, `Packed<u16>` or `u32`"
    );
    let mut builder = Builder::new_from_module(std::mem::take(module));
    let wide = [0, 1].map(|sign| builder.type_int(32, sign));
    let numbers = small.values().flat_map(|of| [of.mask(), of.shift()]);
    let constants = numbers.map(|number| (number, builder.constant_bit32(wide[0], number)));
    let constants = constants.collect();
    *module = builder.module();
    let value = |of: &Instruction| Some((of.result_id?, *small.get(&of.result_type?)?));
    let values = module.all_inst_iter().filter_map(value).collect();
    let widening = Widening { small: &small, values, wide, constants };
    let mut result = Ok(());
    rewrite(module, |writer, instruction| {
        if result.is_ok() {
            result = widening.write(instruction, writer);
        }
    });
    result?;
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

    /// The number of the others.
    fn shift(self) -> u32 {
        32 - self.bits
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

/// The compiler is wrong in the leading zeros of integers of 8 and 16 bits, and so in their `ilog2`: for the number of the first bit of 32,
/// which is 31, it takes 55 or 47.
fn refuse_leading_zeros(module: &Module, small: &HashMap<Word, Integer>) -> Result<()> {
    let definitions = definitions(module);
    let all = || module.functions.iter().flat_map(|function| function.all_inst_iter());
    let number = |operand: &Operand| {
        let of = definitions.get(&operand.id_ref_any()?)?;
        match (of.class.opcode, &of.operands[..]) {
            (Op::Constant, [Operand::LiteralBit32(number)]) => Some(*number),
            _ => None,
        }
    };
    let first_bit = Operand::LiteralExtInstInteger(GlslStd450Op::FindUMsb as u32);
    for first in all().filter(|of| of.operands.get(1) == Some(&first_bit)) {
        let [_, _, of] = &first.operands[..] else { continue };
        let source = of.id_ref_any().and_then(|id| definitions.get(&id));
        let is_small = source.is_some_and(|source| match source.class.opcode {
            // nothing tells how many bits it had before the optimizer has put it in
            Op::Constant => true,
            Op::UConvert => {
                let from = source.operands[0].id_ref_any().and_then(|id| definitions.get(&id));
                let kind = from.and_then(|from| from.result_type);
                kind.is_some_and(|kind| small.contains_key(&kind))
            }
            _ => false,
        });
        let found = first.result_id.map(Operand::IdRef);
        let has_it =
            |user: &&Instruction| user.operands.iter().any(|of| Some(of) == found.as_ref());
        let sums = all().filter(|user| matches!(user.class.opcode, Op::IAdd | Op::ISub));
        let is_wrong =
            |sum: &Instruction| sum.operands.iter().filter_map(number).any(|of| of != 31);
        ensure!(
            !is_small || !sums.filter(has_it).any(is_wrong),
            "it takes `ilog2` or leading zeros of an integer of 8 or 16 bits, or of a constant, in which the compiler is wrong: write \
             `(x as u32).leading_zeros()`, or compute it in a `const`"
        );
    }
    Ok(())
}

/// What the pass knows of a module.
struct Widening<'a> {
    small: &'a HashMap<Word, Integer>,
    /// The small integers among the values.
    values: HashMap<Word, Integer>,
    /// The types `u32` and `i32`.
    wide: [Word; 2],
    /// The numbers that the small integers need: masks and shifts.
    constants: HashMap<u32, Word>,
}

impl Widening<'_> {
    /// Extends the sign of an operand, if it is a small integer.
    fn extend(&self, operand: &mut Operand, writer: &mut Writer) {
        let Operand::IdRef(id) = operand else { return };
        let Some(of) = self.values.get(id) else { return };
        let int = self.wide[1];
        let shift = self.constants[&of.shift()];
        let value = writer.add(Op::Bitcast, int, &[*id]);
        let upper = writer.add(Op::ShiftLeftLogical, int, &[value, shift]);
        *id = writer.add(Op::ShiftRightArithmetic, int, &[upper, shift]);
    }

    /// Writes an instruction in its wide form.
    fn write(&self, mut of: Instruction, writer: &mut Writer) -> Result<()> {
        let ids = of.operands.iter().filter_map(Operand::id_ref_any);
        let operand = ids.filter_map(|id| self.values.get(&id)).next().copied();
        let result = of.result_type.and_then(|ty| self.small.get(&ty)).copied();
        let Some(either) = result.or(operand) else {
            writer.instructions.push(of);
            return Ok(());
        };
        let (needs_sign, sets_bits) = match of.class.opcode {
            Op::Load | Op::Store | Op::Phi | Op::Select | Op::CopyObject | Op::Undef => (0, false),
            Op::Variable | Op::AccessChain | Op::InBoundsAccessChain | Op::Bitcast => (0, false),
            Op::CompositeConstruct | Op::CompositeExtract | Op::CompositeInsert => (0, false),
            Op::FunctionCall | Op::ReturnValue | Op::IEqual | Op::INotEqual => (0, false),
            Op::BitwiseAnd | Op::BitwiseOr | Op::BitwiseXor => (0, false),
            Op::ULessThan | Op::ULessThanEqual | Op::UGreaterThan => (0, false),
            Op::UGreaterThanEqual => (0, false),
            Op::IAdd | Op::ISub => (0, true),
            // Rust-GPU takes the sign of the new type, and Rust the old one's
            Op::UConvert | Op::SConvert => {
                (usize::from(operand.is_some_and(|of| of.is_signed)), true)
            }
            Op::SLessThan | Op::SLessThanEqual | Op::SGreaterThan => (2, false),
            Op::SGreaterThanEqual => (2, false),
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
            self.extend(operand, writer);
        }
        // a conversion between integers is a copy, but for its mask
        if matches!(of.class.opcode, Op::UConvert | Op::SConvert) {
            let ty = of.result_type;
            of = Instruction::new(Op::Bitcast, ty, of.result_id, of.operands);
        }
        let masked = result.filter(|_| sets_bits).zip(of.result_type.zip(of.result_id));
        if let Some((result, (kind, id))) = masked {
            let unmasked = writer.id();
            of.result_id = Some(unmasked);
            writer.instructions.push(of);
            writer.push(Op::BitwiseAnd, kind, id, &[unmasked, self.constants[&result.mask()]]);
        } else {
            writer.instructions.push(of);
        }
        Ok(())
    }
}

// what the pass computes is in the cases of `kit/language`
#[cfg(test)]
mod tests {
    use rspirv::spirv::StorageClass;

    use super::*;
    use crate::lower::count_fill;

    /// A module with a buffer of a struct of an integer.
    fn module(bits: u32) -> Module {
        let mut b = Builder::new();
        let integer = b.type_int(bits, 0);
        let block = b.type_struct([integer]);
        let pointer = b.type_pointer(None, StorageClass::StorageBuffer, block);
        let buffer = b.variable(pointer, None, StorageClass::StorageBuffer, None);
        count_fill(b, &[buffer], |_| {})
    }

    #[test]
    fn leading_zeros_are_those_of_32_bits() {
        let zeros = |bits: u32, from: u32| {
            let mut b = Builder::new();
            let [small, word] = [b.type_int(bits, 0), b.type_int(32, 0)];
            let x = b.spec_constant_bit32(small, 0);
            let from = b.constant_bit32(word, from);
            let library = b.ext_inst_import("GLSL.std.450");
            let mut module = count_fill(b, &[], |b| {
                let x = Operand::IdRef(b.u_convert(word, None, x).unwrap());
                let first = GlslStd450Op::FindUMsb as u32;
                let first = b.ext_inst(word, None, library, first, [x]).unwrap();
                b.i_sub(word, None, from, first).unwrap();
            });
            widen(&mut module)
        };
        zeros(8, 31).unwrap();
        for (bits, from) in [(8, 55), (16, 47)] {
            let message = zeros(bits, from).unwrap_err().to_string();
            assert!(message.contains("write `(x as u32).leading_zeros()`"), "{message}");
        }
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
