//! The devices that tests run on.

use organza::{Device, DeviceOptions, Error, InstructionSet, SpirvPath};

/// Every way to run a kernel: `cpu`, and `gpu` passed through and through naga where there is one.
///
/// Without a GPU the tests run on the CPU alone, and say so; `ORGANZA_REQUIRE_GPU=1` makes that a failure.
///
/// # Panics
/// Where a GPU is required and there is none, or one is there and cannot be used.
#[must_use]
pub fn all() -> Vec<(&'static str, Device)> {
    let mut devices = vec![("cpu", cpu(None))];
    for (name, path) in [("gpu passthrough", SpirvPath::Passthrough), ("gpu naga", SpirvPath::Naga)]
    {
        match Device::open(&DeviceOptions::gpu(path)) {
            Ok(device) => devices.push((name, device)),
            Err(Error::NoGpu { reason }) => {
                let required =
                    std::env::var_os("ORGANZA_REQUIRE_GPU").is_some_and(|value| value != "0");
                assert!(!required, "ORGANZA_REQUIRE_GPU is set, but {name}: {reason}");
                eprintln!("skipped {name}: {reason}");
            }
            Err(error) => panic!("{name}: {error}"),
        }
    }
    devices
}

/// The CPU with a number of threads.
///
/// # Panics
/// Where threads cannot be started.
#[must_use]
pub fn cpu(threads: Option<usize>) -> Device {
    Device::open(&DeviceOptions::cpu(threads)).expect("the CPU")
}

/// The CPU with an instruction set.
///
/// # Panics
/// Where this CPU does not have it.
#[must_use]
pub fn with(instruction_set: InstructionSet) -> Device {
    let options =
        DeviceOptions { instruction_set: Some(instruction_set), ..DeviceOptions::cpu(None) };
    Device::open(&options).expect("the CPU")
}

/// The CPU with every instruction set that it has.
#[must_use]
pub fn cpus() -> Vec<(&'static str, Device)> {
    let sets = InstructionSet::ALL.into_iter().filter(|set| set.is_available());
    sets.map(|set| (set.as_str(), with(set))).collect()
}
