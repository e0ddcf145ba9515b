//! Tools that are tests of the project: its cases, its compiled kernels and its devices are there.

use std::process::Command;

use anyhow::{Context, Result, ensure};

use crate::Project;

/// Cargo, in the workspace.
pub fn cargo(project: &Project) -> Command {
    let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or("cargo".into()));
    cargo.current_dir(&project.root);
    cargo
}

/// Runs cargo with arguments, and shows what it prints.
pub fn run(project: &Project, arguments: &str, more: &[String]) -> Result<()> {
    let mut cargo = cargo(project);
    cargo.args(arguments.split_whitespace()).args(more);
    let status = cargo.status().context("cannot run cargo")?;
    ensure!(status.success(), "`cargo {arguments}` failed: {status}");
    Ok(())
}
