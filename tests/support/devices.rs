//! The devices that tests run on: those of [`organza_check`], with organza's kernels.

use organza::{Device, MODULES};
pub use organza_check::devices::{checked, checked_variants, cpu, cpus, thorough, with};

/// [`organza_check::devices::all`] with organza's kernels.
///
/// # Panics
/// The same as [`organza_check::devices::all`].
pub fn all() -> Vec<(&'static str, Device)> {
    organza_check::devices::all(&MODULES)
}

/// [`organza_check::devices::gpus`] with organza's kernels.
///
/// # Panics
/// The same as [`organza_check::devices::gpus`].
pub fn gpus() -> Vec<(&'static str, Device)> {
    organza_check::devices::gpus(&MODULES)
}

/// [`organza_check::devices::variants`] with organza's kernels.
///
/// # Panics
/// The same as [`organza_check::devices::variants`].
pub fn variants() -> Vec<(&'static str, [Device; 2])> {
    organza_check::devices::variants(&MODULES)
}

/// Whether there is a GPU. Prints a message if there is none.
///
/// # Panics
/// If [`gpus`] panics.
pub fn has_gpu() -> bool {
    !gpus().is_empty()
}
