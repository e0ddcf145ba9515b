//! The passes over a module, between the compiler and the folder of modules.

use anyhow::{Result, anyhow};
use rspirv::binary::Assemble;
use rspirv::dr;

use crate::{atomic_arguments, contraction, declarations, ids, loops, memory_model};

/// The module for drivers. With `fused`, they may regroup its arithmetic.
///
/// # Errors
/// If the module has something that it must not have.
pub fn lower(spirv: &[u8], fused: bool) -> Result<Vec<u8>> {
    let mut module = dr::load_bytes(spirv).map_err(|error| anyhow!("a broken module: {error}"))?;
    memory_model::lower(&mut module)?;
    loops::end_at_conditions(&mut module)?;
    atomic_arguments::copy(&mut module)?;
    if !fused {
        contraction::forbid(&mut module)?;
    }
    declarations::sort(&mut module);
    ids::renumber(&mut module);
    Ok(module.assemble().into_iter().flat_map(u32::to_le_bytes).collect())
}
