//! Does something again whenever a source is saved.

use std::thread;
use std::time::Duration;

use anyhow::{Context, Result};
use muslin_manifest::source_hash;

use crate::{Project, tool};

/// Longest time between saving a file and starting the compiler.
const INTERVAL: Duration = Duration::from_millis(300);

/// Does something now and after every change of the sources.
pub fn run(project: &Project, mut each: impl FnMut() -> Result<()>) -> Result<()> {
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
    let mut cargo = tool::cargo(project);
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
