//! Lists kernels: their bindings, workgroups, code and loops.

use std::borrow::Cow;
use std::fmt;

use muslin_kernel::kernel::workgroup_bytes;
use muslin_kernel::{EntryPoint, KernelInfo, MAX_ITERATIONS};
use serde::Serialize;

use crate::Table;

/// The size of a module's code.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
struct CodeSize {
    /// Number of instructions in functions, without labels and others that compute nothing.
    instructions: u32,
    /// Number of loops.
    loops: u32,
}

impl CodeSize {
    /// Counts the instructions of a module. Each begins with its length and its opcode.
    fn from_spirv(spirv: &[u32]) -> Self {
        const HEADER: usize = 5;
        const FUNCTION: u32 = 54;
        const FUNCTION_END: u32 = 56;
        const LOOP_MERGE: u32 = 246;
        // line, no line, parameter, variable, selection merge, label
        const SILENT: [u32; 6] = [8, 317, 55, 59, 247, 248];
        let mut size = Self::default();
        let mut at = HEADER;
        let mut inside = false;
        while let Some(word) = spirv.get(at) {
            match word & 0xffff {
                FUNCTION => inside = true,
                FUNCTION_END => inside = false,
                LOOP_MERGE => size.loops += 1,
                number => size.instructions += u32::from(inside && !SILENT.contains(&number)),
            }
            at += (word >> 16).max(1) as usize;
        }
        size
    }
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
    /// Lists the kernels. `spirv` finds the compiled module of an entry point.
    ///
    /// # Errors
    /// The first error of `spirv`.
    pub fn new<'a, E>(
        spirv: impl Fn(&KernelInfo, &EntryPoint) -> Result<Cow<'a, [u32]>, E>,
    ) -> Result<Self, E> {
        let mut kernels: Vec<_> = muslin_kernel::kernels().collect();
        kernels.sort_by_key(|kernel| kernel.name);
        let all = kernels
            .into_iter()
            .flat_map(|kernel| kernel.entry_points().map(move |of| (kernel, of)));
        let listed =
            all.map(|(kernel, point)| Ok(Listed::new(kernel, &point, &spirv(kernel, &point)?)));
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
    pub fn bytes(&self) -> usize {
        self.0.iter().map(|kernel| kernel.spirv_bytes).sum()
    }
}

impl fmt::Display for List {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}\n{}", code(&self.0), bindings(&self.0))
    }
}

impl Listed {
    fn new(kernel: &KernelInfo, point: &EntryPoint, spirv: &[u32]) -> Self {
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
            spirv_bytes: size_of_val(spirv),
            code: CodeSize::from_spirv(spirv),
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn code_is_counted_in_functions_alone() {
        let word = |number: u32, length: u32| length << 16 | number;
        // a constant; a function with a label, a loop's merge and branch, a return
        let module = [
            &[0x0723_0203, 0x10500, 0, 9, 0][..],
            &[word(43, 4), 1, 2, 246],
            &[word(54, 5), 1, 3, 0, 4],
            &[word(248, 2), 5],
            &[word(246, 4), 6, 7, 0],
            &[word(249, 2), 5],
            &[word(253, 1)],
            &[word(56, 1)],
        ]
        .concat();
        assert_eq!(CodeSize::from_spirv(&module), CodeSize { instructions: 2, loops: 1 });
    }
}
