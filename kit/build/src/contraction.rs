//! Keeps drivers from fusing, regrouping and shortening arithmetic, unless its kernel is declared `fused`: every operation gets the decoration
//! `NoContraction`.
//!
//! Rust-GPU has no option for it. Without it a driver can compute `a * b + c` with one rounding, or shorten `(x - a) + b`.
//! Results then differ between devices, and numbers in two parts (`shader-crate/src/unit_cube.rs`) lose the second part.
//! The decoration does not keep Mesa's llvmpipe from taking `x * 0.0` and `0.0 / x` for 0, so these are written with bits: zero with the sign of x, or
//! NaN.

use std::collections::HashMap;

use anyhow::{Context, Result};
use rspirv::dr::{Builder, Instruction, Module, Operand};
use rspirv::spirv::{Decoration, Op, Word};

use crate::rewrite::{Writer, rewrite};

/// Operations that can have the decoration.
const ARITHMETIC: [Op; 6] =
    [Op::FAdd, Op::FSub, Op::FMul, Op::FDiv, Op::FNegate, Op::VectorTimesScalar];

/// Forbids a driver to change a module's arithmetic.
pub fn forbid(module: &mut Module) -> Result<()> {
    write_zeros(module);
    let blocks = module.functions.iter().flat_map(|function| &function.blocks);
    let arithmetic = blocks
        .flat_map(|block| &block.instructions)
        .filter(|instruction| ARITHMETIC.contains(&instruction.class.opcode));
    let decorations = arithmetic
        .map(|instruction| {
            let id = instruction.result_id.context("an operation has a result")?;
            let operands = vec![Operand::IdRef(id), Operand::Decoration(Decoration::NoContraction)];
            Ok(Instruction::new(Op::Decorate, None, None, operands))
        })
        .collect::<Result<Vec<_>>>()?;
    module.annotations.extend(decorations);
    Ok(())
}

/// Bits of a float: its sign, all others, infinity, and NaN.
const SIGN: u32 = 1 << 31;
const SIZE: u32 = !SIGN;
const INFINITY: u32 = 0x7f80_0000;
const NAN: u32 = 0x7fc0_0000;

/// Types and constants.
struct Ids {
    float: Word,
    word: Word,
    bool: Word,
    one: Word,
    sign: Word,
    size: Word,
    infinity: Word,
    nan: Word,
}

impl Ids {
    /// An element of a vector.
    fn extract(&self, writer: &mut Writer, vector: Word, lane: usize) -> Word {
        let id = writer.add(Op::CompositeExtract, self.float, &[vector]);
        if let Some(last) = writer.instructions.last_mut() {
            last.operands.push(Operand::LiteralBit32(lane as u32));
        }
        id
    }

    /// `x * zero`, or `zero / x`.
    fn zero(&self, writer: &mut Writer, x: Word, zero: u32, is_product: bool) -> Word {
        let Self { float, word, bool, one, sign, size, infinity, nan } = *self;
        let mut bits = writer.add(Op::Bitcast, word, &[x]);
        // 0.0 / 0.0 is NaN: one less than 0 is a large number
        let mut rest = writer.add(Op::BitwiseAnd, word, &[bits, size]);
        if !is_product {
            rest = writer.add(Op::ISub, word, &[rest, one]);
        }
        if zero != 0 {
            bits = writer.add(Op::Not, word, &[bits]);
        }
        let signed = writer.add(Op::BitwiseAnd, word, &[bits, sign]);
        let is_zero = writer.add(Op::ULessThan, bool, &[rest, infinity]);
        let result = writer.add(Op::Select, word, &[is_zero, signed, nan]);
        writer.add(Op::Bitcast, float, &[result])
    }
}

/// Writes products with constant zeros, and quotients of them, with bits. Vectors with a zero are taken apart.
fn write_zeros(module: &mut Module) {
    let mut builder = Builder::new_from_module(std::mem::take(module));
    let [float, word, bool] =
        [builder.type_float(32, None), builder.type_int(32, 0), builder.type_bool()];
    let [one, sign, size, infinity, nan] =
        [1, SIGN, SIZE, INFINITY, NAN].map(|bits| builder.constant_bit32(word, bits));
    let ids = Ids { float, word, bool, one, sign, size, infinity, nan };
    *module = builder.module();
    let numbers = Numbers::new(module, float);
    rewrite(module, |writer, instruction| {
        let op = instruction.class.opcode;
        let parts = match (instruction.result_type, &instruction.operands[..]) {
            (Some(kind), &[Operand::IdRef(a), Operand::IdRef(b)]) if PRODUCTS.contains(&op) => {
                let is_zero = |id| numbers.is_zero(id);
                let has_zero = is_zero(a) || is_zero(b) && op != Op::FDiv;
                has_zero.then_some((kind, [a, b]))
            }
            _ => None,
        };
        let Some((kind, operands)) = parts else {
            return writer.instructions.push(instruction);
        };
        let count = numbers.lanes.get(&kind).copied();
        let is_vector = [count.is_some(), count.is_some() && op != Op::VectorTimesScalar];
        let results: Vec<_> = (0..count.unwrap_or(1))
            .map(|lane| {
                let mut part = |at: usize| match numbers.parts.get(&operands[at]) {
                    Some(parts) => parts[if is_vector[at] { lane } else { 0 }],
                    None if is_vector[at] => ids.extract(writer, operands[at], lane),
                    None => operands[at],
                };
                let pair = [part(0), part(1)];
                let bits = pair.map(|id| numbers.bits.get(&id).copied());
                let zero = |at: usize| bits[at].filter(|bits| bits & SIZE == 0);
                match (zero(0), zero(1)) {
                    (Some(zero), None) if bits[1].is_none() => {
                        ids.zero(writer, pair[1], zero, op != Op::FDiv)
                    }
                    (None, Some(zero)) if bits[0].is_none() && op != Op::FDiv => {
                        ids.zero(writer, pair[0], zero, true)
                    }
                    _ => {
                        let op = if op == Op::FDiv { Op::FDiv } else { Op::FMul };
                        writer.add(op, float, &pair)
                    }
                }
            })
            .collect();
        if count.is_some() {
            writer.add(Op::CompositeConstruct, kind, &results);
        }
        if let Some(last) = writer.instructions.last_mut() {
            last.result_id = instruction.result_id;
        }
    });
}

/// Operations whose result a zero decides.
const PRODUCTS: [Op; 3] = [Op::FMul, Op::FDiv, Op::VectorTimesScalar];

/// The constant floats of a module, and its vectors of floats.
struct Numbers {
    /// Bits of the constants.
    bits: HashMap<Word, u32>,
    /// The elements of each constant: one, or a vector's.
    parts: HashMap<Word, Vec<Word>>,
    /// The lengths of the vectors' types.
    lanes: HashMap<Word, usize>,
}

impl Numbers {
    fn new(module: &Module, float: Word) -> Self {
        let mut numbers =
            Self { bits: HashMap::new(), parts: HashMap::new(), lanes: HashMap::new() };
        for declaration in &module.types_global_values {
            let Some(id) = declaration.result_id else { continue };
            let is_float = declaration.result_type == Some(float);
            match (declaration.class.opcode, &declaration.operands[..]) {
                (Op::TypeVector, &[Operand::IdRef(of), Operand::LiteralBit32(count)])
                    if of == float =>
                {
                    numbers.lanes.insert(id, count as usize);
                }
                (Op::Constant, &[Operand::LiteralBit32(bits)]) if is_float => {
                    numbers.bits.insert(id, bits);
                    numbers.parts.insert(id, vec![id]);
                }
                (Op::ConstantComposite, parts) => {
                    let parts: Vec<_> = parts.iter().filter_map(Operand::id_ref_any).collect();
                    if parts.iter().all(|part| numbers.bits.contains_key(part)) {
                        numbers.parts.insert(id, parts);
                    }
                }
                _ => {}
            }
        }
        numbers
    }

    /// Whether a constant is zero, or a vector with one.
    fn is_zero(&self, id: Word) -> bool {
        let mut parts = self.parts.get(&id).into_iter().flatten();
        parts.any(|part| self.bits.get(part).is_some_and(|bits| bits & SIZE == 0))
    }
}
