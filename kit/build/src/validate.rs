//! Checks modules as naga reads them.

use anyhow::{Result, bail};
use naga::Module;
use naga::front::spv;
use naga::valid::{Capabilities, ValidationFlags, Validator};

/// What a kernel can need, and an adapter may have.
const OFFERED: Capabilities = Capabilities::SUBGROUP
    .union(Capabilities::SHADER_FLOAT16_IN_FLOAT32)
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
