//! Compares a compiled module with its kernel's declaration, and writes instructions anew for passes that put some in the place of others.

use std::collections::{BTreeMap, BTreeSet};

use anyhow::{Context, Result, anyhow, bail, ensure};
use muslin_kernel::{EntryPoint, KernelInfo};
use rspirv::dr::{self, Instruction, Module, Operand};
use rspirv::spirv::{
    Capability, Decoration, ExecutionMode, ExecutionModel, Op, StorageClass, Word,
};

use crate::lower;

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
        check_buffer(kernel, point, &buffer)?;
    }
    check_subgroups(kernel, &module)?;
    check_wide(point, &module)?;
    check_loops(kernel, &module)
}

/// Whether a module has one of these capabilities.
fn has_any(module: &Module, capabilities: &[Capability]) -> bool {
    let mut operands = module.capabilities.iter().flat_map(|instruction| &instruction.operands);
    operands.any(|of| matches!(of, Operand::Capability(of) if capabilities.contains(of)))
}

/// Only a variant has 64-bit integers: some devices have none.
fn check_wide(point: &EntryPoint, module: &Module) -> Result<()> {
    let has_some = has_any(module, &lower::WIDE);
    let declares = !point.sums.is_empty();
    ensure!(declares || !has_some, "it has `u64` or `i64`, in helpers too, which GPUs lack");
    ensure!(has_some || !declares, "it declares `impl SumWord`, and adds nothing to it");
    Ok(())
}

/// A kernel with operations of subgroups declares them: some devices have none.
fn check_subgroups(kernel: &KernelInfo, module: &Module) -> Result<()> {
    let has_some = has_any(module, &lower::SUBGROUPS);
    let wrong =
        "it has operations of subgroups, in helpers too: declare them, `#[kernel(.., subgroups)]`";
    ensure!(kernel.subgroups || !has_some, wrong);
    ensure!(has_some || !kernel.subgroups, "it declares `subgroups`, and uses none");
    Ok(())
}

/// A kernel with loops declares their iterations, those of its helpers included.
fn check_loops(kernel: &KernelInfo, module: &Module) -> Result<()> {
    let is_loop = |instruction: &&Instruction| instruction.class.opcode == Op::LoopMerge;
    let loops = module.all_inst_iter().filter(is_loop).count();
    // a loop that the compiler unrolls or leaves out was declared all the same
    ensure!(
        loops == 0 || kernel.iterations.is_some(),
        "it has {loops} loops, in helpers too: state how many iterations they take at most, all together, with \
         `#[kernel(.., iterations = ..)]`"
    );
    Ok(())
}

/// A buffer that a module uses.
struct Buffer {
    set: u32,
    binding: u32,
    class: StorageClass,
    read_only: bool,
    /// Bytes from one element to the next, of a storage buffer.
    stride: Option<u32>,
}

fn check_buffer(kernel: &KernelInfo, point: &EntryPoint, buffer: &Buffer) -> Result<()> {
    let Buffer { set, binding, class, read_only, stride } = *buffer;
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
    // small integers are packed into words
    let bytes = if point.sums.contains(&declared.name) { 8 } else { declared.device_bytes.max(4) };
    let element = declared.element;
    ensure!(
        access == "uniform" || stride == Some(bytes),
        "the elements of `{}` are `{element}` of {bytes} bytes in Rust, and the module has them {} bytes apart: use \
         elements of `u32`, `i32`, `f32`, `Vec2` or `Vec4`",
        declared.name,
        stride.unwrap_or(0)
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
        let stride = stride(module, variable);
        buffers.push(Buffer { set, binding, class, read_only: read_only.contains(&id), stride });
    }
    Ok(buffers)
}

/// Bytes from one element to the next, of a variable that points to a struct with an array alone.
fn stride(module: &Module, variable: &Instruction) -> Option<u32> {
    let declared = |id: Word| module.types_global_values.iter().find(|i| i.result_id == Some(id));
    let pointer = declared(variable.result_type?)?;
    let block = declared(pointer.operands.get(1)?.id_ref_any()?)?;
    let array = block.operands.first()?.id_ref_any()?;
    module.annotations.iter().find_map(|annotation| match *annotation.operands.as_slice() {
        [
            Operand::IdRef(id),
            Operand::Decoration(Decoration::ArrayStride),
            Operand::LiteralBit32(stride),
        ] if id == array => Some(stride),
        _ => None,
    })
}

/// The instructions of a block, as they are written.
#[derive(Default)]
pub struct Writer {
    bound: Word,
    /// The number of the block among those of all functions.
    pub block: usize,
    pub instructions: Vec<Instruction>,
}

impl Writer {
    /// A new id.
    pub fn id(&mut self) -> Word {
        self.bound += 1;
        self.bound - 1
    }

    /// Adds an instruction, and returns its result.
    pub fn add(&mut self, op: Op, kind: Word, operands: &[Word]) -> Word {
        let id = self.id();
        self.push(op, kind, id, operands);
        id
    }

    /// Adds an instruction with this result.
    pub fn push(&mut self, op: Op, kind: Word, id: Word, operands: &[Word]) {
        let operands = operands.iter().copied().map(Operand::IdRef).collect();
        self.instructions.push(Instruction::new(op, Some(kind), Some(id), operands));
    }
}

/// Writes every block of a module anew, one instruction after another.
pub fn rewrite(module: &mut Module, mut write: impl FnMut(&mut Writer, Instruction)) {
    let Some(header) = &mut module.header else { return };
    let mut writer = Writer { bound: header.bound, ..Writer::default() };
    let blocks = module.functions.iter_mut().flat_map(|function| &mut function.blocks);
    for (number, block) in blocks.enumerate() {
        writer.block = number;
        block.instructions.drain(..).for_each(|instruction| write(&mut writer, instruction));
        block.instructions.append(&mut writer.instructions);
    }
    header.bound = writer.bound;
}

#[cfg(test)]
mod tests {
    use rspirv::dr::Builder;
    use rspirv::spirv::{Capability, FunctionControl, LoopControl};

    use super::*;
    use crate::lower::bytes;

    /// The module of `count_fill`, with a buffer whose elements are `stride` bytes apart, and maybe with a loop.
    fn module(stride: u32, has_loop: bool) -> Vec<u8> {
        let mut b = Builder::new();
        b.capability(Capability::Shader);
        let [void, word] = [b.type_void(), b.type_int(32, 0)];
        let array = b.type_runtime_array(word);
        b.decorate(array, Decoration::ArrayStride, [Operand::LiteralBit32(stride)]);
        let block = b.type_struct([array]);
        let pointer = b.type_pointer(None, StorageClass::StorageBuffer, block);
        let placement = b.variable(pointer, None, StorageClass::StorageBuffer, None);
        b.decorate(placement, Decoration::DescriptorSet, [Operand::LiteralBit32(0)]);
        b.decorate(placement, Decoration::Binding, [Operand::LiteralBit32(0)]);
        b.decorate(placement, Decoration::NonWritable, []);
        let ty = b.type_function(void, []);
        let function = b.begin_function(void, None, FunctionControl::NONE, ty).unwrap();
        b.begin_block(None).unwrap();
        if has_loop {
            let [merge, next] = [b.id(), b.id()];
            b.loop_merge(merge, next, LoopControl::NONE, []).unwrap();
            b.branch(merge).unwrap();
            b.begin_block(Some(merge)).unwrap();
        }
        b.ret().unwrap();
        b.end_function().unwrap();
        b.entry_point(ExecutionModel::GLCompute, function, "count_fill", [placement]);
        b.execution_mode(function, ExecutionMode::LocalSize, [64, 1, 1]);
        bytes(&b.module())
    }

    /// A mistake in a module.
    fn wrong(module: &[u8]) -> String {
        let mut kernels = muslin_kernel::kernels();
        let kernel = kernels.find(|kernel| kernel.name == "count_fill").expect("a kernel");
        check(kernel, &kernel.plain(), module).err().map_or_else(String::new, |e| e.to_string())
    }

    #[test]
    fn elements_lie_as_in_rust() {
        assert_eq!(wrong(&module(4, false)), "");
        let message = wrong(&module(16, false));
        let part = "the elements of `placement` are `u32` of 4 bytes in Rust, and the module has them 16 bytes apart";
        assert!(message.starts_with(part), "{message}");
    }

    #[test]
    fn what_a_device_can_lack_is_declared() {
        for (capability, part) in [
            (Capability::GroupNonUniformBallot, "it has operations of subgroups, in helpers too"),
            (Capability::Int64, "it has `u64` or `i64`, in helpers too"),
        ] {
            let mut module = dr::load_bytes(module(4, false)).unwrap();
            let capability = vec![Operand::Capability(capability)];
            module.capabilities.push(Instruction::new(Op::Capability, None, None, capability));
            let message = wrong(&bytes(&module));
            assert!(message.starts_with(part), "{message}");
        }
    }

    #[test]
    fn loops_are_declared() {
        let message = wrong(&module(4, true));
        assert!(message.starts_with("it has 1 loops, in helpers too: state how many"), "{message}");
    }
}
