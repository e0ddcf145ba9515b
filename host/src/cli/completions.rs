//! `organza completions`: scripts with which shells complete commands and options.

use clap::CommandFactory;
use clap_complete::Shell;
use organza::Result;
use organza::error::argument;

use super::Cli;
use super::console::{Console, print_as_is};

/// Print a script that completes commands and options in a shell
#[derive(Debug, clap::Args)]
#[command(after_help = include_str!("help/completions.txt"))]
pub struct Args {
    /// The shell
    #[arg(value_enum)]
    shell: Shell,
}

pub fn run(args: &Args, console: Console) -> Result<()> {
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut Cli::command(), "organza", &mut script);
    let script = String::from_utf8(script).or_else(|error| argument(error.to_string()))?;
    console.detail(&format!("{} lines for {}", script.lines().count(), args.shell));
    print_as_is(&script)
}
