//! The compiled kernels belong to the kernel sources.

use std::path::Path;

use muslin_manifest::{Interface, sha256, source_hash};
use organza::MODULES;

const REMEDY: &str = "run `cargo xtask kernels` and commit what it writes to host/render/kernels \
                      (docs/adding-a-kernel.md says how to get the compiler)";

#[test]
fn kernels_are_compiled_from_these_sources() {
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let sources = source_hash(&workspace, &MODULES.manifest().sources).unwrap();
    let compiled = &MODULES.manifest().source_hash;
    assert!(
        *compiled == sources,
        "the compiled kernels are not from these sources: {REMEDY}\n  \
         sources: {sources}\n  compiled from: {compiled}"
    );
}

#[test]
fn every_kernel_is_compiled_as_it_is_declared() {
    for kernel in muslin::kernels() {
        for point in kernel.entry_points() {
            let name = point.name;
            let Some(entry) = MODULES.manifest().find(name) else {
                panic!("the kernel `{name}` is not compiled: {REMEDY}");
            };
            assert_eq!(
                entry.interface,
                Interface::new(kernel, &point),
                "the compiled kernel `{name}` (left) is not the declared one (right): {REMEDY}"
            );
            assert_eq!(entry.file, kernel.source(), "`{name}` has moved: {REMEDY}");
            assert_eq!(entry.package, kernel.package, "`{name}` has moved: {REMEDY}");
        }
    }
}

#[test]
fn modules_match_the_manifest() {
    assert_eq!(
        MODULES.all().count(),
        MODULES.manifest().kernels.len(),
        "modules are missing from host/render/kernels: {REMEDY}"
    );
    for kernel in MODULES.all() {
        let entry = kernel.entry();
        let spirv = kernel.spirv();
        assert_eq!(entry.spirv_bytes, spirv.len() as u64, "{}: {REMEDY}", entry.spirv);
        assert_eq!(entry.spirv_sha256, sha256(spirv), "{}: {REMEDY}", entry.spirv);
    }
}

/// For review: what browsers get of a kernel with a loop, of one with barriers, and of one with atomics.
#[test]
fn kernels_of_browsers() {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path("../snapshots");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| {
        for name in ["segment_product", "scan_block", "occupancy_add"] {
            let text = MODULES.find(name).and_then(|kernel| kernel.to_wgsl()).expect(REMEDY);
            insta::assert_snapshot!(format!("{name}_wgsl"), text);
        }
    });
}
