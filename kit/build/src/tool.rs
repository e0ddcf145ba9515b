//! The tools of a project: its tests, and its machine code.

use std::env;
use std::process::Command;

use anyhow::{Context, Result, ensure};
use muslin_manifest::FILE_NAME;

use crate::Project;

/// Runs cargo in the workspace, with arguments, and shows what it prints.
pub fn run(project: &Project, arguments: &str, more: &[String]) -> Result<()> {
    let mut cargo = Command::new(env::var_os("CARGO").unwrap_or("cargo".into()));
    cargo.current_dir(&project.root).args(arguments.split_whitespace()).args(more);
    let status = cargo.status().context("cannot run cargo")?;
    ensure!(status.success(), "`cargo {arguments}` failed: {status}");
    Ok(())
}

/// Prints what RADV makes of a project's compiled kernels, for families of GPUs. It needs none of these.
pub fn isa(project: &Project, families: &[String]) -> Result<()> {
    let folder = project.root.join(&project.kernels);
    if muslin_isa::answer(&folder) {
        return Ok(());
    }
    ensure!(
        folder.join(FILE_NAME).exists(),
        "there are no compiled kernels in {}: run `cargo xtask kernels` first",
        folder.display()
    );
    for family in families {
        let mut child = Command::new(env::current_exe()?);
        println!("{}", muslin_isa::compile(&folder, family, child.arg("isa"))?);
    }
    Ok(())
}
