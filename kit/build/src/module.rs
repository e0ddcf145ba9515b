//! Compares a compiled module with its kernel's declaration.

use std::collections::{BTreeMap, BTreeSet};

use anyhow::{Context, Result, anyhow, bail, ensure};
use organza_kernel::{EntryPoint, KernelInfo};
use rspirv::dr::{self, Instruction, Module, Operand};
use rspirv::spirv::{Decoration, ExecutionMode, ExecutionModel, Op, StorageClass, Word};

/// Checks that a module has only this entry point of the kernel, with its workgroup size, and no buffers besides the
/// kernel's bindings.
pub fn check(kernel: &KernelInfo, point: &EntryPoint, spirv: &[u8]) -> Result<()> {
    ensure!(spirv.len().is_multiple_of(4), "the module is no sequence of words");
    let module = dr::load_bytes(spirv).map_err(|error| anyhow!("the module is broken: {error}"))?;
    let (id, name) = entry_point(&module)?;
    ensure!(name == point.name, "the module's entry point is `{name}`");
    let size = local_size(&module, id)?;
    ensure!(
        size == kernel.workgroup_size,
        "the module's workgroup is {size:?}, the kernel declares {:?}",
        kernel.workgroup_size
    );
    for buffer in buffers(&module)? {
        check_buffer(kernel, &buffer)?;
    }
    Ok(())
}

/// A buffer that a module uses.
struct Buffer {
    set: u32,
    binding: u32,
    class: StorageClass,
    read_only: bool,
}

fn check_buffer(kernel: &KernelInfo, buffer: &Buffer) -> Result<()> {
    let Buffer { set, binding, class, read_only } = *buffer;
    ensure!(set == 0, "the module uses descriptor set {set}");
    let Some(declared) = kernel.bindings.get(binding as usize) else {
        bail!("the module uses binding {binding}, the kernel declares {}", kernel.bindings.len());
    };
    let access = declared.access.as_str();
    let want =
        if access == "uniform" { StorageClass::Uniform } else { StorageClass::StorageBuffer };
    ensure!(
        class == want,
        "the module has binding {binding} as a {class:?}, the kernel declares `{}` as {access}",
        declared.name
    );
    // Uniform buffers are always read-only.
    ensure!(
        access == "uniform" || read_only == (access == "read"),
        "the kernel declares `{}` as {access}, the module does not",
        declared.name
    );
    Ok(())
}

fn entry_point(module: &Module) -> Result<(Word, &str)> {
    let [instruction] = module.entry_points.as_slice() else {
        bail!("the module has {} entry points", module.entry_points.len());
    };
    match instruction.operands.as_slice() {
        [
            Operand::ExecutionModel(ExecutionModel::GLCompute),
            Operand::IdRef(id),
            Operand::LiteralString(name),
            ..,
        ] => Ok((*id, name)),
        _ => bail!("the module's entry point is no compute shader"),
    }
}

fn local_size(module: &Module, entry_point: Word) -> Result<[u32; 3]> {
    let size = |mode: &Instruction| match *mode.operands.as_slice() {
        [
            Operand::IdRef(id),
            Operand::ExecutionMode(ExecutionMode::LocalSize),
            Operand::LiteralBit32(x),
            Operand::LiteralBit32(y),
            Operand::LiteralBit32(z),
        ] if id == entry_point => Some([x, y, z]),
        _ => None,
    };
    module.execution_modes.iter().find_map(size).context("the module has no workgroup size")
}

fn buffers(module: &Module) -> Result<Vec<Buffer>> {
    let mut sets = BTreeMap::new();
    let mut bindings = BTreeMap::new();
    let mut read_only = BTreeSet::new();
    for annotation in &module.annotations {
        use Decoration::{Binding, DescriptorSet, NonWritable};
        match *annotation.operands.as_slice() {
            [Operand::IdRef(id), Operand::Decoration(NonWritable)] => {
                read_only.insert(id);
            }
            [Operand::IdRef(id), Operand::Decoration(Binding), Operand::LiteralBit32(number)] => {
                bindings.insert(id, number);
            }
            [
                Operand::IdRef(id),
                Operand::Decoration(DescriptorSet),
                Operand::LiteralBit32(set),
            ] => {
                sets.insert(id, set);
            }
            _ => {}
        }
    }
    let mut buffers = Vec::new();
    for variable in &module.types_global_values {
        let Some((Op::Variable, id)) = variable.result_id.map(|id| (variable.class.opcode, id))
        else {
            continue;
        };
        let Some(&Operand::StorageClass(class)) = variable.operands.first() else {
            continue;
        };
        // Everything but workgroup memory and builtins comes from the host.
        if matches!(class, StorageClass::Workgroup | StorageClass::Private | StorageClass::Input) {
            continue;
        }
        let (Some(&set), Some(&binding)) = (sets.get(&id), bindings.get(&id)) else {
            bail!("the module has a {class:?} variable that is no binding");
        };
        buffers.push(Buffer { set, binding, class, read_only: read_only.contains(&id) });
    }
    Ok(buffers)
}
