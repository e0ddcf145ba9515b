//! `cargo xtask kernels`: compiles the kernels to SPIR-V and writes the modules that the host
//! crate embeds. Everybody else builds organza without a SPIR-V compiler.

mod guide;

use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Parser, Subcommand};
use organza_build::{Options, Project};
// the registry of kernels has what the program is linked with
use organza_shaders as _;

#[derive(Parser)]
#[command(about = "Tasks of organza's developers")]
struct Cli {
    #[command(subcommand)]
    task: Task,
}

#[derive(Subcommand)]
enum Task {
    /// Compile the kernels to SPIR-V, into host/kernels
    Kernels(Options),
    /// Compile the kernel that docs/adding-a-kernel.md shows, in a copy of the shader crate
    Guide,
}

/// The workspace.
fn project() -> Project {
    // Cargo's word at run time: a copy of the workspace may share the compiled xtask.
    let xtask = std::env::var_os("CARGO_MANIFEST_DIR");
    let xtask = xtask.map_or(env!("CARGO_MANIFEST_DIR").into(), PathBuf::from);
    let root = xtask.parent().expect("xtask is a folder of the workspace").to_owned();
    let target = std::env::var_os("CARGO_TARGET_DIR").map_or("target".into(), PathBuf::from);
    Project {
        shader_crate: "shader-crate".into(),
        sources: ["kit/kernel", "kit/macros", "shader-crate"].map(String::from).into(),
        kernels: "host/kernels".into(),
        // Joining an absolute path gives that path.
        target: root.join(target),
        root,
    }
}

fn main() -> ExitCode {
    let result = match Cli::parse().task {
        Task::Guide => guide::run(&project()),
        Task::Kernels(options) => organza_build::run(&project(), options),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}
