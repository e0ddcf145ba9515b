//! The program `organza`: scenes, cameras and tiles in, images out.

mod cli;
mod last_resort;

use std::process::ExitCode;

fn main() -> ExitCode {
    cli::main()
}
