//! Tests of kernels: [parity](case) between devices and the CPU, and [snapshots](snapshot) with pictures.

pub mod case;
pub mod devices;
mod hold;
pub mod inputs;
pub mod measure;
pub mod report;
pub mod runner;
pub mod skip;
#[cfg(feature = "snapshots")]
pub mod snapshot;

pub use case::{Case, Parity, Rounding, missing};
pub use measure::{Bound, Measure, Output, Values, Worst};
pub use report::{Report, Row};
pub use runner::{Canary, KernelRunner};
