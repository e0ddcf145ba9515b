//! `cargo xtask isa`: the machine code that a GPU's compiler makes of the compiled kernels.

use std::env;
use std::process::Command;

use anyhow::{Context, Result};
use clap::Args;
use organza_isa::{FAMILIES, Report};

use crate::Project;

/// Options for the machine code of kernels.
#[derive(Args, Clone, Debug)]
pub struct IsaOptions {
    /// Show the machine code of this kernel's innermost loops, instead of the table
    #[arg(long, value_name = "KERNEL")]
    pub asm: Option<String>,
    /// A family of AMD GPUs, as Mesa's RADV names it; can be given several times
    #[arg(long, default_values = FAMILIES)]
    pub family: Vec<String>,
}

/// Prints the machine code that RADV makes of a project's compiled kernels. It needs no GPU.
///
/// # Errors
/// If there is no RADV, if it does not compile a kernel, or if there is no such kernel.
pub fn isa(project: &Project, options: &IsaOptions) -> Result<()> {
    let folder = project.root.join(&project.kernels);
    if organza_isa::answer(&folder) {
        return Ok(());
    }
    for family in &options.family {
        let mut child = Command::new(env::current_exe()?);
        let report = organza_isa::compile(&folder, family, child.arg("isa"))?;
        match &options.asm {
            None => println!("{report}"),
            Some(kernel) => print_loops(&report, kernel)?,
        }
    }
    Ok(())
}

fn print_loops(report: &Report, kernel: &str) -> Result<()> {
    let found = report.kernels.iter().find(|found| found.name == kernel);
    let found = found.with_context(|| format!("there is no kernel `{kernel}`"))?;
    println!(
        "{kernel}, {}, {}: {} innermost loops",
        report.family,
        report.driver,
        found.loops.len()
    );
    for found in &found.loops {
        println!("\n{} instructions\n{}", found.instructions, found.text);
    }
    Ok(())
}
