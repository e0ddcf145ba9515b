//! The variants of kernels: their results compared with the plain entry points', and the devices that run them.

use muslin::KernelInfo;
use muslin::kernel::{
    MAX_STORAGE_BUFFERS, MAX_WORKGROUP_BYTES, MAX_WORKGROUP_INVOCATIONS, workgroup_bytes,
};
use muslin_check::Rounding;
use organza::{DeviceOptions, InstructionSet, Renderer, SpirvPath};
use organza_tests::compare::assert_close;
use organza_tests::{cases, devices};

/// The same tolerance as for the tiles of every device (`tests/pictures/reference_cases.rs`).
const TILES: f64 = 2e-4;

fn kernel(name: &str) -> &'static KernelInfo {
    muslin::kernels().find(|kernel| kernel.name == name).expect("a kernel")
}

#[test]
fn variants_match_plain_kernels() {
    for (name, [plain, variants]) in devices::variants() {
        let passed_through = name.contains(SpirvPath::Passthrough.as_str());
        let mut compared = 0;
        for case in organza_parity::cases() {
            let point = case.entry_point(&variants);
            if point == case.entry_point(&plain) {
                continue;
            }
            compared += 1;
            let measure = case.measure(&plain, &variants, Rounding::AsWritten).expect("it runs");
            assert!(measure.values > 0, "{point} on {name}: {} values", measure.values);
            // without NoContraction, also for fused kernels, a driver may compile each entry point differently
            if passed_through && !kernel(case.kernel).fused {
                assert_eq!(measure.absolute.value, 0.0, "{point} on {name}: {measure:?}");
                assert_eq!(measure.share.value, 0.0, "{point} on {name}: {measure:?}");
            }
            assert!(measure.is_ok(), "{point} on {name}: {measure:?}");
        }
        assert!(compared > 0, "{name} runs no variant");
    }
}

/// A driver may compile each entry point of a `fused` kernel differently. The CPU shows that both add the same numbers in the
/// same order, one lane at a time.
#[test]
fn a_fused_variant_adds_in_the_order_of_the_plain_kernel() {
    let [plain, variants] = [devices::with(InstructionSet::Scalar), devices::checked_variants()];
    let cases = organza_parity::cases();
    let case = cases.iter().find(|case| case.kernel == "dense_weight_backward").expect("a case");
    assert_ne!(case.entry_point(&variants), case.entry_point(&plain));
    let measure = case.measure(&plain, &variants, Rounding::AsWritten).expect("it runs");
    assert!(measure.values > 0);
    assert_eq!(measure.absolute.value, 0.0, "{measure:?}");
    assert_eq!(measure.share.value, 0.0, "{measure:?}");
}

#[test]
fn tiles_of_variants_match_the_reference() {
    let all = cases::all();
    for (name, [_, variants]) in devices::variants() {
        let renderer = Renderer::new(variants);
        for case in &all {
            let scene = renderer.upload(&case.scene).expect("it is uploaded");
            let tiles = renderer.render(&scene, &case.cameras, &case.tiles).expect("it renders");
            let what = format!("{}, tiles of variants on {name}", case.name);
            assert_close(&what, &tiles.data, case.expected("tiles"), TILES);
        }
    }
}

#[test]
fn cpu_and_software_devices_run_plain_kernels() {
    let composite = kernel("composite");
    for (name, device) in devices::all().into_iter().chain(devices::cpus()) {
        let is_software = device.backend() == "cpu" || device.choice().contains("llvmpipe");
        let expected = if is_software { "composite" } else { "composite_shared" };
        assert_eq!(device.entry_point(composite).name, expected, "{name}: {}", device.choice());
    }
}

#[test]
fn a_device_names_the_kernels_it_runs() {
    for (name, [plain, variants]) in devices::variants() {
        assert!(plain.choice().contains("plain kernels"), "{name}: {}", plain.choice());
        assert!(variants.choice().contains("variants with"), "{name}: {}", variants.choice());
        for kernel in muslin::kernels() {
            assert_eq!(plain.entry_point(kernel).name, kernel.name, "{name}");
        }
        assert_eq!(variants.entry_point(kernel("composite")).name, "composite_shared", "{name}");
        // naga's path asks for no 64-bit atomics
        let is_wide = variants.choice().contains("64-bit atomics");
        assert!(!is_wide || name.contains(SpirvPath::Passthrough.as_str()), "{name}");
        let point = variants.entry_point(kernel("hash_grid_backward"));
        let expected = if is_wide { "hash_grid_backward_wide" } else { "hash_grid_backward" };
        assert_eq!(point.name, expected, "{name}");
    }
    // asking for variants does not ask for a GPU
    let cpu = organza::open_device(&DeviceOptions::cpu(None).variants(true)).expect("the CPU");
    assert_eq!(cpu.entry_point(kernel("composite")).name, "composite");
}

/// An adapter is asked for the limits that WebGPU guarantees, and `#[kernel]` refuses what is beyond them.
#[test]
fn kernels_stay_within_the_limits_of_webgpu() {
    let webgpu = wgpu::Limits::default();
    assert_eq!(MAX_STORAGE_BUFFERS, webgpu.max_storage_buffers_per_shader_stage);
    assert_eq!(MAX_WORKGROUP_BYTES, webgpu.max_compute_workgroup_storage_size);
    assert_eq!(MAX_WORKGROUP_INVOCATIONS, webgpu.max_compute_invocations_per_workgroup);
    let shared = kernel("composite").variant.map(|point| workgroup_bytes(point.shared));
    assert!(shared > Some(1_000), "{shared:?}");
}
