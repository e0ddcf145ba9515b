//! Runs tools that are tests of the project, where its cases, its compiled kernels and its devices are; and runs something again
//! whenever a source is saved.

use std::process::Command;
use std::thread;
use std::time::Duration;

use anyhow::{Context, Result, ensure};
use muslin_manifest::source_hash;

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

/// Longest time between saving a file and starting the compiler.
const INTERVAL: Duration = Duration::from_millis(300);

/// Does something now and after every change of the sources.
pub fn watch(project: &Project, mut each: impl FnMut() -> Result<()>) -> Result<()> {
    let mut compiled = None;
    loop {
        // A file may be missing for a moment while an editor replaces it.
        let hash = source_hash(&project.root, &project.sources).ok();
        if hash.is_some() && hash != compiled {
            each()?;
            println!("watching {} (end with Ctrl-C)", project.sources.join(", "));
            compiled = hash;
        }
        thread::sleep(INTERVAL);
    }
}

/// Runs `cargo xtask kernels`. It is a new process: the xtask contains the kernels' declarations, so it must be compiled again, too.
pub fn compile(project: &Project, validate: bool) -> Result<()> {
    let mut cargo = cargo(project);
    cargo.args(["run", "--quiet", "--package", "xtask"]);
    if cfg!(windows) {
        // A running program cannot be replaced there, so the child has its own folder.
        cargo.env("CARGO_TARGET_DIR", project.target.join("watch"));
    }
    cargo.args(["--", "kernels"]);
    if validate {
        cargo.arg("--validate");
    }
    // A failed build has printed its reason: wait for the next change.
    cargo.status().context("cannot run cargo")?;
    Ok(())
}
