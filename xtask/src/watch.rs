//! Compiles the kernels again and again while they are being written.

use std::process::Command;
use std::thread;
use std::time::Duration;

use anyhow::{Context, Result};
use organza_manifest::source_hash;

use crate::Workspace;

/// How long after saving a file the compiler starts, at most.
const INTERVAL: Duration = Duration::from_millis(300);

/// Runs `cargo xtask kernels` now and after every change of the sources. Each run is a process of
/// its own: xtask holds the kernels' declarations, so it must be compiled again, too.
pub fn run(workspace: &Workspace, validate: bool) -> Result<()> {
    let mut compiled = None;
    loop {
        // A file may be missing for a moment while an editor replaces it.
        let hash = source_hash(&workspace.shader_crate).ok();
        if hash.is_some() && hash != compiled {
            compile(workspace, validate)?;
            println!("watching shader-crate (end with Ctrl-C)");
            compiled = hash;
        }
        thread::sleep(INTERVAL);
    }
}

fn compile(workspace: &Workspace, validate: bool) -> Result<()> {
    let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or("cargo".into()));
    cargo.current_dir(&workspace.root).args(["run", "--quiet", "--package", "xtask"]);
    if cfg!(windows) {
        // A program that runs cannot be replaced there: let the child have its own.
        cargo.arg("--target-dir").arg(workspace.target.join("watch"));
    }
    cargo.args(["--", "kernels"]);
    if validate {
        cargo.arg("--validate");
    }
    // A failed build has told its reason: wait for the next change.
    cargo.status().context("cannot run cargo")?;
    Ok(())
}
