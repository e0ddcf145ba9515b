//! The devices that tests run on, and a note for tests that did not run. All of these panic if a device cannot be opened.

use std::collections::BTreeSet;
use std::io::Write;
use std::sync::Mutex;

use muslin_device::{Device, DeviceOptions, Error, InstructionSet, Modules, SpirvPath};

/// The paths of SPIR-V to a GPU, by name.
const GPUS: [(&str, SpirvPath); 2] =
    [("gpu passthrough", SpirvPath::Passthrough), ("gpu naga", SpirvPath::Naga)];

/// All devices to run a kernel on: `cpu`, and the ones of [`gpus`].
#[must_use]
pub fn all(modules: &'static Modules) -> Vec<(&'static str, Device)> {
    std::iter::once(("cpu", cpu(None))).chain(gpus(modules)).collect()
}

/// The GPU twice: with SPIR-V as it is, and through naga. Empty without a GPU.
///
/// Without a GPU the tests run only on the CPU, and say so. `MUSLIN_REQUIRE_GPU=1` makes that a failure.
///
/// # Panics
/// If a GPU is required and there is none, or if there is one that cannot be used.
#[must_use]
pub fn gpus(modules: &'static Modules) -> Vec<(&'static str, Device)> {
    let mut devices = Vec::new();
    for (name, path) in GPUS {
        match Device::open(&DeviceOptions::gpu(path), modules) {
            Ok(device) => {
                // for `cargo test -- --nocapture`
                println!("{name}: {}", device.choice());
                devices.push((name, device));
            }
            Err(Error::NoGpu { reason }) => {
                let required =
                    std::env::var_os("MUSLIN_REQUIRE_GPU").is_some_and(|value| value != "0");
                assert!(!required, "MUSLIN_REQUIRE_GPU is set, but {name}: {reason}");
                skip(name, &reason);
            }
            Err(error) => panic!("{name}: {error}"),
        }
    }
    devices
}

/// The GPU with plain kernels and with its variants, each with SPIR-V as it is and through naga. Empty without a GPU.
#[must_use]
pub fn variants(modules: &'static Modules) -> Vec<(&'static str, [Device; 2])> {
    let open = |path, variants| {
        let options = DeviceOptions::gpu(path).variants(variants);
        Device::open(&options, modules).expect("it was there a moment ago")
    };
    let pair = |path| [open(path, false), open(path, true)];
    let gpus = gpus(modules).into_iter();
    gpus.filter_map(|(name, _)| Some((name, pair(path_of(name)?)))).collect()
}

/// The path of SPIR-V to a device of [`gpus`].
fn path_of(name: &str) -> Option<SpirvPath> {
    GPUS.into_iter().find(|gpu| gpu.0 == name).map(|gpu| gpu.1)
}

/// The CPU with a number of threads.
#[must_use]
pub fn cpu(threads: Option<usize>) -> Device {
    Device::open(&DeviceOptions::cpu(threads), Modules::none()).expect("the CPU")
}

/// The CPU with all checks for mistakes in kernels: [`DeviceOptions::checked`].
#[must_use]
pub fn checked() -> Device {
    Device::open(&DeviceOptions::checked(), Modules::none()).expect("the CPU")
}

/// The CPU with all checks, also those that take several times as long: [`DeviceOptions::thorough`]. For CI.
#[must_use]
pub fn thorough(seed: u64) -> Device {
    Device::open(&DeviceOptions::thorough(seed), Modules::none()).expect("the CPU")
}

/// Like [`checked`], but with the [variants](muslin_kernel::KernelInfo::variant) of kernels: so their copies to
/// workgroup memory run without a GPU.
#[must_use]
pub fn checked_variants() -> Device {
    Device::open(&DeviceOptions::checked().variants(true), Modules::none()).expect("the CPU")
}

/// The CPU with an instruction set.
#[must_use]
pub fn with(instruction_set: InstructionSet) -> Device {
    let options = DeviceOptions::cpu(None).instruction_set(instruction_set);
    Device::open(&options, Modules::none()).expect("the CPU")
}

/// The CPU where denormals are zeros, as on some GPUs: [`DeviceOptions::flush_denormals`].
#[must_use]
pub fn flushing() -> Device {
    let options = DeviceOptions::cpu(None).flush_denormals(true);
    Device::open(&options, Modules::none()).expect("the CPU")
}

/// The CPU with each instruction set that it has.
#[must_use]
pub fn cpus() -> Vec<(&'static str, Device)> {
    let sets = InstructionSet::ALL.into_iter().filter(|set| set.is_available());
    sets.map(|set| (set.as_str(), with(set))).collect()
}

static SAID: Mutex<BTreeSet<String>> = Mutex::new(BTreeSet::new());

/// Reports, once, that something is not tested, and why.
///
/// The message bypasses the test harness, which hides the output of tests that pass.
pub fn skip(what: &str, reason: &str) {
    let line = format!("skipped {what}: {reason}");
    let mut said = SAID.lock().expect("no test panics there");
    if said.insert(line.clone()) {
        writeln!(std::io::stderr(), "{line}").expect("standard error is open");
    }
}
