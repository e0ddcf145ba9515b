//! Builds kernels: compiles a crate of `#[kernel]` functions to SPIR-V modules that drivers and naga accept, and writes their
//! manifest.
//!
//! A program that is linked with the kernels calls [`run`]; in organza that is `cargo xtask kernels`.

mod artifacts;
mod capabilities;
mod compile;
mod compiler;
mod contraction;
mod lower;
mod memory_model;
mod module;
mod validate;
mod watch;

use std::path::PathBuf;
use std::time::Instant;

use anyhow::Result;
use clap::Args;

pub use artifacts::Artifacts;
pub use compile::{build, compile};
pub use compiler::{Compiler, isolate};
pub use lower::lower;

/// A workspace with a crate of kernels.
#[derive(Clone, Debug)]
pub struct Project {
    /// The workspace's folder, with its `Cargo.lock`.
    pub root: PathBuf,
    /// The folder of the crate of kernels, relative to the workspace.
    pub shader_crate: String,
    /// Folders whose sources are compiled into kernels, that of the crate among them, relative to the workspace.
    pub sources: Vec<String>,
    /// The folder of the modules and their manifest, relative to the workspace.
    pub kernels: String,
    /// Cargo's target folder.
    pub target: PathBuf,
}

/// What to do with the compiled kernels.
#[derive(Args, Clone, Copy, Debug)]
pub struct Options {
    /// Compile and compare with the folder of modules instead of writing there: fails on any difference
    #[arg(long, conflicts_with = "watch")]
    pub check: bool,
    /// Hold each module against the SPIR-V specification with `spirv-val`
    #[arg(long)]
    pub validate: bool,
    /// Compile again whenever a kernel source is saved, until interrupted
    #[arg(long)]
    pub watch: bool,
}

/// Compiles the kernels of a project, and writes, checks or watches its modules.
///
/// # Errors
/// What the compiler or the check says.
pub fn run(project: &Project, options: Options) -> Result<()> {
    if options.watch {
        return watch::run(project, options.validate);
    }
    let start = Instant::now();
    isolate();
    let compiler = Compiler::find(&project.root.join(&project.shader_crate))?;
    eprintln!("compiling the kernels with {compiler}");
    let artifacts = compile(project, &compiler)?;
    let seconds = start.elapsed().as_secs_f64();
    println!("{artifacts}");
    if options.validate {
        validate::run(&artifacts)?;
    }
    let folder = project.root.join(&project.kernels);
    let kernels = &project.kernels;
    if options.check {
        artifacts.check(&folder)?;
        println!("{kernels} is what the sources give (compiled in {seconds:.1} s)");
    } else {
        let changed = artifacts.write(&folder)?;
        println!("{kernels}: {changed} files changed (compiled in {seconds:.1} s)");
    }
    Ok(())
}
