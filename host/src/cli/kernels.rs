//! `organza kernels`: lists the kernels that the program contains for GPUs.

use muslin_device::List;
use organza::error::format_bytes;
use organza::{MODULES, Result};

use super::console::{Console, print, print_json};
use super::summary::count;

const EXAMPLES: &str = "\
Examples:
  organza kernels
  organza kernels | grep dense
  organza kernels --json

`shared` is the workgroup memory and `SPIR-V` the compiled module, both in bytes. `iterations` is the most that one \
invocation needs, all its loops together. A name that ends in `_shared` is a variant that uses workgroup memory, \
one in `_wide` a variant with 64-bit atomics (docs/kernels.md).";

/// List the kernels: their bindings, workgroups, code and loops
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// Print JSON
    #[arg(long)]
    json: bool,
}

pub fn run(args: &Args, console: Console) -> Result<()> {
    let list = List::new(|kernel, point| {
        MODULES.compiled_kernel(kernel, point).map(|module| module.entry())
    })?;
    let number = count(list.len() as u64, "kernel");
    console.detail(&format!("{number}, {} of SPIR-V", format_bytes(list.bytes())));
    if args.json { print_json(&list) } else { print(&list.to_string()) }
}
