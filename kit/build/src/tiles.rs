//! Modules with cooperative matrices: the variants of kernels with tiles.
//!
//! They keep Vulkan's memory model, which cooperative matrices need. There, a barrier publishes only what is marked, and the compiler marks nothing.

use std::collections::{BTreeSet, HashMap};

use anyhow::{Result, anyhow, ensure};
use rspirv::dr::{self, Builder, Instruction, Module, Operand};
use rspirv::spirv::{Capability, MemoryAccess, MemorySemantics, Op, StorageClass, Word};

use crate::expand::definitions;

/// What the compiler needs for cooperative matrices. Kernels see the first one by `cfg`.
pub const CAPABILITIES: [Capability; 2] = [Capability::CooperativeMatrixKHR, Capability::Float16];

/// Loads and stores, and how many operands they have where their memory is not marked.
const ACCESSES: [(Op, usize); 4] = [
    (Op::Load, 1),
    (Op::Store, 2),
    (Op::CooperativeMatrixLoadKHR, 3),
    (Op::CooperativeMatrixStoreKHR, 4),
];

/// Whether a module has cooperative matrices.
pub fn has_some(module: &Module) -> bool {
    module.types_global_values.iter().any(|of| of.class.opcode == Op::TypeCooperativeMatrixKHR)
}

/// Marks the accesses of workgroup memory, and lets barriers publish them.
pub fn publish(module: &mut Module) {
    let mut builder = Builder::new_from_module(std::mem::take(module));
    let word = builder.type_int(32, 0);
    let wanted = MemorySemantics::MAKE_AVAILABLE | MemorySemantics::MAKE_VISIBLE;
    let all = builder.module_ref().all_inst_iter();
    let barriers = all.filter(|of| of.class.opcode == Op::ControlBarrier);
    let semantics = |of: &Instruction| of.operands.last().and_then(Operand::id_ref_any);
    let found: BTreeSet<Word> = barriers.filter_map(semantics).collect();
    let bits = |id: Word| {
        let found = builder.module_ref().types_global_values.iter();
        let constant = found.filter(|of| of.class.opcode == Op::Constant);
        match constant.clone().find(|of| of.result_id == Some(id))?.operands[..] {
            [Operand::LiteralBit32(bits)] => Some((id, bits | wanted.bits())),
            _ => None,
        }
    };
    let found: Vec<_> = found.into_iter().filter_map(bits).collect();
    let published: HashMap<Word, Word> =
        found.into_iter().map(|(id, bits)| (id, builder.constant_bit32(word, bits))).collect();
    *module = builder.module();
    let definitions = definitions(module);
    let of_workgroup = |pointer: &Operand| {
        let kind = definitions.get(&pointer.id_ref_any()?)?.result_type?;
        let class = definitions.get(&kind)?.operands.first()?;
        (*class == Operand::StorageClass(StorageClass::Workgroup)).then_some(())
    };
    for of in module.all_inst_iter_mut() {
        let is_access = ACCESSES.contains(&(of.class.opcode, of.operands.len()));
        if is_access && of_workgroup(&of.operands[0]).is_some() {
            of.operands.push(Operand::MemoryAccess(MemoryAccess::NON_PRIVATE_POINTER));
        } else if of.class.opcode == Op::ControlBarrier
            && let Some(Operand::IdMemorySemantics(id)) = of.operands.last_mut()
        {
            *id = *published.get(id).unwrap_or(id);
        }
    }
}

/// Fails where a kernel with tiles has none, or does something that each lane of a subgroup would do.
pub fn check(spirv: &[u8]) -> Result<()> {
    let module = dr::load_bytes(spirv).map_err(|error| anyhow!("the module is broken: {error}"))?;
    let has = |op: Op| module.all_inst_iter().any(|of| of.class.opcode == op);
    ensure!(
        has(Op::CooperativeMatrixMulAddKHR),
        "it declares `tiles`, and multiplies none: leave that out"
    );
    let definitions = definitions(&module);
    let class = |of: &Instruction| {
        let kind = definitions.get(&of.operands[0].id_ref_any()?)?.result_type?;
        definitions.get(&kind)?.operands.first().cloned()
    };
    let shared = [StorageClass::StorageBuffer, StorageClass::Workgroup].map(Operand::StorageClass);
    let is_repeated = |of: &Instruction| {
        let name = format!("{:?}", of.class.opcode);
        let is_store = of.class.opcode == Op::Store;
        name.starts_with("Atomic")
            || is_store && class(of).is_some_and(|class| shared.contains(&class))
    };
    ensure!(
        !module.all_inst_iter().any(is_repeated),
        "it has `tiles`, and writes numbers or has atomics, in helpers too: with cooperative matrices, each lane of a subgroup would do that. Store \
         tiles, and write numbers in another kernel"
    );
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lower::{bytes, count_fill};
    use rspirv::spirv::Scope;

    /// A module that writes a number of a storage class, between products if it has some.
    fn module(class: StorageClass, has_product: bool) -> Module {
        let mut b = Builder::new();
        let [word, float] = [b.type_int(32, 0), b.type_float(32, None)];
        let [scope, eight] = [Scope::Subgroup as u32, 8].map(|bits| b.constant_bit32(word, bits));
        let kind = b.type_cooperative_matrix_khr(float, scope, eight, eight, eight);
        let pointer = b.type_pointer(None, class, word);
        let variable = b.variable(pointer, None, class, None);
        let zero = b.constant_bit32(float, 0);
        let semantics = MemorySemantics::ACQUIRE_RELEASE | MemorySemantics::WORKGROUP_MEMORY;
        let semantics = b.constant_bit32(word, semantics.bits());
        count_fill(b, &[], |b| {
            let a = b.composite_construct(kind, None, [zero]).unwrap();
            if has_product {
                b.cooperative_matrix_mul_add_khr(kind, None, a, a, a, None).unwrap();
            }
            b.store(variable, eight, None, []).unwrap();
            b.control_barrier(scope, scope, semantics).unwrap();
        })
    }

    #[test]
    fn lanes_repeat_nothing() {
        let message = |class, has_product| match check(&bytes(&module(class, has_product))) {
            Ok(()) => String::new(),
            Err(error) => error.to_string(),
        };
        assert_eq!(message(StorageClass::Private, true), "");
        assert!(message(StorageClass::Private, false).contains("multiplies none"));
        for class in [StorageClass::Workgroup, StorageClass::StorageBuffer] {
            assert!(message(class, true).contains("writes numbers"), "{class:?}");
        }
    }

    #[test]
    fn barriers_publish_workgroup_memory() {
        for class in [StorageClass::Workgroup, StorageClass::Private] {
            let mut module = module(class, true);
            publish(&mut module);
            let of = |op| module.all_inst_iter().find(|of| of.class.opcode == op).unwrap();
            let is_marked = of(Op::Store).operands.len() == 3;
            assert_eq!(is_marked, class == StorageClass::Workgroup);
            let semantics = of(Op::ControlBarrier).operands[2].id_ref_any();
            let constant = module.types_global_values.iter().find(|of| of.result_id == semantics);
            let Operand::LiteralBit32(bits) = constant.unwrap().operands[0] else { panic!() };
            let published = MemorySemantics::MAKE_AVAILABLE | MemorySemantics::MAKE_VISIBLE;
            assert!(MemorySemantics::from_bits_retain(bits).contains(published));
        }
    }
}
