//! Modules in WGSL, for browsers.

use naga::back::wgsl::{WriterFlags, write_string};
use naga::front::spv;
use naga::valid::{Capabilities, ValidationFlags, Validator};

/// Translates a module to WGSL. Most variants need what browsers do not have.
///
/// # Errors
/// The reason, if the module is not for browsers.
pub fn to_wgsl(spirv: &[u8]) -> Result<String, String> {
    // The largest f32 as naga writes it. In decimal it is rounded up, so browsers refuse it
    // (https://github.com/gfx-rs/wgpu/issues/10106).
    const LARGEST: &str = "340282350000000000000000000000000000000f";
    const LARGEST_IN_HEX: &str = "0x1.fffffep+127f";
    let module = spv::parse_u8_slice(spirv, &spv::Options::default());
    let module = module.map_err(|error| error.to_string())?;
    let validate = |offered| {
        let info = Validator::new(ValidationFlags::all(), offered).validate(&module);
        info.map_err(|error| format!("{:?}", error.into_inner()))
    };
    // browsers want to be told of subgroups, and naga does not tell them
    let all = Capabilities::SHADER_FLOAT16_IN_FLOAT32;
    let (info, head) = match validate(all) {
        Ok(info) => (info, ""),
        Err(error) => match validate(all | Capabilities::SUBGROUP) {
            Ok(info) => (info, "enable subgroups;\n\n"),
            Err(_) => return Err(error),
        },
    };
    let text = write_string(&module, &info, WriterFlags::empty());
    let text = text.map_err(|error| error.to_string())?;
    Ok(head.to_owned() + &text.replace(LARGEST, LARGEST_IN_HEX))
}
