//! Builds kernels: compiles a crate of `#[kernel]` functions to SPIR-V modules that drivers and naga accept, and writes their
//! manifest.
//!
//! A program that is linked with the kernels is an [`xtask`].

mod artifacts;
mod atomic_arguments;
mod compiler;
mod contraction;
mod declarations;
mod errors;
mod expand;
mod loops;
mod lower;
mod memory_model;
mod module;
mod not_numbers;
mod rewrite;
mod rules;
mod small_integers;
mod tiles;
mod validate;

use std::env;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};
use std::time::Instant;

use anyhow::Result;

use compiler::{Compiler, compile, isolate};

/// A workspace with a crate of kernels.
#[derive(Clone, Debug)]
pub struct Project {
    /// The workspace's folder, with its `Cargo.lock`.
    pub root: PathBuf,
    /// The folder of the crate of kernels, relative to the workspace.
    pub shader_crate: String,
    /// Folders with sources of kernels, including the crate's, relative to the workspace.
    pub sources: Vec<String>,
    /// The folder of the modules and their manifest, relative to the workspace.
    pub kernels: String,
    /// Whether to write the kernels in WGSL beside their modules, too, for pages that read files. Variants are left out, because browsers
    /// refuse their barriers.
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
    pub fn from_xtask(xtask: &str, shader_crate: &str) -> Self {
        // Asks cargo at run time: a copy of the workspace may share the compiled xtask.
        let xtask = env::var_os("CARGO_MANIFEST_DIR").unwrap_or(xtask.into());
        let root = Path::new(&xtask).parent().expect("a folder of the workspace").to_owned();
        let target = env::var_os("CARGO_TARGET_DIR").map_or("target".into(), PathBuf::from);
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

/// The whole xtask of a project: `cargo xtask kernels` and `cargo xtask isa`. The arguments are the crate of kernels, its folder in
/// the workspace, and fields of [`Project`] that differ from [`Project::from_xtask`]'s.
///
/// ```ignore
/// muslin_build::xtask!(my_kernels in "kernels");
/// ```
#[macro_export]
macro_rules! xtask {
    ($kernels:ident in $folder:literal $(, $field:ident: $value:expr)* $(,)?) => {
        // the program is linked with the kernels that it compiles
        use $kernels as _;

        fn main() -> std::process::ExitCode {
            let project = $crate::Project::from_xtask(env!("CARGO_MANIFEST_DIR"), $folder);
            $crate::main(&$crate::Project { $($field: $value,)* ..project })
        }
    };
}

/// The `main` of an [`xtask`].
#[must_use]
pub fn main(project: &Project) -> ExitCode {
    // a process that shows machine code
    if muslin_isa::answer() {
        return ExitCode::SUCCESS;
    }
    let arguments: Vec<_> = env::args().skip(1).collect();
    let result = match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["kernels"] => run(project),
        ["isa", ref families @ ..] if families.iter().all(|family| !family.starts_with('-')) => {
            isa(project, if families.is_empty() { &muslin_isa::FAMILIES } else { families })
        }
        _ => {
            eprintln!(
                "usage: cargo xtask kernels, which compiles the kernels to SPIR-V\n       \
                 cargo xtask isa [FAMILY..], which shows what Mesa makes of them for AMD GPUs such as {}",
                muslin_isa::FAMILIES.join(" and ")
            );
            return ExitCode::FAILURE;
        }
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}

/// Prints what RADV makes of a project's compiled kernels, for families of GPUs. It needs none of these.
fn isa(project: &Project, families: &[&str]) -> Result<()> {
    let folder = project.root.join(&project.kernels);
    for family in families {
        let mut child = Command::new(env::current_exe()?);
        println!("{}", muslin_isa::compile(&folder, family, &mut child)?);
    }
    Ok(())
}

/// Compiles the kernels of a project, and writes its modules.
fn run(project: &Project) -> Result<()> {
    let start = Instant::now();
    isolate();
    let compiler = Compiler::find(&project.root.join(&project.shader_crate))?;
    eprintln!("compiling the kernels with {compiler}");
    let artifacts = compile(project, &compiler)?;
    let seconds = start.elapsed().as_secs_f64();
    println!("{artifacts}");
    let kernels = &project.kernels;
    let changed = artifacts.write(&project.root.join(kernels))?;
    println!("{kernels}: {changed} files changed (compiled in {seconds:.1} s)");
    Ok(())
}
