//! `cargo xtask kernels`: compiles the kernels to SPIR-V and writes the modules that the host
//! crate embeds. Everybody else builds organza without a SPIR-V compiler.

mod artifacts;
mod capabilities;
mod compile;
mod compiler;
mod contraction;
mod guide;
mod lower;
mod memory_model;
mod module;
mod validate;
mod watch;

use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Instant;

use anyhow::Result;
use clap::{Args, Parser, Subcommand};

use compiler::Compiler;

#[derive(Parser)]
#[command(about = "Tasks of organza's developers")]
struct Cli {
    #[command(subcommand)]
    task: Task,
}

#[derive(Subcommand)]
enum Task {
    /// Compile the kernels to SPIR-V, into host/kernels
    Kernels(Kernels),
    /// Compile the kernel that docs/adding-a-kernel.md shows, in a copy of the shader crate
    Guide,
}

/// What to do with the compiled kernels.
#[derive(Args)]
struct Kernels {
    /// Compile and compare with host/kernels instead of writing there: fails on any difference
    #[arg(long, conflicts_with = "watch")]
    check: bool,
    /// Hold each module against the SPIR-V specification with `spirv-val`
    #[arg(long)]
    validate: bool,
    /// Compile again whenever a kernel source is saved, until interrupted
    #[arg(long)]
    watch: bool,
}

/// The places in the workspace that the tasks read and write.
struct Workspace {
    root: PathBuf,
    shader_crate: PathBuf,
    kernels: PathBuf,
    target: PathBuf,
}

impl Workspace {
    fn find() -> Self {
        // Cargo's word at run time: a copy of the workspace may share the compiled xtask.
        let xtask = std::env::var_os("CARGO_MANIFEST_DIR");
        let xtask = xtask.map_or(env!("CARGO_MANIFEST_DIR").into(), PathBuf::from);
        let root = xtask.parent().expect("xtask is a folder of the workspace").to_owned();
        let target = std::env::var_os("CARGO_TARGET_DIR").map_or("target".into(), PathBuf::from);
        Self {
            shader_crate: root.join("shader-crate"),
            kernels: root.join("host/kernels"),
            // Joining an absolute path gives that path.
            target: root.join(target),
            root,
        }
    }
}

fn main() -> ExitCode {
    let workspace = Workspace::find();
    let result = match Cli::parse().task {
        Task::Guide => guide::run(&workspace),
        Task::Kernels(options) if options.watch => watch::run(&workspace, options.validate),
        Task::Kernels(options) => kernels(&workspace, &options),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}

fn kernels(workspace: &Workspace, options: &Kernels) -> Result<()> {
    let start = Instant::now();
    compiler::isolate();
    let compiler = Compiler::find(&workspace.shader_crate)?;
    eprintln!("compiling the kernels with {compiler}");
    let artifacts = compile::compile(workspace, &compiler)?;
    let seconds = start.elapsed().as_secs_f64();
    println!("{artifacts}");
    if options.validate {
        validate::run(&artifacts)?;
    }
    if options.check {
        artifacts.check(&workspace.kernels)?;
        println!("host/kernels is what the sources give (compiled in {seconds:.1} s)");
    } else {
        let changed = artifacts.write(&workspace.kernels)?;
        println!("host/kernels: {changed} files changed (compiled in {seconds:.1} s)");
    }
    Ok(())
}
