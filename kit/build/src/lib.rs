//! Builds kernels: compiles a crate of `#[kernel]` functions to SPIR-V modules that drivers and naga accept, and writes their
//! manifest.
//!
//! A program that is linked with the kernels is an [`xtask`], or calls [`run`] if it has more to do. Usually that is `cargo xtask kernels`.

mod artifacts;
mod atomic_arguments;
mod compile;
mod compiler;
mod contraction;
mod declarations;
mod ids;
mod isa;
mod loops;
mod lower;
mod memory_model;
mod module;
mod naga_check;
mod rules;
mod validate;
mod watch;
mod wgsl;

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;

use anyhow::Result;
use clap::{Args, Parser};

pub use artifacts::Artifacts;
pub use compile::{build, compile};
pub use compiler::{Compiler, isolate};
pub use isa::{IsaOptions, isa};
pub use lower::lower;

/// A workspace with a crate of kernels.
#[derive(Clone, Debug)]
pub struct Project {
    /// The workspace's folder, with its `Cargo.lock`.
    pub root: PathBuf,
    /// The folder of the crate of kernels, relative to the workspace.
    pub shader_crate: String,
    /// Folders with sources of kernels, including that of the crate, relative to the workspace.
    pub sources: Vec<String>,
    /// The folder of the modules and their manifest, relative to the workspace.
    pub kernels: String,
    /// Whether to translate the kernels to WGSL, too, for browsers: this needs the feature `wgsl`. Variants are left
    /// out, because browsers refuse their barriers.
    pub wgsl: bool,
    /// Cargo's target folder.
    pub target: PathBuf,
}

impl Project {
    /// The project of an xtask. `xtask` is that package's folder, a folder of the workspace, and `shader_crate` is
    /// another one. The modules go to `compiled`, beside them.
    ///
    /// # Panics
    /// If `xtask` is not a folder of a workspace.
    #[must_use]
    pub fn of_xtask(xtask: &str, shader_crate: &str) -> Self {
        // Asks cargo at run time: a copy of the workspace may share the compiled xtask.
        let xtask = std::env::var_os("CARGO_MANIFEST_DIR").unwrap_or(xtask.into());
        let root = Path::new(&xtask).parent().expect("a folder of the workspace").to_owned();
        let target = std::env::var_os("CARGO_TARGET_DIR").map_or("target".into(), PathBuf::from);
        Self {
            shader_crate: shader_crate.into(),
            sources: vec![shader_crate.into()],
            kernels: "compiled".into(),
            wgsl: false,
            // Joining an absolute path returns that path.
            target: root.join(target),
            root,
        }
    }
}

/// The subcommands of an xtask that only handles kernels.
#[derive(Parser)]
#[command(bin_name = "cargo xtask")]
enum Task {
    /// Compile the kernels to SPIR-V
    Kernels(Options),
    /// Show the machine code that the compiler of an AMD GPU makes of the kernels, without the GPU
    Isa(IsaOptions),
}

/// The whole xtask of a project: `cargo xtask kernels`, with [`Options`], and `cargo xtask isa`, with [`IsaOptions`].
/// The arguments are the crate of kernels and its folder in the workspace.
///
/// ```ignore
/// muslin_build::xtask!(my_kernels in "kernels");
/// ```
#[macro_export]
macro_rules! xtask {
    ($kernels:ident in $folder:literal) => {
        // the program is linked with the kernels that it compiles
        use $kernels as _;

        fn main() -> std::process::ExitCode {
            $crate::main(&$crate::Project::of_xtask(env!("CARGO_MANIFEST_DIR"), $folder))
        }
    };
}

/// The `main` of an [`xtask`].
#[must_use]
pub fn main(project: &Project) -> ExitCode {
    exit_code(match Task::parse() {
        Task::Kernels(options) => run(project, options),
        Task::Isa(options) => isa(project, &options),
    })
}

/// Prints an error, if there is one.
#[must_use]
pub fn exit_code(result: Result<()>) -> ExitCode {
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}

/// Options for compiled kernels.
#[derive(Args, Clone, Copy, Debug)]
pub struct Options {
    /// Compile and compare with the folder of modules instead of writing there: fails on any difference
    #[arg(long, conflicts_with = "watch")]
    pub check: bool,
    /// Check each module against the SPIR-V specification with `spirv-val`
    #[arg(long)]
    pub validate: bool,
    /// Compile again whenever a kernel source is saved, until interrupted
    #[arg(long)]
    pub watch: bool,
}

/// Compiles the kernels of a project, and writes, checks or watches its modules.
///
/// # Errors
/// Errors of the compiler or of the check.
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
