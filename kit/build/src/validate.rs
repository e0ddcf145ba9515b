//! Checks the modules against the SPIR-V specification, with `spirv-val`.

use std::io::Write;
use std::process::{Command, Stdio};

use anyhow::{Context, Result, bail};

use crate::artifacts::Artifacts;

/// Validates every module. Fails if one is invalid, or if there is no validator.
pub fn run(artifacts: &Artifacts) -> Result<()> {
    let mut invalid = Vec::new();
    for (name, spirv) in artifacts.modules() {
        if let Err(message) = validate(spirv)? {
            invalid.push(format!("{name}: {message}"));
        }
    }
    if !invalid.is_empty() {
        bail!("spirv-val refuses these modules:\n  {}", invalid.join("\n  "));
    }
    println!("spirv-val: {} modules are valid", artifacts.modules().count());
    Ok(())
}

/// The validator's verdict on one module.
fn validate(spirv: &[u8]) -> Result<Result<(), String>> {
    let mut child = Command::new("spirv-val")
        .args(["--target-env", "vulkan1.2", "-"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .context("cannot run spirv-val (Debian's package spirv-tools, or the Vulkan SDK)")?;
    // It reads everything before it writes anything, so this cannot deadlock.
    child.stdin.take().context("spirv-val takes no input")?.write_all(spirv)?;
    let output = child.wait_with_output()?;
    if output.status.success() {
        return Ok(Ok(()));
    }
    let message = [output.stdout, output.stderr].concat();
    Ok(Err(String::from_utf8_lossy(&message).trim().to_owned()))
}
