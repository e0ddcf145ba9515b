//! Tests of kernels: [parity](mod@case) cases, and [snapshots](snapshot).
//!
//! # How devices are compared
//!
//! A kernel's case has its inputs and its equation. It implements [`Parity`]:
//!
//! ```
//! # extern crate muslin_kernel as muslin;
//! use muslin_check::prelude::*;
//! use muslin::prelude::*;
//!
//! #[params]
//! pub struct SquareParams {
//!     pub count: u32,
//! }
//!
//! #[kernel(threads(64), over(params.count))]
//! pub fn square(id: Invocation, params: &SquareParams, input: Read<f32>, output: Write<f32>) {
//!     if id.index() < params.count {
//!         output.write(id.index(), input.read(id.index()) * input.read(id.index()));
//!     }
//! }
//!
//! case!(Square(SquareInputs));
//!
//! impl Parity for Square {
//!     fn sets() -> Vec<(String, Self)> {
//!         inputs::sets(|count, fill, random| {
//!             let input = fill.values(random, count as usize, [-2.0, 2.0], 1e19);
//!             Self(SquareInputs { params: SquareParams { count }, input, output: unwritten(count as usize) })
//!         })
//!     }
//!
//!     fn exact_at(&self, _: &str, index: usize) -> Option<Rounded> {
//!         let x = Rounded::from(self.input[index]);
//!         Some(x * x)
//!     }
//! }
//!
//! # fn main() {
//! # use muslin_check::{Rounding, cases, devices};
//! # let square = cases(env!("CARGO_PKG_NAME")).into_iter().find(|case| case.kernel == "square").unwrap();
//! # let measure = square.compare_with_exact(&devices::checked(), Rounding::AsWritten).unwrap();
//! # assert!(measure.is_ok() && measure.values > 0);
//! # }
//! ```
//!
//! The equation is written in [`Rounded`](number::Rounded) numbers: each is an f64, and how far an f32 of a device may be off. So the
//! equation gives the tolerance, too. [`gradient`](number::gradient) gives a backward kernel's values from the forward equation.
//!
//! A test then runs all cases on every device of this machine, and compares each with the CPU and with its equation:
//!
//! ```ignore
//! #[test]
//! fn every_kernel_is_right_on_every_device() {
//!     muslin_check::assert_parity(&cases(env!("CARGO_PKG_NAME")), &MODULES);
//! }
//! ```
//!
//! Outputs start as canaries. So a write to a wrong place, or a read of an unwritten element, shows as a difference.
//! [`Report`] has the largest differences, for a table.
//!
//! # Snapshots
//!
//! [`snapshots`] stores the results of a program as tensors and pictures. It needs the feature `snapshots`.

mod assert;
pub mod bench;
pub mod case;
pub mod devices;
pub mod inputs;
pub mod measure;
pub mod number;
mod own;
pub mod prelude;
pub mod report;
pub mod runner;
#[cfg(feature = "snapshots")]
pub mod snapshot;

pub use assert::{assert_parity, missing};
pub use case::Case;
// the result type of cases
pub use muslin_device::Result;

pub use case::{Parity, Rounding, cases};
#[doc(hidden)]
pub use linkme;
pub use measure::{Measure, Output, Worst};
pub use report::{Report, Row};
pub use runner::{Canary, KernelRunner, unwritten};
