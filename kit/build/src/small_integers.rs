//! Widens integers of 8 and 16 bits to 32 bits, because not every GPU has them. Rust makes them of an enum without `#[repr(u32)]`, of an
//! `Ordering`, and of `as i8`.
//!
//! The upper bits of a widened value are zero. An operation that can set them is followed by a mask, and one that needs a sign first
//! extends it.
//!
//! The compiler is wrong in two of them: it rotates by 32 bits, whatever the type has, and takes the leading zeros of `u8` for 48 too many,
//! and of `u16` for 32.

use std::collections::{BTreeSet, HashMap};

use anyhow::{Result, bail, ensure};
use rspirv::dr::{Builder, Instruction, Module, Operand};
use rspirv::spirv::{Capability, GlslStd450Op, Op, Word};

use crate::declarations::{host_types, merge_types, rename};
use crate::expand::definitions;
use crate::module::{Writer, rewrite};

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
    let zeros = wrong_leading_zeros(module, &small)?;
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
    let numbers = small.values().flat_map(|of| [of.mask(), of.shift(), of.copies(), of.bits - 1]);
    let constants = numbers.map(|number| (number, builder.constant_bit32(wide[0], number)));
    let constants = constants.collect();
    *module = builder.module();
    let value = |of: &Instruction| Some((of.result_id?, *small.get(&of.result_type?)?));
    let values = module.all_inst_iter().filter_map(value).collect();
    let definitions = definitions(module);
    let widening = Widening { small: &small, values, wide, constants, definitions, zeros };
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

    /// The factor that fills 32 bits with copies of a value.
    fn copies(self) -> u32 {
        u32::MAX / self.mask()
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

/// The differences of a number and the place of the first bit that is set, for which the compiler takes 55 or 47 for leading zeros of integers
/// of 8 and 16 bits, with these integers.
///
/// They are told from the ones of 32 bits, which begin with 31, by what stands for the leading zeros of 0. Where that is left out, as in `ilog2`,
/// or where the optimizer has put in a constant and computed with it, nothing tells.
fn wrong_leading_zeros(
    module: &Module,
    small: &HashMap<Word, Integer>,
) -> Result<HashMap<Word, Integer>> {
    let definitions = definitions(module);
    let number = |id| number(&definitions, id);
    let all = || module.functions.iter().flat_map(|function| function.all_inst_iter());
    let users = |id: Word| all().filter(move |user| user.operands.contains(&Operand::IdRef(id)));
    let mut wrong = HashMap::new();
    for first in all() {
        let [_, function, Operand::IdRef(of)] = &first.operands[..] else { continue };
        let (true, Some(id)) = (is_first_bit(function), first.result_id) else { continue };
        let converted = definitions.get(of).filter(|source| source.class.opcode == Op::UConvert);
        let integer = converted
            .and_then(|source| definitions.get(&source.operands[0].id_ref_any()?))
            .and_then(|source| small.get(&source.result_type?));
        for user in users(id) {
            let numbers: Vec<_> =
                user.operands.iter().filter_map(Operand::id_ref_any).filter_map(number).collect();
            let Some(&integer) = integer else {
                let is_sum = matches!(user.class.opcode, Op::IAdd | Op::ISub);
                ensure!(
                    number(*of).is_none() || !is_sum || numbers.is_empty() || numbers == [31],
                    "it takes `ilog2` or leading zeros of a constant, in which the compiler can be wrong: compute them in a `const`"
                );
                continue;
            };
            let zeros = user.result_id.filter(|_| user.class.opcode == Op::ISub);
            let of_zero =
                zeros.into_iter().flat_map(users).map(|choice| match choice.operands[..] {
                    [_, Operand::IdRef(of_zero), _] if choice.class.opcode == Op::Select => {
                        number(of_zero)
                    }
                    _ => None,
                });
            let of_zero: BTreeSet<_> = of_zero.collect();
            let bits = integer.bits;
            match (zeros, &numbers[..]) {
                (Some(_), [31]) if of_zero == [Some(32)].into() => {}
                (Some(zeros), [from]) if *from == 63 - bits && of_zero == [Some(bits)].into() => {
                    wrong.insert(zeros, integer);
                }
                _ => bail!(
                    "it takes `ilog2`, `next_power_of_two` or leading zeros of an integer of {bits} bits, in which the compiler is wrong: \
                     write `(x as u32 | 1).ilog2()`, `(x as u32).next_power_of_two()` or `(x as u32).leading_zeros() - {}`",
                    integer.shift()
                ),
            }
        }
    }
    Ok(wrong)
}

/// The value of a constant of 32 bits.
fn number(definitions: &HashMap<Word, Instruction>, id: Word) -> Option<u32> {
    let of = definitions.get(&id)?;
    match (of.class.opcode, &of.operands[..]) {
        (Op::Constant, [Operand::LiteralBit32(number)]) => Some(*number),
        _ => None,
    }
}

/// Whether a function is that which finds the first bit of an integer without sign.
fn is_first_bit(function: &Operand) -> bool {
    *function == Operand::LiteralExtInstInteger(GlslStd450Op::FindUMsb as u32)
}

/// What the pass knows of a module.
struct Widening<'a> {
    small: &'a HashMap<Word, Integer>,
    /// The small integers among the values.
    values: HashMap<Word, Integer>,
    /// The types `u32` and `i32`.
    wide: [Word; 2],
    /// The numbers that the small integers need: masks, shifts and others.
    constants: HashMap<u32, Word>,
    definitions: HashMap<Word, Instruction>,
    /// What [`wrong_leading_zeros`] has found.
    zeros: HashMap<Word, Integer>,
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

    /// The value that a sum of two shifts rotates, and both shifts: where their numbers of bits are 32 together.
    fn rotation(&self, of: &Instruction) -> Option<(Word, [(Op, Word); 2])> {
        let &[Operand::IdRef(one), Operand::IdRef(other)] = &of.operands[..] else { return None };
        let shift = |id: Word| {
            let of = self.definitions.get(&id)?;
            match of.operands[..] {
                [Operand::IdRef(value), Operand::IdRef(by)] => Some((value, of.class.opcode, by)),
                _ => None,
            }
        };
        let [(value, one, by), (same, other, rest)] = [shift(one)?, shift(other)?];
        let is_left = |op| op == Op::ShiftLeftLogical;
        let is_right = |op| op == Op::ShiftRightLogical;
        let are_shifts = is_left(one) && is_right(other) || is_right(one) && is_left(other);
        let is_all = self.is_rest(by, rest) || self.is_rest(rest, by);
        let found = of.class.opcode == Op::BitwiseOr && value == same && are_shifts && is_all;
        found.then_some((value, [(one, by), (other, rest)]))
    }

    /// Whether `rest` is 32 without `by`.
    fn is_rest(&self, by: Word, rest: Word) -> bool {
        let number = |id| number(&self.definitions, id);
        let difference = self.definitions.get(&rest).filter(|of| of.class.opcode == Op::ISub);
        match difference.map(|of| &of.operands[..]) {
            Some([Operand::IdRef(from), subtracted]) => {
                number(*from) == Some(32) && *subtracted == Operand::IdRef(by)
            }
            _ => number(by)
                .zip(number(rest))
                .is_some_and(|(by, rest)| by.checked_add(rest) == Some(32)),
        }
    }

    /// Rotates a value: 32 bits with copies of it, by as many bits, have it rotated in each copy.
    fn rotate(
        &self,
        writer: &mut Writer,
        integer: Integer,
        (value, shifts): (Word, [(Op, Word); 2]),
    ) -> Word {
        let word = self.wide[0];
        let value = writer.add(Op::Bitcast, word, &[value]);
        let copies = writer.add(Op::IMul, word, &[value, self.constants[&integer.copies()]]);
        let [one, other] = shifts.map(|(op, by)| writer.add(op, word, &[copies, by]));
        writer.add(Op::BitwiseOr, word, &[one, other])
    }

    /// Writes an instruction in its wide form.
    fn write(&self, mut of: Instruction, writer: &mut Writer) -> Result<()> {
        if let Some(integer) = of.result_id.and_then(|id| self.zeros.get(&id)) {
            of.operands[0] = Operand::IdRef(self.constants[&(integer.bits - 1)]);
        }
        let ids = of.operands.iter().filter_map(Operand::id_ref_any);
        let operand = ids.filter_map(|id| self.values.get(&id)).next().copied();
        let result = of.result_type.and_then(|ty| self.small.get(&ty)).copied();
        let Some(either) = result.or(operand) else {
            writer.instructions.push(of);
            return Ok(());
        };
        if let (Some(integer), Some(rotation)) = (result, self.rotation(&of)) {
            let rotated = self.rotate(writer, integer, rotation);
            let (Some(kind), Some(id)) = (of.result_type, of.result_id) else { return Ok(()) };
            writer.push(Op::BitwiseAnd, kind, id, &[rotated, self.constants[&integer.mask()]]);
            return Ok(());
        }
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
            // Rust-GPU takes the sign of the new type, and Rust the old one's
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
    fn buffers_have_no_small_integers() {
        widen(&mut module(32)).unwrap();
        for bits in [8, 16] {
            let message = widen(&mut module(bits)).unwrap_err().to_string();
            assert!(message.contains("use `Packed<u8>`, `Packed<u16>` or `u32`"), "{message}");
        }
    }
}
