//! The devices that tests run on: [`muslin_check`]'s, with organza's kernels.

pub use muslin_check::devices::{checked, checked_variants, cpu, cpus, skip, thorough, with};
use organza::{Device, MODULES};

/// [`muslin_check::devices::all`] with organza's kernels.
pub fn all() -> Vec<(&'static str, Device)> {
    muslin_check::devices::all(&MODULES)
}

/// A new device, of that name among [`all`].
pub fn named(name: &str) -> Device {
    all().into_iter().find(|(other, _)| *other == name).expect("a device").1
}

/// [`muslin_check::devices::gpus`] with organza's kernels.
pub fn gpus() -> Vec<(&'static str, Device)> {
    muslin_check::devices::gpus(&MODULES)
}

/// [`muslin_check::devices::variants`] with organza's kernels.
pub fn variants() -> Vec<(&'static str, [Device; 2])> {
    muslin_check::devices::variants(&MODULES)
}

/// Whether there is a GPU. Prints a message if there is none.
pub fn has_gpu() -> bool {
    !gpus().is_empty()
}
