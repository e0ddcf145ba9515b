//! Rewrites compiled modules from Vulkan's memory model, the only one that Rust-GPU has for Vulkan, to GLSL's.
//!
//! A module with Vulkan's memory model needs the device feature `vulkanMemoryModel`, which wgpu does not enable: the
//! validation layers report every such module. Also, Rust-GPU never marks an access as non-private. So in that model,
//! strictly, no barrier would make a write to workgroup memory visible. In GLSL's model, which naga and GLSL
//! compilers use, it does.
//!
//! A storage buffer is another matter: there, GLSL's model only promises that a barrier makes a write visible if the buffer is
//! `Coherent`. The buffers that a kernel with storage barriers writes become so.

use std::collections::BTreeSet;

use anyhow::{Context, Result, bail};
use rspirv::dr::{Builder, Instruction, Module, Operand};
use rspirv::spirv::{
    AddressingModel, Capability, Decoration, MemoryAccess, MemoryModel, MemorySemantics, Op, Scope,
    StorageClass, Word,
};

/// Memory semantics that Vulkan's model allows and GLSL's does not.
const SEMANTICS: MemorySemantics = MemorySemantics::OUTPUT_MEMORY
    .union(MemorySemantics::MAKE_AVAILABLE)
    .union(MemorySemantics::MAKE_VISIBLE)
    .union(MemorySemantics::VOLATILE);
const ACCESSES: MemoryAccess = MemoryAccess::MAKE_POINTER_AVAILABLE
    .union(MemoryAccess::MAKE_POINTER_VISIBLE)
    .union(MemoryAccess::NON_PRIVATE_POINTER);

/// Changes a module's memory model to GLSL's.
pub fn lower(module: &mut Module) -> Result<()> {
    let model = module.memory_model.as_mut().context("the module has no memory model")?;
    model.operands = vec![
        Operand::AddressingModel(AddressingModel::Logical),
        Operand::MemoryModel(MemoryModel::GLSL450),
    ];
    module.capabilities.retain(|instruction| {
        let [Operand::Capability(capability)] = instruction.operands[..] else {
            return true;
        };
        !matches!(
            capability,
            Capability::VulkanMemoryModel | Capability::VulkanMemoryModelDeviceScope
        )
    });
    refuse_without_equivalent(module)?;
    widen_scopes(module);
    if has_storage_barrier(module) {
        decorate_coherent(module);
    }
    Ok(())
}

fn has_storage_barrier(module: &Module) -> bool {
    module.all_inst_iter().filter(|i| i.class.opcode == Op::ControlBarrier).any(|barrier| {
        let Some(&Operand::IdMemorySemantics(id)) = barrier.operands.last() else { return false };
        let semantics = MemorySemantics::from_bits_retain(constant(module, id).unwrap_or(0));
        semantics.contains(MemorySemantics::UNIFORM_MEMORY)
    })
}

/// Makes the storage buffers coherent that are written. The decoration is the struct's member's, as GLSL compilers
/// write it: naga leaves that out, so that WGSL, where a barrier needs no decoration, has none.
fn decorate_coherent(module: &mut Module) {
    let is_read_only = |id: Word| {
        let decoration = [Operand::IdRef(id), Operand::Decoration(Decoration::NonWritable)];
        module.annotations.iter().any(|annotation| annotation.operands == decoration)
    };
    let pointee = |pointer: Word| {
        let found = module.types_global_values.iter().find(|i| i.result_id == Some(pointer))?;
        found.operands.last()?.id_ref_any()
    };
    let storage = Operand::StorageClass(StorageClass::StorageBuffer);
    let buffers = module.types_global_values.iter().filter(|instruction| {
        instruction.class.opcode == Op::Variable
            && instruction.operands.first() == Some(&storage)
            && !instruction.result_id.is_some_and(is_read_only)
    });
    let structs: BTreeSet<Word> = buffers.filter_map(|i| pointee(i.result_type?)).collect();
    module.annotations.extend(structs.into_iter().map(|id| {
        let member = Operand::LiteralBit32(0);
        let coherent = Operand::Decoration(Decoration::Coherent);
        let operands = vec![Operand::IdRef(id), member, coherent];
        Instruction::new(Op::MemberDecorate, None, None, operands)
    }));
}

/// GLSL's model has no scope of a queue family. `Device` contains them all, and replaces it.
fn widen_scopes(module: &mut Module) {
    let mut builder = Builder::new_from_module(std::mem::take(module));
    let word = builder.type_int(32, 0);
    let constants = |scope: Scope| {
        let number = [Operand::LiteralBit32(scope as u32)];
        let all = builder.module_ref().types_global_values.iter();
        all.filter(move |of| of.class.opcode == Op::Constant && of.operands == number)
    };
    let narrow: BTreeSet<_> = constants(Scope::QueueFamily).filter_map(|of| of.result_id).collect();
    let wide = constants(Scope::Device).find(|of| of.result_type == Some(word));
    let wide = wide.and_then(|of| of.result_id);
    let wide = wide.unwrap_or_else(|| builder.constant_bit32(word, Scope::Device as u32));
    *module = builder.module();
    for operand in module.all_inst_iter_mut().flat_map(|of| &mut of.operands) {
        match operand {
            Operand::IdScope(scope) if narrow.contains(scope) => *scope = wide,
            _ => {}
        }
    }
}

fn refuse_without_equivalent(module: &Module) -> Result<()> {
    for operand in module.all_inst_iter().flat_map(|instruction| &instruction.operands) {
        match *operand {
            Operand::MemoryAccess(access) if access.intersects(ACCESSES) => {
                bail!("a memory access with {access:?}, which GLSL's memory model has not");
            }
            Operand::IdMemorySemantics(id) => {
                let bits = constant(module, id).context("memory semantics are a constant")?;
                let semantics = MemorySemantics::from_bits_retain(bits);
                if semantics.intersects(SEMANTICS) {
                    bail!("memory semantics {semantics:?}, which GLSL's memory model has not");
                }
            }
            _ => {}
        }
    }
    Ok(())
}

/// The value of a 32-bit constant.
fn constant(module: &Module, id: Word) -> Option<u32> {
    let found = module.types_global_values.iter().find(|i| i.result_id == Some(id))?;
    match (found.class.opcode, found.operands.as_slice()) {
        (Op::Constant, &[Operand::LiteralBit32(value)]) => Some(value),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lower::count_fill;
    use rspirv::dr;

    fn lower(spirv: &[u8]) -> Result<Vec<u8>> {
        crate::lower::lower(spirv, true, [1; 3])
    }

    /// A module with one atomic addition.
    fn module(semantics: MemorySemantics) -> Vec<u8> {
        let mut b = Builder::new();
        let uint = b.type_int(32, 0);
        let pointer = b.type_pointer(None, StorageClass::Workgroup, uint);
        let counter = b.variable(pointer, None, StorageClass::Workgroup, None);
        let scope = b.constant_bit32(uint, Scope::QueueFamily as u32);
        let semantics = b.constant_bit32(uint, semantics.bits());
        let module = count_fill(b, &[], |b| {
            // The number five is also added: that must not change.
            b.atomic_i_add(uint, None, counter, scope, semantics, scope).unwrap();
        });
        crate::lower::bytes(&module)
    }

    #[test]
    fn scopes_become_wider_and_numbers_stay() {
        let lowered = lower(&module(MemorySemantics::RELAXED)).unwrap();
        let module = dr::load_bytes(&lowered).unwrap();
        let atomic = module.all_inst_iter().find(|i| i.class.opcode == Op::AtomicIAdd).unwrap();
        let [_, Operand::IdScope(scope), _, Operand::IdRef(added)] = atomic.operands[..] else {
            panic!("{atomic:?}");
        };
        assert_eq!(constant(&module, scope), Some(Scope::Device as u32));
        assert_eq!(constant(&module, added), Some(Scope::QueueFamily as u32));
        assert_eq!(module.capabilities.len(), 1);
        assert_eq!(
            module.memory_model.unwrap().operands[1],
            Operand::MemoryModel(MemoryModel::GLSL450)
        );
        assert_eq!(lower(&lowered).unwrap(), lowered);
    }

    #[test]
    fn semantics_without_equivalent_are_refused() {
        let error = lower(&module(MemorySemantics::MAKE_VISIBLE)).unwrap_err();
        assert!(error.to_string().contains("MAKE_VISIBLE"), "{error}");
    }

    /// Decorations of members, in a module with two buffers, of which one is written, and one barrier.
    fn member_decorations(semantics: MemorySemantics) -> Vec<Vec<Operand>> {
        let mut b = Builder::new();
        let uint = b.type_int(32, 0);
        for is_read_only in [true, false] {
            let values = b.type_runtime_array(uint);
            // each is a type of its own
            let buffer = b.type_struct_id(None, [values]);
            let pointer = b.type_pointer(None, StorageClass::StorageBuffer, buffer);
            let variable = b.variable(pointer, None, StorageClass::StorageBuffer, None);
            if is_read_only {
                b.decorate(variable, Decoration::NonWritable, []);
            }
        }
        let scope = b.constant_bit32(uint, Scope::Workgroup as u32);
        let semantics = b.constant_bit32(uint, semantics.bits());
        let mut module = count_fill(b, &[], |b| {
            b.control_barrier(scope, scope, semantics).unwrap();
        });
        super::lower(&mut module).unwrap();
        let members =
            module.annotations.into_iter().filter(|i| i.class.opcode == Op::MemberDecorate);
        members.map(|instruction| instruction.operands).collect()
    }

    #[test]
    fn a_storage_barrier_makes_written_buffers_coherent() {
        let orders = MemorySemantics::ACQUIRE_RELEASE | MemorySemantics::WORKGROUP_MEMORY;
        assert!(member_decorations(orders).is_empty());
        let [found] = &member_decorations(orders | MemorySemantics::UNIFORM_MEMORY)[..] else {
            panic!("one buffer is written")
        };
        assert_eq!(
            found[1..],
            [Operand::LiteralBit32(0), Operand::Decoration(Decoration::Coherent)]
        );
    }
}
