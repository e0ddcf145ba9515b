//! Snapshots: what is recorded, how two records are compared, and what a failure leaves behind.

pub mod exact;
pub mod generator;

pub use organza_check::snapshot::{compare, picture, tensors};
