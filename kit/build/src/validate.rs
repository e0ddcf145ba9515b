//! Checks modules as naga reads them. Translates them to WGSL.

use anyhow::{Result, bail};
use naga::Module;
use naga::back::wgsl::{WriterFlags, write_string};
use naga::front::spv;
use naga::valid::{Capabilities, ValidationFlags, Validator};

/// What a kernel can need, and an adapter may have.
const OFFERED: Capabilities = Capabilities::SUBGROUP
    .union(Capabilities::SHADER_INT64)
    .union(Capabilities::SHADER_INT64_ATOMIC_ALL_OPS);

/// Reads a module.
pub fn read(spirv: &[u8]) -> Result<Module> {
    match spv::parse_u8_slice(spirv, &spv::Options::default()) {
        Ok(module) => Ok(module),
        Err(error) => bail!("naga cannot read the module: {error}"),
    }
}

/// Fails with the reason if naga refuses the module.
pub fn check(spirv: &[u8]) -> Result<()> {
    match Validator::new(ValidationFlags::all(), OFFERED).validate(&read(spirv)?) {
        Ok(_) => Ok(()),
        Err(error) => {
            let error = format!("{:?}", error.into_inner());
            let cause = CAUSES.iter().find(|(part, _)| error.contains(part));
            let cause =
                cause.map_or("there is something that GPUs do not take", |(_, cause)| cause);
            bail!("{cause}. naga says: {error}")
        }
    }
}

/// Parts of naga's messages, and our words for them.
const CAUSES: [(&str, &str); 2] = [
    (
        "InvalidData",
        "a closure or a struct holds a buffer, which GPUs cannot; make the closure a function with the buffer as a parameter, and what takes \
         the struct `#[inline(always)]`",
    ),
    (
        "InvalidArgumentType",
        "a function takes a pointer that not every GPU has; make it `#[inline(always)]`",
    ),
];

/// Translates a module to WGSL.
pub fn to_wgsl(spirv: &[u8]) -> Result<String> {
    // The largest f32 as naga writes it. In decimal it is rounded up, so browsers refuse it
    // (https://github.com/gfx-rs/wgpu/issues/10106).
    const LARGEST: &str = "340282350000000000000000000000000000000f";
    const LARGEST_IN_HEX: &str = "0x1.fffffep+127f";
    let module = read(spirv)?;
    let validate = |offered| {
        Validator::new(ValidationFlags::all(), offered).validate(&module).map_err(Box::new)
    };
    // browsers want to be told of subgroups, and naga does not tell them
    let (info, head) = match validate(Capabilities::empty()) {
        Ok(info) => (info, ""),
        Err(error) => match validate(Capabilities::SUBGROUP) {
            Ok(info) => (info, "enable subgroups;\n\n"),
            Err(_) => bail!("the module is not for browsers: {:?}", error.into_inner()),
        },
    };
    let text = write_string(&module, &info, WriterFlags::empty())?;
    Ok(head.to_owned() + &text.replace(LARGEST, LARGEST_IN_HEX))
}
