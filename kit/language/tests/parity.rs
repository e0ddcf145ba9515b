//! The kernels of the language on every device, beside the CPU and the equations.

use muslin::kernels;
use muslin::subgroup::SIZES;
use muslin_check::Rounding;
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
