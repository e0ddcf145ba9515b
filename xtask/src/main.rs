//! `cargo xtask kernels`: compiles the kernels to SPIR-V and WGSL, and writes the modules that the host
//! crate embeds. Everybody else builds organza without a SPIR-V compiler.

mod new;

use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Parser, Subcommand};
use muslin_build::{IsaOptions, Options, Project};
// linking with the kernels fills their registry
use organza_shaders as _;

#[derive(Parser)]
#[command(about = "Tasks of organza's developers")]
struct Cli {
    #[command(subcommand)]
    task: Task,
}

#[derive(Subcommand)]
enum Task {
    /// Compile the kernels to SPIR-V and WGSL, into host/render/kernels
    Kernels(Options),
    /// Show what the compiler of an AMD GPU makes of the kernels, without the GPU
    Isa(IsaOptions),
    /// Make a separate project in a new folder: kernels, tests on the CPU and two ways on a GPU, a picture
    New {
        /// The folder: it must be new or empty
        folder: PathBuf,
    },
}

/// The workspace.
fn project() -> Project {
    Project {
        sources: ["kit/kernel", "kit/macros", "shader-crate"].map(String::from).into(),
        kernels: "host/render/kernels".into(),
        wgsl: true,
        ..Project::of_xtask(env!("CARGO_MANIFEST_DIR"), "shader-crate")
    }
}

fn main() -> ExitCode {
    muslin_build::exit_code(match Cli::parse().task {
        Task::New { folder } => new::run(&project(), &folder),
        Task::Kernels(options) => muslin_build::run(&project(), options),
        Task::Isa(options) => muslin_build::isa(&project(), &options),
    })
}
