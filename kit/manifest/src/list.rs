//! Lists kernels: their bindings, workgroups, code and loops.

use std::fmt;

use muslin_kernel::kernel::workgroup_bytes;
use muslin_kernel::{EntryPoint, KernelInfo, MAX_ITERATIONS};
use serde::Serialize;

use crate::{KernelEntry, Table};

/// A kernel in the list.
#[derive(Debug, Serialize)]
struct Listed {
    name: &'static str,
    file: &'static str,
    workgroup_size: [u32; 3],
    fused: bool,
    shared_bytes: u32,
    spirv_bytes: u64,
    instructions: u32,
    loops: u32,
    /// Upper limit for the iterations of one invocation, over all its loops.
    worst_case_iterations: u32,
    bindings: Vec<BindingRow>,
}

#[derive(Debug, Serialize)]
struct BindingRow {
    binding: usize,
    name: &'static str,
    access: &'static str,
    element: &'static str,
    element_bytes: u32,
}

/// All kernels that a program is linked with, by name.
#[derive(Debug, Serialize)]
#[serde(transparent)]
pub struct List(Vec<Listed>);

impl List {
    /// Lists the kernels. `entry` finds an entry point in the manifest.
    ///
    /// # Errors
    /// The first error of `entry`.
    pub fn new<'a, E>(
        entry: impl Fn(&KernelInfo, &EntryPoint) -> Result<&'a KernelEntry, E>,
    ) -> Result<Self, E> {
        let mut kernels: Vec<_> = muslin_kernel::kernels().collect();
        kernels.sort_by_key(|kernel| kernel.name);
        let all = kernels
            .into_iter()
            .flat_map(|kernel| kernel.entry_points().map(move |of| (kernel, of)));
        let listed =
            all.map(|(kernel, point)| Ok(Listed::new(kernel, &point, entry(kernel, &point)?)));
        listed.collect::<Result<_, _>>().map(Self)
    }

    /// Number of entry points.
    #[must_use]
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Bytes of all modules.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        self.0.iter().map(|kernel| kernel.spirv_bytes).sum()
    }
}

impl fmt::Display for List {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}\n{}", code(&self.0), bindings(&self.0))
    }
}

impl Listed {
    fn new(kernel: &KernelInfo, point: &EntryPoint, entry: &KernelEntry) -> Self {
        let bindings = kernel.bindings.iter().enumerate().map(|(binding, info)| BindingRow {
            binding,
            name: info.name,
            access: info.access.as_str(),
            element: info.element,
            element_bytes: info.element_bytes,
        });
        Self {
            name: point.name,
            file: kernel.file,
            workgroup_size: kernel.workgroup_size,
            fused: kernel.fused,
            shared_bytes: workgroup_bytes(point.shared),
            spirv_bytes: entry.spirv_bytes,
            instructions: entry.instructions,
            loops: entry.loops,
            worst_case_iterations: kernel.iterations.unwrap_or(0),
            bindings: bindings.collect(),
        }
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
            kernel.instructions.to_string(),
            kernel.loops.to_string(),
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
