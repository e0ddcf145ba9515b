//! The cases of kernels that test the kernel language.

mod core_functions;
mod elementary;
mod language;
mod small_integers;
mod vectors;

use muslin_check::Case;
use muslin_device::Modules;

/// The compiled kernels.
pub static MODULES: Modules = muslin_device::modules!();

/// The case of each kernel.
#[must_use]
pub fn cases() -> Vec<Case> {
    vec![
        Case::new::<core_functions::CoreFunctions>(),
        Case::new::<elementary::Elementary>(),
        Case::new::<language::ByteHistogram>(),
        Case::new::<language::SortRows>(),
        Case::new::<language::KeepPositive>(),
        Case::new::<language::ScanAndShuffle>(),
        Case::new::<language::AsWritten>(),
        Case::new::<language::Compared>(),
        Case::new::<small_integers::U8>(),
        Case::new::<small_integers::U16>(),
        Case::new::<small_integers::I8>(),
        Case::new::<small_integers::I16>(),
        Case::new::<vectors::VectorMethods>(),
    ]
}
