//! Keeps drivers from fusing and regrouping arithmetic: every operation gets the decoration
//! `NoContraction`, unless its kernel is declared `fused`.
//!
//! Rust-GPU has no option for it. Without it a driver can compute `a * b + c` with one rounding, or shorten `(x - a) + b`.
//! Results then differ between devices, and numbers in two parts (`shader-crate/src/unit_cube.rs`) lose the second part.

use anyhow::{Context, Result};
use rspirv::dr::{Instruction, Module, Operand};
use rspirv::spirv::{Decoration, Op};

/// Operations that can have the decoration.
const ARITHMETIC: [Op; 7] =
    [Op::FAdd, Op::FSub, Op::FMul, Op::FDiv, Op::FRem, Op::FNegate, Op::VectorTimesScalar];

/// Forbids a driver to change a module's arithmetic.
pub fn forbid(module: &mut Module) -> Result<()> {
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
