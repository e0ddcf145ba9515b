//! The passes over a module, between the compiler and the folder of modules.

use std::collections::BTreeSet;

use anyhow::{Result, anyhow, ensure};
use rspirv::binary::Assemble;
use rspirv::dr::{self, Instruction, Module, Operand};
use rspirv::spirv::{Capability, ExecutionMode, Op};

use crate::{
    atomic_arguments, contraction, declarations, expand, loops, memory_model, not_numbers,
    small_integers, tiles,
};

/// The module for drivers, with the size of its workgroups. With `fused`, they may regroup its arithmetic.
///
/// # Errors
/// If the module has something that it must not have.
pub fn lower(spirv: &[u8], fused: bool, size: [u32; 3]) -> Result<Vec<u8>> {
    let mut module = dr::load_bytes(spirv).map_err(|error| anyhow!("a broken module: {error}"))?;
    ensure!(
        !module.all_inst_iter().any(|instruction| instruction.class.opcode == Op::FRem),
        "it takes `%` of floats, in helpers too, which a GPU rounds several times: write `x - y * math::truncate(x / y)`"
    );
    // what other kernels use is not of interest
    declarations::sort(&mut module);
    declarations::drop_layouts(&mut module);
    expand::expand(&mut module);
    small_integers::widen(&mut module)?;
    if tiles::has_some(&module) {
        tiles::publish(&mut module);
    } else {
        memory_model::lower(&mut module)?;
    }
    loops::end_at_conditions(&mut module)?;
    atomic_arguments::copy(&mut module);
    set_workgroup_size(&mut module, size);
    drop_unused_capabilities(&mut module);
    if !fused {
        contraction::forbid(&mut module)?;
    }
    not_numbers::replace(&mut module);
    declarations::sort(&mut module);
    declarations::renumber(&mut module);
    Ok(bytes(&module))
}

/// A module as its file has it.
pub fn bytes(module: &Module) -> Vec<u8> {
    module.assemble().into_iter().flat_map(u32::to_le_bytes).collect()
}

/// Writes the size of a workgroup: in the source it is an expression, which the compiler's attribute does not take.
fn set_workgroup_size(module: &mut Module, size: [u32; 3]) {
    for mode in &mut module.execution_modes {
        if let [_, Operand::ExecutionMode(ExecutionMode::LocalSize), sizes @ ..] =
            &mut mode.operands[..]
        {
            sizes.iter_mut().zip(size).for_each(|(to, size)| *to = Operand::LiteralBit32(size));
        }
    }
}

/// The optimizer within the compiler regroups floats, and takes `x * 0.0` for 0, unless a module has this capability. Drivers do not get it:
/// wgpu enables no feature for it.
pub const AS_WRITTEN: Capability = Capability::SignedZeroInfNanPreserve;

/// The capabilities of subgroups, which the compiler gives to every module.
pub const SUBGROUPS: [Capability; 4] = [
    Capability::GroupNonUniform,
    Capability::GroupNonUniformArithmetic,
    Capability::GroupNonUniformBallot,
    Capability::GroupNonUniformShuffle,
];

/// The capabilities of 64-bit sums, which the compiler gives to every module.
pub const WIDE: [Capability; 2] = [Capability::Int64, Capability::Int64Atomics];

/// Whether a type is a 64-bit integer's.
fn is_wide(of: &Instruction) -> bool {
    of.class.opcode == Op::TypeInt && of.operands[0] == Operand::LiteralBit32(64)
}

/// Drops [`AS_WRITTEN`], and the capabilities of subgroups and of 64-bit sums that nothing needs: a device can lack them.
fn drop_unused_capabilities(module: &mut Module) {
    let of_functions = module.functions.iter().flat_map(|function| function.all_inst_iter());
    let mut needed: BTreeSet<_> =
        of_functions.flat_map(|i| i.class.capabilities).copied().collect();
    let operands = module.annotations.iter().flat_map(|annotation| &annotation.operands);
    needed.extend(operands.flat_map(Operand::required_capabilities));
    if module.types_global_values.iter().any(is_wide) {
        needed.extend(WIDE);
    }
    let optional = [&SUBGROUPS[..], &WIDE].concat();
    module.capabilities.retain(|instruction| match instruction.operands[..] {
        [Operand::Capability(of)] => {
            of != AS_WRITTEN && (!optional.contains(&of) || needed.contains(&of))
        }
        _ => true,
    });
}

/// A module of the kernel `count_fill` in the compiler's style, with another body.
#[cfg(test)]
pub fn count_fill(
    mut b: dr::Builder,
    buffers: &[u32],
    body: impl FnOnce(&mut dr::Builder),
) -> Module {
    use rspirv::spirv::{AddressingModel, ExecutionModel, FunctionControl, MemoryModel};

    b.set_version(1, 5);
    b.capability(Capability::Shader);
    b.capability(Capability::VulkanMemoryModel);
    b.memory_model(AddressingModel::Logical, MemoryModel::Vulkan);
    let void = b.type_void();
    let kind = b.type_function(void, []);
    let main = b.begin_function(void, None, FunctionControl::NONE, kind).unwrap();
    b.begin_block(None).unwrap();
    body(&mut b);
    b.ret().unwrap();
    b.end_function().unwrap();
    b.entry_point(ExecutionModel::GLCompute, main, "count_fill", buffers);
    b.execution_mode(main, ExecutionMode::LocalSize, [64, 1, 1]);
    b.module()
}
