//! Checks that naga reads a module, as every device other than Vulkan does.

use anyhow::{Result, bail};
use naga::front::spv;
use naga::valid::{Capabilities, ValidationFlags, Validator};

/// What a kernel can need, and an adapter may have.
pub const OFFERED: Capabilities = Capabilities::SHADER_FLOAT16.union(Capabilities::SUBGROUP);

/// Fails with the reason if naga refuses the module.
pub fn check(spirv: &[u8]) -> Result<()> {
    let options = spv::Options::default();
    let module = match spv::parse_u8_slice(spirv, &options) {
        Ok(module) => module,
        Err(error) => bail!("naga cannot read the module: {error}"),
    };
    match Validator::new(ValidationFlags::all(), OFFERED).validate(&module) {
        Ok(_) => Ok(()),
        Err(error) => bail!("naga refuses the module: {:?}", error.into_inner()),
    }
}
