//! Everyday kernels, one subject a file: the host's function, and the kernels' parity cases. The kernels are in the files of the same
//! names in `../kernels/src`.
//!
//! `tests/everyday.rs` compares each with ordinary Rust on all devices, and measures them.

pub mod blur;
pub mod compact;
pub mod fft;
pub mod halves;
pub mod hash_table;
pub mod histogram;
pub mod k_means;
pub mod matrix;
pub mod matrix_tiles;
pub mod prefix_sum;
pub mod radix_sort;
pub mod random;
pub mod sum;
pub mod transpose;

use muslin_check::Case;
use muslin_device::Modules;

/// The compiled kernels.
pub static MODULES: Modules = muslin_device::modules!();

/// The case of each kernel.
#[must_use]
pub fn cases() -> Vec<Case> {
    muslin_check::cases(env!("CARGO_PKG_NAME"))
}
