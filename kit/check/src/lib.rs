//! Tests of kernels: [parity](case) cases, and [snapshots](snapshot) with pictures.
//!
//! A [`Case`] has a kernel's inputs, its equation in f64 and its tolerance. A [`KernelRunner`] runs the kernel on a device, and a
//! [`Report`] says how far each device is from the CPU. [`assert_parity`] is all of it in one line: every case, on every device of
//! this machine. [`snapshots`] keeps what a program computes, and shows a change as a picture.
//!
//! A case implements [`Parity`]. Its outputs start as canaries: a write in a wrong place, or a read of what was never written, is a
//! difference.

mod assert;
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

pub use assert::assert_parity;
pub use case::{Case, Parity, Rounding, missing};
pub use measure::{Bound, Measure, Output, Values, Worst};
pub use report::{Report, Row};
pub use runner::{Canary, KernelRunner};
