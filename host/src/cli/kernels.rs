//! `organza kernels`: lists the kernels that the program contains for GPUs.

use muslin::kernel::workgroup_bytes;
use muslin::{EntryPoint, KernelInfo};
use muslin_device::CodeSize;
use organza::error::format_bytes;
use organza::{MODULES, Result};
use organza_shaders::limits::MAX_ITERATIONS;
use serde::Serialize;

use super::console::{Console, print, print_json};
use super::summary::count;
use super::table::Table;

const EXAMPLES: &str = "\
Examples:
  organza kernels
  organza kernels | grep dense
  organza kernels --json

`shared` is the workgroup memory and `SPIR-V` the compiled module, both in bytes. `iterations` is the most that one \
invocation needs, all its loops together. A name that ends in `_shared` is a variant that uses workgroup memory \
(docs/kernels.md).";

/// List the kernels: their bindings, workgroups, code and loops
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// Print JSON
    #[arg(long)]
    json: bool,
}

/// A kernel in the list.
#[derive(Debug, Serialize)]
struct Listed {
    name: &'static str,
    file: &'static str,
    workgroup_size: [u32; 3],
    fused: bool,
    shared_bytes: u32,
    spirv_bytes: usize,
    #[serde(flatten)]
    code: CodeSize,
    /// Upper limit for the iterations of one invocation, over all its loops.
    worst_case_iterations: u32,
    bindings: Vec<Binding>,
}

#[derive(Debug, Serialize)]
struct Binding {
    binding: usize,
    name: &'static str,
    access: &'static str,
    element: &'static str,
    element_bytes: u32,
}

pub fn run(args: &Args, console: Console) -> Result<()> {
    let mut declared: Vec<_> = muslin::kernels().collect();
    declared.sort_by_key(|kernel| kernel.name);
    let all =
        declared.iter().flat_map(|kernel| kernel.entry_points().map(|point| (*kernel, point)));
    let listed =
        all.map(|(kernel, point)| Listed::of(kernel, point)).collect::<Result<Vec<_>>>()?;
    let bytes: usize = listed.iter().map(|kernel| kernel.spirv_bytes).sum();
    let number = count(listed.len() as u64, "kernel");
    console.detail(&format!("{number}, {} of SPIR-V", format_bytes(bytes as u64)));
    if args.json {
        return print_json(&listed);
    }
    print(&format!("{}\n{}", code(&listed), bindings(&listed)))
}

impl Listed {
    fn of(kernel: &'static KernelInfo, point: EntryPoint) -> Result<Self> {
        let compiled = MODULES.of(kernel, &point)?;
        let bindings = kernel.bindings.iter().enumerate().map(|(binding, info)| Binding {
            binding,
            name: info.name,
            access: info.access.as_str(),
            element: info.element,
            element_bytes: info.element_bytes,
        });
        Ok(Self {
            name: point.name,
            file: kernel.file,
            workgroup_size: kernel.workgroup_size,
            fused: kernel.fused,
            shared_bytes: workgroup_bytes(point.shared),
            spirv_bytes: compiled.spirv().len(),
            code: CodeSize::of(&compiled.spirv_words()),
            worst_case_iterations: kernel.iterations.unwrap_or(0),
            bindings: bindings.collect(),
        })
    }
}

fn code(listed: &[Listed]) -> String {
    let titles = ["kernel", "workgroup", "shared", "SPIR-V", "instructions", "loops", "iterations"];
    let mut table = Table::new(2, titles);
    for kernel in listed {
        let [x, y, z] = kernel.workgroup_size;
        table.row([
            kernel.name.into(),
            format!("{x} x {y} x {z}"),
            kernel.shared_bytes.to_string(),
            kernel.spirv_bytes.to_string(),
            kernel.code.instructions.to_string(),
            kernel.code.loops.to_string(),
            kernel.worst_case_iterations.to_string(),
        ]);
    }
    format!(
        "{table}\nshared and SPIR-V are in bytes; iterations is the most that one invocation needs, and may be up to \
         {MAX_ITERATIONS}\n"
    )
}

fn bindings(listed: &[Listed]) -> String {
    let mut table = Table::new(5, ["kernel", "binding", "name", "access", "element", "bytes"]);
    for kernel in listed {
        for (index, binding) in kernel.bindings.iter().enumerate() {
            table.row([
                if index == 0 { kernel.name.into() } else { String::new() },
                binding.binding.to_string(),
                binding.name.into(),
                binding.access.into(),
                binding.element.into(),
                binding.element_bytes.to_string(),
            ]);
        }
    }
    table.to_string()
}
