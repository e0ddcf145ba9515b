//! Checks that kernels follow the rules of docs/kernels.md, and that the traps described there still exist.

use std::cell::Cell;
use std::panic::{self, UnwindSafe};
use std::path::Path;
use std::sync::Once;
use std::{fs, thread};

use muslin::kernel::CpuRun;
use muslin::{EntryPoint, KernelInfo, kernels as declared};
use organza::MODULES;
use organza_shaders::transmittance::{SegmentProductKernel, SegmentProductParams};
use organza_tests::devices::{self, skip};
use wgpu::naga;

/// Opcodes from the SPIR-V specification.
mod op {
    pub const EXTENDED: u32 = 12;
    pub const CAPABILITY: u32 = 17;
    pub const TYPE_FLOAT: u32 = 22;
    pub const TYPE_ARRAY: u32 = 28;
    pub const TYPE_POINTER: u32 = 32;
    pub const CONSTANT: u32 = 43;
    pub const BARRIER: u32 = 224;
    pub const FUNCTION: u32 = 54;
    pub const VARIABLE: u32 = 59;
    pub const LOOP_MERGE: u32 = 246;
    pub const LABEL: u32 = 248;
    pub const BRANCH: u32 = 249;
    pub const DECORATE: u32 = 71;
    pub const RETURNS: [u32; 2] = [253, 254];
    pub const FLOAT_ATOMICS: [u32; 3] = [5614, 5615, 6035];
}

/// Runs code that panics, without printing the panic. Panics in other tests' threads are still printed.
fn silently<R>(run: impl FnOnce() -> R + UnwindSafe) -> thread::Result<R> {
    thread_local!(static SILENT: Cell<bool> = const { Cell::new(false) });
    static HOOK: Once = Once::new();
    HOOK.call_once(|| {
        let hook = panic::take_hook();
        panic::set_hook(Box::new(move |panic| {
            if !SILENT.get() {
                hook(panic);
            }
        }));
    });
    SILENT.set(true);
    let result = panic::catch_unwind(run);
    SILENT.set(false);
    result
}

fn page(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs").join(name);
    fs::read_to_string(path).expect("a page of the docs")
}

/// Every entry point of every kernel.
fn entry_points() -> impl Iterator<Item = (&'static KernelInfo, EntryPoint)> {
    declared().flat_map(|kernel| kernel.entry_points().map(move |point| (kernel, point)))
}

fn naga_module(words: &[u32]) -> Result<naga::Module, String> {
    let options = naga::front::spv::Options::default();
    let parser = naga::front::spv::Frontend::new(words.iter().copied(), &options);
    let module = parser.parse().map_err(|error| error.to_string())?;
    let flags = naga::valid::ValidationFlags::all();
    // features that an adapter may have
    use naga::valid::Capabilities;
    let offered = Capabilities::SHADER_FLOAT16
        | Capabilities::SUBGROUP
        | Capabilities::SHADER_INT64
        | Capabilities::SHADER_INT64_ATOMIC_ALL_OPS;
    let mut validator = naga::valid::Validator::new(flags, offered);
    match validator.validate(&module) {
        Ok(_) => Ok(module),
        Err(error) => Err(format!("{:?}", error.into_inner())),
    }
}

#[test]
fn every_kernel_is_in_the_glossary() {
    let glossary = page("glossary.md");
    for kernel in declared() {
        let name = kernel.name;
        assert!(glossary.contains(&format!("`{name}`")), "docs/glossary.md lacks `{name}`");
        let file = kernel.file.replace("shader-crate/src/", "");
        assert!(glossary.contains(&file), "docs/glossary.md lacks {file}, the file of `{name}`");
    }
    for equation in 1..=16 {
        let numbers = glossary.lines().filter_map(|line| line.split('|').nth(1));
        let mut all = numbers.flat_map(|cell| cell.split([',', ' ']));
        assert!(all.any(|number| number == equation.to_string()), "no Eq. {equation}");
    }
}

#[test]
fn modules_keep_the_rules() {
    const VULKAN_MEMORY_MODEL: u32 = 5345;
    const POW: u32 = 26;
    const FUNCTION_STORAGE: u32 = 7;
    const FLOAT16: u32 = 9;
    const STORAGE_16_BIT: u32 = 4433;
    for kernel in MODULES.all() {
        let name = &kernel.entry().name;
        let words = kernel.spirv_words();
        let all: Vec<_> = instructions(&words).collect();
        let count = |opcodes: &[u32]| all.iter().filter(|i| opcodes.contains(&i.opcode)).count();
        let functions = count(&[op::FUNCTION]);
        assert_eq!(count(&op::RETURNS), functions, "{name}: a function has one exit");
        assert_eq!(count(&op::FLOAT_ATOMICS), 0, "{name}: float sums depend on their order");
        let vulkan = |i: &&_| is(i, op::CAPABILITY) && i.operands[0] == VULKAN_MEMORY_MODEL;
        assert_eq!(all.iter().filter(vulkan).count(), 0, "{name}: Vulkan's memory model");
        let of_halves =
            |i: &&_| is(i, op::CAPABILITY) && [FLOAT16, STORAGE_16_BIT].contains(&i.operands[0]);
        assert_eq!(all.iter().filter(of_halves).count(), 0, "{name}: asks for halves");
        let pow = |i: &&_| is(i, op::EXTENDED) && i.operands[3] == POW;
        assert_eq!(all.iter().filter(pow).count(), 0, "{name}: `pow` differs between devices");
        // a local array is a variable whose type is a pointer to an array
        let arrays: Vec<_> =
            all.iter().filter(|i| is(i, op::TYPE_ARRAY)).map(|i| i.operands[0]).collect();
        let pointers: Vec<_> = all
            .iter()
            .filter(|i| is(i, op::TYPE_POINTER) && arrays.contains(&i.operands[2]))
            .map(|i| i.operands[0])
            .collect();
        let local = all.iter().filter(|i| {
            is(i, op::VARIABLE)
                && i.operands[2] == FUNCTION_STORAGE
                && pointers.contains(&i.operands[0])
        });
        // one kernel has them on purpose: it loops over arrays
        let is_allowed = name == "core_functions";
        assert!(local.count() == 0 || is_allowed, "{name}: a local array stays in memory");
    }
}

/// A loop's last block branches to the first one unconditionally.
#[test]
fn loops_end_at_their_conditions() {
    for kernel in MODULES.all() {
        let words = kernel.spirv_words();
        let all: Vec<_> = instructions(&words).collect();
        for merge in all.iter().filter(|i| is(i, op::LOOP_MERGE)) {
            let is_last =
                |i: &Instruction<'_>| is(i, op::LABEL) && i.operands[0] == merge.operands[1];
            let last = all.iter().position(is_last).expect("a loop has a last block");
            let name = &kernel.entry().name;
            assert!(is(&all[last + 1], op::BRANCH), "{name}: docs/kernels.md#loops");
        }
    }
}

/// Only workgroup memory and storage barriers make invocations wait, and the CPU run knows which kernels do.
#[test]
fn only_kernels_that_wait_have_barriers() {
    for (kernel, point) in entry_points() {
        let words = MODULES.compiled_kernel(kernel, &point).unwrap().spirv_words();
        let barriers = instructions(&words).any(|i| is(&i, op::BARRIER));
        let waits = matches!(kernel.run, CpuRun::Invocation(_)) || !point.shared.is_empty();
        assert_eq!(barriers, waits, "{}", point.name);
    }
}

#[test]
fn naga_takes_every_entry_point() {
    for (kernel, point) in entry_points() {
        let words = MODULES.compiled_kernel(kernel, &point).unwrap().spirv_words();
        let module = naga_module(&words).unwrap_or_else(|error| panic!("{}: {error}", point.name));
        assert_eq!(module.entry_points.len(), 1, "{}", point.name);
    }
}

/// One instruction of a module.
#[derive(Clone, Copy, Debug)]
struct Instruction<'a> {
    /// Index of its first word in the module.
    at: usize,
    /// Opcode in the specification.
    opcode: u32,
    /// Words after the first one.
    operands: &'a [u32],
}

/// The instructions of a module.
fn instructions(words: &[u32]) -> impl Iterator<Item = Instruction<'_>> {
    const HEADER: usize = 5;
    let mut at = HEADER;
    std::iter::from_fn(move || {
        let length = (words.get(at)? >> 16) as usize;
        let opcode = words[at] & 0xffff;
        let found = Instruction { at, opcode, operands: &words[at + 1..at + length] };
        at += length;
        Some(found)
    })
}

fn is(instruction: &Instruction<'_>, opcode: u32) -> bool {
    instruction.opcode == opcode
}

/// The trap: NaN and infinity as literals.
#[test]
fn naga_refuses_literals_that_are_no_numbers() {
    let module = MODULES.find("project").unwrap().spirv_words().into_owned();
    naga_module(&module).expect("a module as it is");
    let float = instructions(&module).find(|i| i.opcode == op::TYPE_FLOAT).unwrap().operands[0];
    let constant = instructions(&module)
        .find(|i| i.opcode == op::CONSTANT && i.operands[0] == float)
        .expect("a constant")
        .at;
    for value in [f32::NAN, f32::INFINITY] {
        let mut broken = module.clone();
        broken[constant + 3] = value.to_bits();
        let error = naga_module(&broken).expect_err("naga takes it now: docs/kernels.md");
        assert!(error.contains("NaN") || error.contains("Inf"), "{error}");
    }
}

/// The trap: naga drops the decoration that forbids drivers to fuse operations.
#[test]
fn naga_drops_no_contraction() {
    const NO_CONTRACTION: u32 = 42;
    let decorated = |words: &[u32]| {
        instructions(words)
            .filter(|i| i.opcode == op::DECORATE && i.operands[1] == NO_CONTRACTION)
            .count()
    };
    for (kernel, point) in entry_points() {
        let words = MODULES.compiled_kernel(kernel, &point).unwrap().spirv_words();
        let arithmetic = instructions(&words).any(|i| matches!(i.opcode, 129 | 131 | 133 | 136));
        assert_eq!(decorated(&words) > 0, !kernel.fused && arithmetic, "{}", point.name);
    }
    let words = MODULES.find("project").unwrap().spirv_words();
    let module = naga_module(&words).unwrap();
    let info = naga::valid::Validator::new(
        naga::valid::ValidationFlags::all(),
        naga::valid::Capabilities::default(),
    )
    .validate(&module)
    .unwrap();
    let options = naga::back::spv::Options::default();
    let written = naga::back::spv::write_vec(&module, &info, &options, None).unwrap();
    assert_eq!(decorated(&written), 0, "naga keeps it now: docs/kernels.md, docs/correctness.md");
}

/// The trap: Rust-GPU's own library panics on a CPU.
#[test]
fn barriers_of_spirv_std_panic_on_the_cpu() {
    let barrier = silently(spirv_std::arch::workgroup_memory_barrier_with_group_sync);
    assert!(barrier.is_err(), "it works now: docs/kernels.md");
}

/// The trap: llvmpipe silently ends an invocation after 65,536 iterations.
#[test]
fn llvmpipe_ends_long_invocations() {
    const SAMPLES: u32 = 1 << 17;
    // the CPU run would refuse more iterations than the kernel declares
    for (name, device) in devices::gpus() {
        let transmittance = device.zeros("transmittance", 1).unwrap();
        let log_rho = vec![-1.0 / SAMPLES as f32; SAMPLES as usize];
        let kernel = SegmentProductKernel {
            params: SegmentProductParams { pairs: 1, power: 1.0 },
            first_sample: &device.upload("first_sample", &[0, SAMPLES]).unwrap(),
            log_rho: &device.upload("log_rho", &log_rho).unwrap(),
            transmittance: &transmittance,
        };
        device.run(&kernel, 1, 1).unwrap();
        let found: f32 = device.read(&transmittance).unwrap()[0];
        let all = (found - (-1.0_f32).exp()).abs() < 1e-4;
        let half = (found - (-0.5_f32).exp()).abs() < 1e-4;
        if !device.choice().contains("llvmpipe") {
            assert!(all, "{name}: {found}");
        } else if all {
            // another version of Mesa may not have the limit
            skip("llvmpipe's limit", "this one takes more iterations: docs/kernels.md");
        } else {
            assert!(half, "{name}: {found}");
        }
    }
}
