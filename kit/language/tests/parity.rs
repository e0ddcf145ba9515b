//! The kernels of the language on every device, beside the CPU and the equations.

use muslin::kernels;
use muslin::subgroup::SIZES;
use muslin_check::{Rounding, devices};
use muslin_device::{Device, DeviceOptions, Modules};
use muslin_language::{MODULES, cases};

#[test]
fn the_language_is_right_on_every_device() {
    muslin_check::assert_parity(&cases(), &MODULES);
}

/// A device chooses the size of its subgroups. The thorough ones run each size beside another.
#[test]
fn kernels_with_subgroups_take_every_size() {
    let checked = SIZES.map(|size| DeviceOptions::checked().subgroup_size(size));
    let thorough = (0..SIZES.len() as u64).map(DeviceOptions::thorough);
    let subgroups = kernels().filter(|kernel| kernel.subgroups);
    let names: Vec<_> = subgroups.map(|kernel| kernel.name).collect();
    assert!(!names.is_empty());
    for options in checked.into_iter().chain(thorough) {
        let device = Device::open(&options, Modules::none()).expect("the CPU");
        for case in cases().iter().filter(|case| names.contains(&case.kernel)) {
            let found = case.compare_with_exact(&device, Rounding::AsWritten);
            let found = found.unwrap_or_else(|error| panic!("{options:?}: {error}"));
            assert!(found.values > 0 && found.failures == 0, "{}: {options:?}", case.kernel);
        }
    }
}

/// Nothing in the results of these depends on the order of invocations, but the places in a table.
#[test]
fn kernels_that_share_memory_pass_the_thorough_device() {
    for device in [devices::checked(), devices::thorough(1), devices::thorough(8)] {
        for kernel in ["atomics", "distinct", "sort_rows"] {
            let all = cases();
            let case = all.iter().find(|case| case.kernel == kernel).expect("a case");
            let found = case.compare_with_exact(&device, Rounding::AsWritten);
            let found = found.unwrap_or_else(|error| panic!("{error}"));
            assert!(found.values > 0 && found.failures == 0, "{kernel}: {found:?}");
        }
    }
}

/// WGSL has subgroups only where a module says so, and naga does not say it.
#[test]
fn browsers_are_told_of_subgroups() {
    for (kernel, has_subgroups) in [("scan_and_shuffle", true), ("sort_rows", false)] {
        let module = MODULES.find(kernel).expect("a kernel").to_wgsl().expect("WGSL");
        assert_eq!(module.starts_with("enable subgroups;"), has_subgroups, "{module}");
    }
}
