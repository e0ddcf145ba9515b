//! Has naga read a module, as every device does that is not Vulkan.

use anyhow::{Result, bail};
use naga::front::spv;
use naga::valid::{Capabilities, ValidationFlags, Validator};

/// Fails where naga refuses the module, and says why.
pub fn check(spirv: &[u8]) -> Result<()> {
    let options = spv::Options::default();
    let module = match spv::parse_u8_slice(spirv, &options) {
        Ok(module) => module,
        Err(error) => bail!("naga cannot read the module: {error}"),
    };
    // what wgpu asks an adapter for, where a kernel needs it
    let offered = Capabilities::SHADER_FLOAT16;
    match Validator::new(ValidationFlags::all(), offered).validate(&module) {
        Ok(_) => Ok(()),
        Err(error) => bail!("naga refuses the module: {:?}", error.into_inner()),
    }
}
