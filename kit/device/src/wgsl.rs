//! Modules in WGSL, for browsers.

use wgpu::naga::back::wgsl::{WriterFlags, write_string};
use wgpu::naga::front::spv;
use wgpu::naga::valid::{Capabilities, ValidationFlags, Validator};

use crate::modules::CompiledKernel;
use crate::{Error, Result};

impl CompiledKernel {
    /// Translates the module to WGSL, for browsers.
    ///
    /// # Errors
    /// [`Error::StaleKernels`] if it needs what browsers do not have, as most variants do.
    pub fn to_wgsl(&self) -> Result<String> {
        translated(self.spirv()).map_err(|error| {
            let reason = format!("`{}` is not for browsers: {error}", self.entry().name);
            Error::StaleKernels { reason }
        })
    }
}

fn translated(spirv: &[u8]) -> std::result::Result<String, String> {
    // The largest f32 as naga writes it. In decimal it is rounded up, so browsers refuse it
    // (https://github.com/gfx-rs/wgpu/issues/10106).
    const LARGEST: &str = "340282350000000000000000000000000000000f";
    const LARGEST_IN_HEX: &str = "0x1.fffffep+127f";
    let module = spv::parse_u8_slice(spirv, &spv::Options::default());
    let module = module.map_err(|error| error.to_string())?;
    let info = Validator::new(ValidationFlags::all(), Capabilities::empty()).validate(&module);
    let info = info.map_err(|error| format!("{:?}", error.into_inner()))?;
    let text = write_string(&module, &info, WriterFlags::empty());
    Ok(text.map_err(|error| error.to_string())?.replace(LARGEST, LARGEST_IN_HEX))
}
