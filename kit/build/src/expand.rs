//! Writes out instructions that compilers and devices understand differently.
//!
//! | as the compiler writes it | what is wrong | as it becomes |
//! | --- | --- | --- |
//! | `%` of signed integers is `OpSRem` | Vulkan leaves it undefined if a number is negative | `a - b (a / b)` |
//! | `x != y` is true of NaN, as are other comparisons | naga has only those that are false of NaN | `!(x == y)` |
//! | NaN is what differs from itself | a compiler may take `x == x` for true | the bits are compared with infinity's |
//! | `checked_add` of `i32`, and its kin, overflow where `(b < 0) == (a + b > a)` | that is so for b = 0, too | `(b < 0) == (a + b >= a)` |
//! | `round` is `Round` | GLSL leaves open where halves go | the fraction is compared with a half |
//!
//! The compiler makes one instruction of what is done to all components of a vector: it is taken apart first.

use std::collections::{BTreeMap, HashMap};

use rspirv::dr::{Builder, Instruction, Module, Operand};
use rspirv::spirv::{GlslStd450Op, Op, Word};

use crate::rewrite::{Writer, rewrite};

/// Bits of a number without its sign.
const SIZE: u32 = 0x7fff_ffff;
/// Bits of infinity. NaN's, without the sign, are larger.
const INFINITY: u32 = 0x7f80_0000;
/// Bits of -0.0, of 1.0 and of 0.5.
const SIGN: u32 = !SIZE;
const ONE: u32 = 0x3f80_0000;
const HALF: u32 = 0x3f00_0000;

/// Writes out all such instructions of a module.
pub fn expand(module: &mut Module) {
    let mut builder = Builder::new_from_module(std::mem::take(module));
    let float = builder.type_float(32, None);
    let [word, bool] = [builder.type_int(32, 0), builder.type_bool()];
    let [size, infinity, sign, one] =
        [SIZE, INFINITY, SIGN, ONE].map(|bits| builder.constant_bit32(word, bits));
    let half = builder.constant_bit32(float, HALF);
    *module = builder.module();
    let definitions = definitions(module);
    let ids = Ids { float, word, bool, size, infinity, sign, one, half };
    let mut expansion = Expansion { ids, definitions, sums: HashMap::new() };
    rewrite(module, |writer, instruction| expansion.expand(writer, instruction));
}

/// The instruction that defines each id.
pub fn definitions(module: &Module) -> HashMap<Word, Instruction> {
    let all = module.all_inst_iter();
    all.filter_map(|instruction| Some((instruction.result_id?, instruction.clone()))).collect()
}

/// Types and constants.
struct Ids {
    float: Word,
    word: Word,
    bool: Word,
    size: Word,
    infinity: Word,
    sign: Word,
    one: Word,
    half: Word,
}

struct Expansion {
    ids: Ids,
    definitions: HashMap<Word, Instruction>,
    /// What [`Expansion::sum`] has found.
    sums: HashMap<Word, Sum>,
}

/// An integer as a sum of products of values, modulo 2^32: each product, and its factor.
#[derive(Clone, Default, PartialEq)]
struct Sum(BTreeMap<Vec<Word>, u32>);

/// Most products of a [`Sum`]. What has more counts as a value.
const MAX_TERMS: usize = 64;

impl Expansion {
    fn expand(&mut self, writer: &mut Writer, instruction: Instruction) {
        let op = instruction.class.opcode;
        let (Some(kind), Some(id)) = (instruction.result_type, instruction.result_id) else {
            return writer.instructions.push(instruction);
        };
        if self.vector(&instruction).is_some() {
            return self.take_apart(writer, instruction);
        }
        if let Some((library, x)) = rounded(&instruction).filter(|_| kind == self.ids.float) {
            return self.round(writer, id, library, x);
        }
        let Some([a, b]) = pair(&instruction) else {
            return writer.instructions.push(instruction);
        };
        if op == Op::SRem {
            let quotient = writer.add(Op::SDiv, kind, &[a, b]);
            let product = writer.add(Op::IMul, kind, &[b, quotient]);
            writer.push(Op::ISub, kind, id, &[a, product]);
        } else if let Some(test) = self.test_of_nan(op, a, b) {
            let bits = writer.add(Op::Bitcast, self.ids.word, &[a]);
            let size = writer.add(Op::BitwiseAnd, self.ids.word, &[bits, self.ids.size]);
            writer.push(test, kind, id, &[size, self.ids.infinity]);
        } else if let Some(opposite) = opposite(op) {
            let result = writer.add(opposite, kind, &[a, b]);
            writer.push(Op::LogicalNot, kind, id, &[result]);
        } else if let Some((sign, op, operands)) = self.overflow(op, [a, b]) {
            let result = writer.add(op, kind, &operands);
            writer.push(Op::LogicalEqual, kind, id, &[sign, result]);
        } else {
            writer.instructions.push(instruction);
        }
    }

    /// The components of a result, and their type, of an instruction that is only known for numbers.
    fn vector(&self, of: &Instruction) -> Option<(u32, Word)> {
        let kind = self.definitions.get(&of.result_type?)?;
        let [Operand::IdRef(component), Operand::LiteralBit32(count)] = kind.operands[..] else {
            return None;
        };
        let is_taken_apart = rounded(of).is_some()
            || pair(of).is_some_and(|[a, b]| a == b && is_comparison(of.class.opcode));
        (kind.class.opcode == Op::TypeVector && is_taken_apart).then_some((count, component))
    }

    /// Writes an instruction once for each component of its vectors of floats.
    fn take_apart(&mut self, writer: &mut Writer, of: Instruction) {
        let (Some((count, kind)), Some(vector)) = (self.vector(&of), of.result_type) else {
            return;
        };
        let components: Vec<_> = (0..count)
            .map(|lane| {
                let mut operands = of.operands.clone();
                // a library's id stands first, and both sides of a comparison are the same
                let vectors = operands.iter_mut().skip(usize::from(of.class.opcode == Op::ExtInst));
                let vectors = vectors.filter_map(Operand::id_ref_any_mut);
                let mut component = None;
                for id in vectors {
                    *id = *component.get_or_insert_with(|| self.component(writer, *id, lane));
                }
                let id = writer.id();
                self.expand(
                    writer,
                    Instruction::new(of.class.opcode, Some(kind), Some(id), operands),
                );
                id
            })
            .collect();
        if let Some(id) = of.result_id {
            writer.push(Op::CompositeConstruct, vector, id, &components);
        }
    }

    /// A component of a vector of floats.
    fn component(&mut self, writer: &mut Writer, vector: Word, lane: u32) -> Word {
        let id = writer.add(Op::CompositeExtract, self.ids.float, &[vector]);
        if let Some(last) = writer.instructions.last_mut() {
            last.operands.push(Operand::LiteralBit32(lane));
            self.definitions.insert(id, last.clone());
        }
        id
    }

    /// The nearest integer, halves away from 0, as Rust's `round`: x without its fraction, and 1 with the sign of x where the fraction is a
    /// half or more.
    fn round(&self, writer: &mut Writer, id: Word, library: Word, x: Word) {
        let Ids { float, word, bool, sign, one, half, .. } = self.ids;
        let whole = writer.add_function(GlslStd450Op::Trunc, float, library, x);
        let rest = writer.add(Op::FSub, float, &[x, whole]);
        let rest = writer.add_function(GlslStd450Op::FAbs, float, library, rest);
        let is_next = writer.add(Op::FOrdGreaterThanEqual, bool, &[rest, half]);
        let bits = writer.add(Op::Bitcast, word, &[x]);
        let bits = writer.add(Op::BitwiseAnd, word, &[bits, sign]);
        let bits = writer.add(Op::BitwiseOr, word, &[bits, one]);
        let step = writer.add(Op::Bitcast, float, &[bits]);
        let next = writer.add(Op::FAdd, float, &[whole, step]);
        writer.push(Op::Select, float, id, &[is_next, next, whole]);
    }

    /// How the bits of a number without sign compare with infinity's, if the number is compared with itself.
    fn test_of_nan(&self, op: Op, a: Word, b: Word) -> Option<Op> {
        match op {
            _ if a != b || !self.is_float(a) => None,
            Op::FUnordNotEqual => Some(Op::UGreaterThan),
            Op::FOrdEqual | Op::FOrdLessThanEqual | Op::FOrdGreaterThanEqual => {
                Some(Op::ULessThanEqual)
            }
            _ => None,
        }
    }

    /// Whether signed integers overflow, as the compiler decides it: the sign of the one that is added or subtracted, and the right comparison.
    fn overflow(&mut self, op: Op, [sign, other]: [Word; 2]) -> Option<(Word, Op, [Word; 2])> {
        let comparison = self.definitions.get(&other).filter(|_| op == Op::LogicalEqual)?;
        let [result, before] = pair(comparison)?;
        let (op, [more, less]) = match comparison.class.opcode {
            Op::SGreaterThan => (Op::SGreaterThanEqual, [result, before]),
            Op::SLessThan => (Op::SLessThanEqual, [before, result]),
            _ => return None,
        };
        let sign_of = self.definitions.get(&sign)?.clone();
        let mask = self.mask(result)?;
        let mut sum = |id| self.sum(id).modulo(mask);
        let [more, less] = [more, less].map(&mut sum);
        let added = more.minus(&less).modulo(mask);
        let is_formula = match (sign_of.class.opcode, pair(&sign_of)) {
            (Op::ConstantFalse, _) => added == Sum::default(),
            (Op::SLessThan, Some([of, zero])) => sum(zero) == Sum::default() && sum(of) == added,
            _ => false,
        };
        is_formula.then_some((sign, op, [result, before]))
    }

    /// An integer, as far as it is a sum of products. The optimizer can have simplified it.
    fn sum(&mut self, id: Word) -> Sum {
        if let Some(sum) = self.sums.get(&id) {
            return sum.clone();
        }
        let value = Sum::new([(vec![id], 1)]);
        let Some(found) = self.definitions.get(&id) else { return value };
        let op = found.class.opcode;
        let sum = match (op, &found.operands[..]) {
            (Op::Constant, [Operand::LiteralBit32(bits)]) => Sum::new([(vec![], *bits)]),
            (Op::IAdd | Op::ISub | Op::IMul, &[Operand::IdRef(a), Operand::IdRef(b)]) => {
                let [a, b] = [a, b].map(|id| self.sum(id));
                match op {
                    Op::IAdd => a.minus(&Sum::default().minus(&b)),
                    Op::ISub => a.minus(&b),
                    _ => a.times(&b),
                }
            }
            (Op::SNegate, &[Operand::IdRef(a)]) => Sum::default().minus(&self.sum(a)),
            (Op::Bitcast, &[Operand::IdRef(a)]) if !self.is_float(a) => self.sum(a),
            _ => value.clone(),
        };
        let sum = if sum.0.len() > MAX_TERMS { value } else { sum };
        self.sums.insert(id, sum.clone());
        sum
    }

    /// The bits that an integer can have.
    fn mask(&self, id: Word) -> Option<u32> {
        let of = self.definitions.get(&self.definitions.get(&id)?.result_type?)?;
        match (of.class.opcode, &of.operands[..]) {
            (Op::TypeInt, [Operand::LiteralBit32(bits @ 1..=32), _]) => {
                Some(u32::MAX >> (32 - bits))
            }
            _ => None,
        }
    }

    fn is_float(&self, id: Word) -> bool {
        self.definitions.get(&id).is_some_and(|found| found.result_type == Some(self.ids.float))
    }
}

impl Sum {
    /// The sum of integers that have fewer bits.
    fn modulo(&self, mask: u32) -> Self {
        Self::new(self.0.iter().map(|(product, factor)| (product.clone(), factor & mask)))
    }

    fn minus(&self, other: &Self) -> Self {
        let negated =
            other.0.iter().map(|(product, factor)| (product.clone(), factor.wrapping_neg()));
        Self::new(self.0.clone().into_iter().chain(negated))
    }

    fn times(&self, other: &Self) -> Self {
        let pairs = self.0.iter().flat_map(|one| other.0.iter().map(move |two| (one, two)));
        Self::new(pairs.map(|((one, factor), (two, by))| {
            let mut product = [one.as_slice(), two].concat();
            product.sort_unstable();
            (product, factor.wrapping_mul(*by))
        }))
    }

    fn new(products: impl IntoIterator<Item = (Vec<Word>, u32)>) -> Self {
        let mut sum = BTreeMap::<_, u32>::new();
        for (product, factor) in products {
            let total = sum.entry(product).or_default();
            *total = total.wrapping_add(factor);
        }
        sum.retain(|_, factor| *factor != 0);
        Self(sum)
    }
}

/// The number, or the vector, that `Round` takes, after the id of GLSL's functions.
fn rounded(of: &Instruction) -> Option<(Word, Word)> {
    let round = Operand::LiteralExtInstInteger(GlslStd450Op::Round as u32);
    match &of.operands[..] {
        [Operand::IdRef(library), function, Operand::IdRef(x)] if *function == round => {
            Some((*library, *x))
        }
        _ => None,
    }
}

/// Whether an instruction compares floats in a way that tells NaN, if both are the same.
fn is_comparison(op: Op) -> bool {
    use Op::{FOrdEqual, FOrdGreaterThanEqual, FOrdLessThanEqual, FUnordNotEqual};
    matches!(op, FUnordNotEqual | FOrdEqual | FOrdLessThanEqual | FOrdGreaterThanEqual)
}

/// The operands of an instruction that has two.
fn pair(instruction: &Instruction) -> Option<[Word; 2]> {
    match instruction.operands[..] {
        [Operand::IdRef(a), Operand::IdRef(b)] => Some([a, b]),
        _ => None,
    }
}

/// The comparison that is false of NaN, and otherwise the opposite of one that is true of NaN.
fn opposite(op: Op) -> Option<Op> {
    Some(match op {
        Op::FUnordNotEqual => Op::FOrdEqual,
        Op::FUnordLessThan => Op::FOrdGreaterThanEqual,
        Op::FUnordLessThanEqual => Op::FOrdGreaterThan,
        Op::FUnordGreaterThan => Op::FOrdLessThanEqual,
        Op::FUnordGreaterThanEqual => Op::FOrdLessThan,
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lower::count_fill;

    /// The operations of a function of integers x, y and z of so many bits, once they are expanded.
    fn expanded(bits: u32, write: impl Fn(&mut Builder, [Word; 2], [Word; 3])) -> Vec<Op> {
        let mut b = Builder::new();
        let [int, bool] = [b.type_int(bits, 1), b.type_bool()];
        let values = [0; 3].map(|usual| b.spec_constant_bit32(int, usual));
        let mut module = count_fill(b, &[], |b| write(b, [int, bool], values));
        expand(&mut module);
        let blocks = module.functions.iter().flat_map(|function| &function.blocks);
        blocks.flat_map(|block| &block.instructions).map(|i| i.class.opcode).collect()
    }

    #[test]
    fn an_overflow_is_told_by_the_right_comparison() {
        type Sum = fn(&mut Builder, Word, [Word; 3]) -> [Word; 2];
        let plus: Sum = |b, int, [x, y, _]| [b.i_add(int, None, y, x).unwrap(), x];
        // x - y + y, which the optimizer has simplified
        let simplified: Sum = |b, int, [x, y, _]| [x, b.i_sub(int, None, x, y).unwrap()];
        // another comparison that stands beside a sign
        let another: Sum = |_, _, [x, _, z]| [z, x];
        let all = [(plus, true), (simplified, true), (another, false)];
        for ((sum, is_formula), bits) in all.into_iter().flat_map(|one| [(one, 32), (one, 8)]) {
            let ops = expanded(bits, |b, [int, bool], values| {
                let zero = b.constant_bit32(int, 0);
                let [result, before] = sum(b, int, values);
                let sign = b.s_less_than(bool, None, values[1], zero).unwrap();
                let rises = b.s_greater_than(bool, None, result, before).unwrap();
                b.logical_equal(bool, None, sign, rises).unwrap();
            });
            assert_eq!(ops.contains(&Op::SGreaterThanEqual), is_formula, "{ops:?}");
        }
    }

    #[test]
    fn a_remainder_is_written_out() {
        let ops = expanded(32, |b, [int, _], [x, y, _]| {
            b.s_rem(int, None, x, y).unwrap();
        });
        assert_eq!(ops, [Op::SDiv, Op::IMul, Op::ISub, Op::Return]);
    }

    #[test]
    fn halves_are_rounded_in_one_way() {
        let ops = expanded(32, |b, _, _| {
            let float = b.type_float(32, None);
            let x = b.spec_constant_bit32(float, 0);
            let library = b.ext_inst_import("GLSL.std.450");
            let operands = [Operand::IdRef(x)];
            b.ext_inst(float, None, library, GlslStd450Op::Round as u32, operands).unwrap();
        });
        assert!(ops.contains(&Op::FOrdGreaterThanEqual) && ops.contains(&Op::Select), "{ops:?}");
    }

    #[test]
    fn vectors_are_taken_apart() {
        let count = |ops: &[Op], op| ops.iter().filter(|found| **found == op).count();
        let of = |op: Op| {
            expanded(32, |b, [_, bool], _| {
                let float = b.type_float(32, None);
                let [vector, bools] = [float, bool].map(|kind| b.type_vector(kind, 3));
                let one = b.spec_constant_bit32(float, 0);
                let x = b.constant_composite(vector, [one; 3]);
                let library = b.ext_inst_import("GLSL.std.450");
                let x_of = [Operand::IdRef(x)];
                if op == Op::ExtInst {
                    b.ext_inst(vector, None, library, GlslStd450Op::Round as u32, x_of).unwrap();
                } else {
                    b.f_unord_not_equal(bools, None, x, x).unwrap();
                }
            })
        };
        for (op, last) in [(Op::ExtInst, Op::Select), (Op::FUnordNotEqual, Op::UGreaterThan)] {
            let ops = of(op);
            let counts =
                [Op::CompositeExtract, last, Op::CompositeConstruct].map(|of| count(&ops, of));
            assert_eq!(counts, [3, 3, 1], "{ops:?}");
        }
    }
}
