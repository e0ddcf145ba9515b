//! Snapshots: what is recorded, how two records are compared, and what a failure leaves behind.

pub mod exact;
pub mod generator;

pub use organza_check::snapshot::{compare, picture, report, tensors};

use std::path::{Path, PathBuf};

/// The folder of the accepted snapshots.
pub fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("snapshots")
}
