//! Compares a compiled module with its kernel's declaration.

use anyhow::{Result, anyhow, bail, ensure};
use muslin_kernel::{EntryPoint, KernelInfo};
use naga::{
    AddressSpace, ArraySize, GlobalVariable, Handle, ShaderStage, StorageAccess, TypeInner,
};
use rspirv::dr::{self, Instruction, Module, Operand};
use rspirv::spirv::{Capability, GlslStd450Op, Op};

use crate::{lower, validate};

/// Checks that a module has only this entry point of the kernel, with its workgroup size, and no buffers besides the
/// kernel's bindings.
pub fn check(kernel: &KernelInfo, point: &EntryPoint, spirv: &[u8]) -> Result<()> {
    let module = load(spirv)?;
    check_subgroups(kernel, &module)?;
    check_wide(point, &module)?;
    check_loops(kernel, &module)?;
    check_functions(&module)?;
    let module = validate::read(spirv)?;
    check_arrays(&module)?;
    let [entry_point] = module.entry_points.as_slice() else {
        bail!("the module has {} entry points", module.entry_points.len());
    };
    ensure!(
        entry_point.stage == ShaderStage::Compute,
        "the module's entry point is no compute shader"
    );
    ensure!(entry_point.name == point.name, "the module's entry point is `{}`", entry_point.name);
    let size = entry_point.workgroup_size;
    ensure!(
        size == kernel.workgroup_size,
        "the module's workgroup is {size:?}, the kernel declares {:?}",
        kernel.workgroup_size
    );
    let mut variables = module.global_variables.iter();
    variables.try_for_each(|(_, variable)| check_buffer(kernel, point, &module, variable))
}

fn load(spirv: &[u8]) -> Result<Module> {
    ensure!(spirv.len().is_multiple_of(4), "the module is no sequence of words");
    dr::load_bytes(spirv).map_err(|error| anyhow!("the module is broken: {error}"))
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

/// A kernel with loops declares their iterations, its helpers' included.
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

/// Methods of glam become functions of GLSL, in some of which each GPU has an error of its own: in Sin to Pow, Log, Exp2, Log2 and Fma.
fn check_functions(module: &Module) -> Result<()> {
    for of in module.all_inst_iter().filter(|of| of.class.opcode == Op::ExtInst) {
        if let Operand::LiteralExtInstInteger(number @ (13..=26 | 28..=30 | 50)) = of.operands[1]
            && let Some(function) = GlslStd450Op::from_u32(number)
        {
            bail!(
                "it takes GLSL's `{function:?}`, in helpers or by a method of glam, in which each GPU has an error of its own: write it with \
                 `muslin::math`, products and sums"
            );
        }
    }
    Ok(())
}

/// Most elements of an array of each invocation. Mesa's software GPU takes 44 s to compile a table of 1,024 constants, and longer than nine
/// minutes for 4,096.
const MAX_ELEMENTS: u32 = 256;

/// An array with a variable index stays in the memory of each invocation, tables of constants, too.
fn check_arrays(module: &naga::Module) -> Result<()> {
    let entries = module.entry_points.iter().map(|point| &point.function);
    let functions = entries.chain(module.functions.iter().map(|(_, function)| function));
    let variables = functions.flat_map(|function| function.local_variables.iter());
    for (_, variable) in variables {
        let len = elements(module, variable.ty);
        ensure!(
            len <= MAX_ELEMENTS,
            "it has an array or a table of {len} elements with a variable index, in helpers too: each invocation keeps it, and a driver can \
             take minutes to compile that. Bind it as a `Read` buffer, which the host uploads once; a kernel's own arrays have at most \
             {MAX_ELEMENTS}"
        );
    }
    Ok(())
}

/// Elements of an array, and of all arrays in it.
fn elements(module: &naga::Module, ty: Handle<naga::Type>) -> u32 {
    match &module.types[ty].inner {
        TypeInner::Array { base, size: ArraySize::Constant(len), .. } => {
            elements(module, *base).saturating_mul(len.get())
        }
        TypeInner::Struct { members, .. } => {
            members.iter().map(|member| elements(module, member.ty)).sum()
        }
        _ => 1,
    }
}

/// Compares a buffer with the kernel's binding.
fn check_buffer(
    kernel: &KernelInfo,
    point: &EntryPoint,
    module: &naga::Module,
    buffer: &GlobalVariable,
) -> Result<()> {
    let space = buffer.space;
    // Everything but workgroup memory and builtins comes from the host.
    if matches!(space, AddressSpace::WorkGroup | AddressSpace::Private) {
        return Ok(());
    }
    let Some(place) = buffer.binding else {
        bail!("the module has a variable in {space:?} that is no binding");
    };
    ensure!(place.group == 0, "the module uses descriptor set {}", place.group);
    let binding = place.binding;
    let Some(declared) = kernel.bindings.get(binding as usize) else {
        bail!("the module uses binding {binding}, the kernel declares {}", kernel.bindings.len());
    };
    let found = match space {
        AddressSpace::Uniform => "uniform",
        AddressSpace::Storage { access } if access.contains(StorageAccess::STORE) => "write",
        AddressSpace::Storage { .. } => "read",
        _ => bail!("the module has binding {binding} in {space:?}"),
    };
    let access = declared.access.as_str();
    ensure!(
        found == access,
        "the kernel declares `{}` as {access}, the module as {found}",
        declared.name
    );
    let members = match &module.types[buffer.ty].inner {
        TypeInner::Struct { members, .. } => members.as_slice(),
        _ => &[],
    };
    let stride = match members.first().map(|member| &module.types[member.ty].inner) {
        Some(&TypeInner::Array { stride, .. }) => stride,
        _ => 0,
    };
    // small integers are packed into words
    let bytes = if point.sums.contains(&declared.name) { 8 } else { declared.device_bytes.max(4) };
    let element = declared.element;
    ensure!(
        access == "uniform" || stride == bytes,
        "the elements of `{}` are `{element}` of {bytes} bytes in Rust, and the module has them {stride} bytes apart: \
         use elements of `u32`, `i32`, `f32`, `Vec2` or `Vec4`",
        declared.name
    );
    Ok(())
}

#[cfg(test)]
mod tests {
    use rspirv::dr::Builder;
    use rspirv::spirv::{Decoration, LoopControl, StorageClass};

    use super::*;
    use crate::lower::bytes;

    /// The module of `count_fill`, with a buffer whose elements are `stride` bytes apart, and maybe with a loop.
    fn module(stride: u32, has_loop: bool) -> Vec<u8> {
        let mut b = Builder::new();
        let word = b.type_int(32, 0);
        let array = b.type_runtime_array(word);
        b.decorate(array, Decoration::ArrayStride, [Operand::LiteralBit32(stride)]);
        let block = b.type_struct([array]);
        let pointer = b.type_pointer(None, StorageClass::StorageBuffer, block);
        let placement = b.variable(pointer, None, StorageClass::StorageBuffer, None);
        b.decorate(placement, Decoration::DescriptorSet, [Operand::LiteralBit32(0)]);
        b.decorate(placement, Decoration::Binding, [Operand::LiteralBit32(0)]);
        b.decorate(placement, Decoration::NonWritable, []);
        let module = lower::count_fill(b, &[placement], |b| {
            if has_loop {
                let [merge, next] = [b.id(), b.id()];
                b.loop_merge(merge, next, LoopControl::NONE, []).unwrap();
                b.branch(merge).unwrap();
                b.begin_block(Some(merge)).unwrap();
            }
        });
        bytes(&module)
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
    fn inexact_functions_come_from_math() {
        let with = |function: GlslStd450Op| {
            let mut b = Builder::new();
            let float = b.type_float(32, None);
            let x = b.constant_bit32(float, 0);
            let library = b.ext_inst_import("GLSL.std.450");
            wrong(&bytes(&lower::count_fill(b, &[], |b| {
                b.ext_inst(float, None, library, function as u32, [Operand::IdRef(x)]).unwrap();
            })))
        };
        assert_eq!(with(GlslStd450Op::Sqrt), "");
        let message = with(GlslStd450Op::Sin);
        assert!(
            message.starts_with("it takes GLSL's `Sin`, in helpers or by a method"),
            "{message}"
        );
    }

    #[test]
    fn large_tables_are_buffers() {
        let with_array = |sizes: [u32; 2]| {
            let mut b = Builder::new();
            let word = b.type_int(32, 0);
            let sizes = sizes.map(|len| b.constant_bit32(word, len));
            let array = sizes.into_iter().fold(word, |of, len| b.type_array(of, len));
            let pointer = b.type_pointer(None, StorageClass::Function, array);
            wrong(&bytes(&lower::count_fill(b, &[], |b| {
                b.variable(pointer, None, StorageClass::Function, None);
            })))
        };
        assert_eq!(with_array([16, 16]), "");
        let message = with_array([1, 257]);
        assert!(message.starts_with("it has an array or a table of 257 elements"), "{message}");
        assert!(with_array([32, 32]).contains("a table of 1024 elements"));
        assert!(message.contains("Bind it as a `Read` buffer"), "{message}");
    }

    #[test]
    fn loops_are_declared() {
        let message = wrong(&module(4, true));
        assert!(message.starts_with("it has 1 loops, in helpers too: state how many"), "{message}");
    }
}
