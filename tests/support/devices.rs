//! The devices that tests run on: those of [`organza_check`], with organza's kernels.

use organza::{Device, MODULES};
pub use organza_check::devices::{checked, checked_variants, cpu, cpus, with};

/// Like [`organza_check::devices::all`].
///
/// # Panics
/// As there.
#[must_use]
pub fn all() -> Vec<(&'static str, Device)> {
    organza_check::devices::all(&MODULES)
}

/// Like [`organza_check::devices::gpus`].
///
/// # Panics
/// As there.
#[must_use]
pub fn gpus() -> Vec<(&'static str, Device)> {
    organza_check::devices::gpus(&MODULES)
}

/// Like [`organza_check::devices::variants`].
///
/// # Panics
/// As there.
#[must_use]
pub fn variants() -> Vec<(&'static str, [Device; 2])> {
    organza_check::devices::variants(&MODULES)
}

/// Whether there is a GPU; says so where there is none.
///
/// # Panics
/// Like [`gpus`].
#[must_use]
pub fn has_gpu() -> bool {
    !gpus().is_empty()
}
