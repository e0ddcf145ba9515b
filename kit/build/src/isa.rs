//! `cargo xtask isa`: the machine code that a GPU's compiler makes of the compiled kernels.

use std::env;
use std::process::Command;

use anyhow::{Context, Result, ensure};
use clap::Args;
use muslin_isa::{FAMILIES, Report};
use muslin_manifest::FILE_NAME;

use crate::Project;

/// Options for the machine code of kernels.
#[derive(Args, Clone, Debug)]
pub struct IsaOptions {
    /// Show the machine code of this kernel's innermost loops instead of the table, and all of it where there is no loop
    #[arg(long, value_name = "KERNEL")]
    pub asm: Option<String>,
    /// A family of AMD GPUs, as Mesa's RADV names it; can be given several times
    #[arg(long, default_values = FAMILIES)]
    pub family: Vec<String>,
}

/// Prints the machine code that RADV makes of a project's compiled kernels. It needs no GPU.
///
/// # Errors
/// If there are no compiled kernels, if there is no RADV, if it does not compile a kernel, or if there is no such kernel.
pub fn isa(project: &Project, options: &IsaOptions) -> Result<()> {
    let folder = project.root.join(&project.kernels);
    if muslin_isa::answer(&folder) {
        return Ok(());
    }
    ensure!(
        folder.join(FILE_NAME).exists(),
        "there are no compiled kernels in {}: run `cargo xtask kernels` first",
        folder.display()
    );
    for family in &options.family {
        let mut child = Command::new(env::current_exe()?);
        let report = muslin_isa::compile(&folder, family, child.arg("isa"))?;
        match &options.asm {
            None => println!("{report}"),
            Some(kernel) => print_loops(&report, kernel)?,
        }
    }
    Ok(())
}

fn print_loops(report: &Report, kernel: &str) -> Result<()> {
    let found = report.kernels.iter().find(|found| found.name == kernel);
    let found = found.with_context(|| {
        format!("there is no kernel `{kernel}`: `cargo xtask isa` without `--asm` lists them")
    })?;
    let title = format!("{kernel}, {}, {}", report.family, report.driver);
    match found.loops.len() {
        0 => println!("{title}: no loop, so all of it\n\n{}", found.text),
        count => println!("{title}: {count} innermost loops"),
    }
    for found in &found.loops {
        println!("\n{} instructions\n{}", found.instructions, found.text);
    }
    Ok(())
}
