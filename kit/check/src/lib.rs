//! Tests of kernels: [parity](mod@case) cases, and [snapshots](snapshot) with pictures.
//!
//! # How devices are compared
//!
//! A kernel's case has its inputs, its equation in f64, and the error allowed on a device. It implements [`Parity`]:
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
//! #[kernel(threads(64))]
//! pub fn square(id: Invocation, params: &SquareParams, input: Read<f32>, output: Write<f32>) {
//!     if id.index() < params.count {
//!         output.write(id.index(), input.read(id.index()) * input.read(id.index()));
//!     }
//! }
//!
//! case!(Square(SquareInputs));
//!
//! impl Parity for Square {
//!     const KERNEL: &'static str = "square";
//!     const TOLERANCE: f64 = 1.2e-7;
//!     const WHY: &'static str = "one rounding";
//!
//!     fn sets() -> Vec<(String, Self)> {
//!         inputs::sets(|count, fill, random| {
//!             let input = fill.values(random, count as usize, [-2.0, 2.0], 1e19);
//!             Self(SquareInputs { params: SquareParams { count }, input, output: unwritten(count as usize) })
//!         })
//!     }
//!
//!     fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
//!         runner.run(&self.kernel(), self.params.count, 1)
//!     }
//!
//!     fn exact_at(&self, _: &str, index: usize) -> Option<f64> {
//!         Some(f64::from(self.input[index]).powi(2))
//!     }
//! }
//!
//! # fn main() {
//! # use muslin_check::{Case, devices};
//! # let measure = Case::new::<Square>().compare_with_exact(&devices::checked(), Rounding::AsWritten).unwrap();
//! # assert!(measure.is_ok() && measure.values > 0);
//! # }
//! ```
//!
//! A test then runs all cases on every device of this machine, and compares each with the CPU and with its equation:
//!
//! ```ignore
//! #[test]
//! fn every_kernel_is_right_on_every_device() {
//!     muslin_check::assert_parity(&[Case::new::<Square>()], &MODULES);
//! }
//! ```
//!
//! Outputs start as canaries. So a write to a wrong place, or a read of an unwritten element, shows as a difference.
//! [`Report`] has the largest differences, for a table.
//!
//! # Snapshots
//!
//! [`snapshots`] stores the results of a program, and shows a change as a picture. It needs the feature `snapshots`.

mod assert;
pub mod bench;
pub mod case;
pub mod devices;
pub mod inputs;
pub mod measure;
pub mod prelude;
pub mod report;
pub mod runner;
#[cfg(feature = "snapshots")]
pub mod snapshot;

pub use assert::{assert_parity, missing};
pub use case::Case;
// the result type of cases
pub use muslin_device::Result;

pub use case::{Parity, Rounding};
pub use measure::{Bound, Measure, Output, Values, Worst};
pub use report::{Report, Row};
pub use runner::{Canary, KernelRunner, unwritten};
