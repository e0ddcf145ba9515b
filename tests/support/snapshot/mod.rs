//! Snapshots: records, comparisons of two records, and the files of a failure.

pub mod exact;
pub mod generator;

pub use muslin_check::snapshot::{compare, picture, tensors};
