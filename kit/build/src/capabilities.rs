//! Removes the capabilities that a module does not need.
//!
//! The compiler gets the capabilities of all kernels at once, because it compiles all of them before it writes one module per
//! kernel. A driver refuses a module with a capability that its device lacks, even if the module does not use it.

use rspirv::dr::{Instruction, Module, Operand};
use rspirv::spirv::{Capability, Op};

/// What computing with halves, and reading them, takes.
const OF_HALVES: [Capability; 2] = [Capability::Float16, Capability::StorageBuffer16BitAccess];

/// Drops what is for halves from a module that has no 16-bit float.
pub fn drop_unused(module: &mut Module) {
    let is_half = |instruction: &Instruction| {
        instruction.class.opcode == Op::TypeFloat
            && instruction.operands.first() == Some(&Operand::LiteralBit32(16))
    };
    if !module.types_global_values.iter().any(is_half) {
        module.capabilities.retain(|instruction| {
            OF_HALVES.iter().all(|&it| instruction.operands != [Operand::Capability(it)])
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rspirv::dr::Builder;

    #[test]
    fn halves_are_asked_for_where_they_are() {
        for (width, left) in [(16, 3), (32, 1)] {
            let mut b = Builder::new();
            b.capability(Capability::Shader);
            OF_HALVES.into_iter().for_each(|capability| b.capability(capability));
            b.type_float(width, None);
            let mut module = b.module();
            drop_unused(&mut module);
            assert_eq!(module.capabilities.len(), left, "of floats of {width} bits");
        }
    }
}
