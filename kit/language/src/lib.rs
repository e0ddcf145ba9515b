//! The cases of kernels that test the kernel language.

mod atomics;
mod core_functions;
mod elementary;
mod integers;
mod language;
mod loops;
mod vectors;

use muslin_check::Case;
use muslin_device::Modules;

/// The compiled kernels.
pub static MODULES: Modules = muslin_device::modules!();

/// The case of each kernel.
#[must_use]
pub fn cases() -> Vec<Case> {
    muslin_check::cases(env!("CARGO_PKG_NAME"))
}
