//! Tests of kernels: [parity](case) cases, and [snapshots](snapshot) with pictures.
//!
//! A [`Case`] has a kernel's inputs, its equation in f64 and its tolerance. A [`KernelRunner`] runs the kernel on a device, and a
//! [`Report`] says how far each device is from the CPU.

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
