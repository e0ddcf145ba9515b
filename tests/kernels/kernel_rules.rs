//! Checks that kernels follow the rules of docs/kernels.md, and that the traps described there still exist.

use std::fs;
use std::path::Path;

use muslin::{EntryPoint, KernelInfo, kernels as declared};
use organza::MODULES;
use organza_shaders::transmittance::{SegmentProductKernel, SegmentProductParams};
use organza_tests::devices::{self, skip};
use rspirv::binary::Assemble;
use rspirv::dr::{Instruction, Module, Operand, load_words};
use rspirv::spirv::{Decoration, Op, StorageClass};
use wgpu::naga;

fn page(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs").join(name);
    fs::read_to_string(path).expect("a page of the docs")
}

/// Every entry point of every kernel.
fn entry_points() -> impl Iterator<Item = (&'static KernelInfo, EntryPoint)> {
    declared().flat_map(|kernel| kernel.entry_points().map(move |point| (kernel, point)))
}

fn loaded(words: &[u32]) -> Module {
    load_words(words).expect("a module")
}

fn naga_module(words: &[u32]) -> Result<naga::Module, String> {
    let options = naga::front::spv::Options::default();
    let parser = naga::front::spv::Frontend::new(words.iter().copied(), &options);
    let module = parser.parse().map_err(|error| error.to_string())?;
    let flags = naga::valid::ValidationFlags::all();
    // features that an adapter may have
    use naga::valid::Capabilities;
    let offered = Capabilities::SHADER_INT64 | Capabilities::SHADER_INT64_ATOMIC_ALL_OPS;
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
    for equation in 1..=17 {
        let numbers = glossary.lines().filter_map(|line| line.split('|').nth(1));
        let mut all = numbers.flat_map(|cell| cell.split([',', ' ']));
        assert!(all.any(|number| number == equation.to_string()), "no Eq. {equation}");
    }
}

#[test]
fn modules_keep_the_rules() {
    for kernel in MODULES.all() {
        let name = &kernel.entry().name;
        let module = loaded(&kernel.spirv_words());
        let all = |opcode: Op| module.all_inst_iter().filter(move |i| i.class.opcode == opcode);
        let returns = all(Op::Return).count() + all(Op::ReturnValue).count();
        assert_eq!(returns, all(Op::Function).count(), "{name}: a function has one exit");
        // a local array is a variable whose type is a pointer to an array
        let arrays: Vec<_> = all(Op::TypeArray).filter_map(|i| i.result_id).collect();
        let to_array = |of: &Operand| of.id_ref_any().is_some_and(|id| arrays.contains(&id));
        let pointers: Vec<_> = all(Op::TypePointer)
            .filter(|i| to_array(&i.operands[1]))
            .filter_map(|i| i.result_id)
            .collect();
        let has_local = all(Op::Variable).any(|i| {
            i.operands[0] == Operand::StorageClass(StorageClass::Function)
                && i.result_type.is_some_and(|id| pointers.contains(&id))
        });
        assert!(!has_local, "{name}: a local array stays in memory");
    }
}

/// A loop's last block branches to the first one unconditionally.
#[test]
fn loops_end_at_their_conditions() {
    for kernel in MODULES.all() {
        let module = loaded(&kernel.spirv_words());
        let blocks = || module.functions.iter().flat_map(|function| &function.blocks);
        for merge in module.all_inst_iter().filter(|i| i.class.opcode == Op::LoopMerge) {
            let label = merge.operands[1].id_ref_any();
            let last = blocks().find(|block| block.label_id() == label);
            let end = &last.expect("a loop has a last block").instructions[0];
            let name = &kernel.entry().name;
            assert_eq!(
                end.class.opcode,
                Op::Branch,
                "{name}: docs/kernels.md#what-the-compilers-cant-do"
            );
        }
    }
}

/// Only workgroup memory and storage barriers make invocations wait, and the CPU run knows which kernels do.
#[test]
fn only_kernels_that_wait_have_barriers() {
    for (kernel, point) in entry_points() {
        let module = loaded(&MODULES.compiled_kernel(kernel, &point).unwrap().spirv_words());
        let barriers = module.all_inst_iter().any(|i| i.class.opcode == Op::ControlBarrier);
        let waits = kernel.run.waiting().is_some() || !point.shared.is_empty();
        assert_eq!(barriers, waits, "{}", point.name);
    }
}

/// The trap: NaN and infinity as literals.
#[test]
fn naga_refuses_literals_that_are_no_numbers() {
    let mut module = loaded(&MODULES.find("project").unwrap().spirv_words());
    naga_module(&module.assemble()).expect("a module as it is");
    let globals = &module.types_global_values;
    let float = globals.iter().find(|i| i.class.opcode == Op::TypeFloat).unwrap().result_id;
    let is_float = |i: &Instruction| i.class.opcode == Op::Constant && i.result_type == float;
    let constant = globals.iter().position(is_float).expect("a constant");
    for value in [f32::NAN, f32::INFINITY] {
        let bits = Operand::LiteralBit32(value.to_bits());
        module.types_global_values[constant].operands = vec![bits];
        let error =
            naga_module(&module.assemble()).expect_err("naga takes it now: docs/kernels.md");
        assert!(error.contains("NaN") || error.contains("Inf"), "{error}");
    }
}

/// The trap: naga drops the decoration that forbids drivers to fuse operations.
#[test]
fn naga_drops_no_contraction() {
    const ARITHMETIC: [Op; 4] = [Op::FAdd, Op::FSub, Op::FMul, Op::FDiv];
    let is_decorated = |module: &Module| {
        let decoration = Operand::Decoration(Decoration::NoContraction);
        module.annotations.iter().any(|i| i.operands.contains(&decoration))
    };
    for (kernel, point) in entry_points() {
        let module = loaded(&MODULES.compiled_kernel(kernel, &point).unwrap().spirv_words());
        let computes = module.all_inst_iter().any(|i| ARITHMETIC.contains(&i.class.opcode));
        assert_eq!(is_decorated(&module), !kernel.fused && computes, "{}", point.name);
    }
    let module = naga_module(&MODULES.find("project").unwrap().spirv_words()).unwrap();
    let info = naga::valid::Validator::new(
        naga::valid::ValidationFlags::all(),
        naga::valid::Capabilities::default(),
    )
    .validate(&module)
    .unwrap();
    let options = naga::back::spv::Options::default();
    let written = naga::back::spv::write_vec(&module, &info, &options, None).unwrap();
    assert!(
        !is_decorated(&loaded(&written)),
        "naga keeps it now: docs/kernels.md, docs/correctness.md"
    );
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
            params: SegmentProductParams { pairs: 1, power: 1.0, onto: 0 },
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
