//! Checks that naga reads a module, as every device other than Vulkan does.

use anyhow::{Result, bail};
use naga::front::spv;
use naga::valid::{Capabilities, ValidationFlags, Validator};

/// Fails with the reason if naga refuses the module.
pub fn check(spirv: &[u8]) -> Result<()> {
    let options = spv::Options::default();
    let module = match spv::parse_u8_slice(spirv, &options) {
        Ok(module) => module,
        Err(error) => bail!("naga cannot read the module: {error}"),
    };
    // features that an adapter may have
    let offered = Capabilities::SHADER_FLOAT16 | Capabilities::SUBGROUP;
    match Validator::new(ValidationFlags::all(), offered).validate(&module) {
        Ok(_) => Ok(()),
        Err(error) => bail!("naga refuses the module: {:?}", error.into_inner()),
    }
}
