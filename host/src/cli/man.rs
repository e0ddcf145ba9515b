//! `organza man`: manual pages, one for each command.

use std::path::PathBuf;

use clap::{Command, CommandFactory};
use clap_mangen::Man;
use organza::{Error, Result};
use organza_core::write_inside;

use super::Cli;
use super::console::Console;
use super::output::{Folder, check_file};
use super::summary::count;

const EXAMPLES: &str = "\
Examples:
  organza man -o ~/.local/share/man/man1       then: man organza, man organza-train
  organza man -o man && man ./man/organza-render.1";

/// Write manual pages: one for the program, and one for each command
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The folder for the pages, organza.1 and organza-COMMAND.1; created if it does not exist
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
}

pub fn run(args: &Args, console: Console) -> Result<()> {
    let mut program = Cli::command().disable_help_subcommand(true);
    program.build();
    let commands: Vec<Command> = program.get_subcommands().cloned().collect();
    let folder = Folder::make(&args.output)?;
    let pages: Vec<Man> = std::iter::once(program).chain(commands).map(Man::new).collect();
    let files = pages.iter().map(|page| folder.file(&page.get_filename()));
    let files = files.collect::<Result<Vec<_>>>()?;
    for file in &files {
        check_file(file, &[])?;
    }
    for (page, file) in pages.iter().zip(&files) {
        let mut text = Vec::new();
        page.render(&mut text).map_err(|source| Error::write(file, source))?;
        write_inside(file, |writer| writer.write_all(&text))?;
        console.detail(&format!("wrote {}", file.display()));
    }
    let pages = count(files.len() as u64, "page");
    console.note(&format!("wrote {pages} to {}", args.output.display()));
    Ok(())
}
