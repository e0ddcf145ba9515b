//! The test case of a kernel: its inputs, its equation and its tolerance.

use super::measure::{Bound, Output};
use super::runner::KernelRunner;
use muslin_device::Result;

/// A set of a kernel's inputs, with everything that tests need to know about the kernel.
pub trait Parity: Sized + 'static {
    /// Name of the kernel.
    const KERNEL: &'static str;
    /// Largest error of an output, in units of [`Parity::bound`]'s scale; 0 if all outputs are integers.
    const TOLERANCE: f64 = 0.0;
    /// The reason for the tolerance, and the values that the inputs avoid.
    const WHY: &'static str = "integers";
    /// The part of each output's written elements that [`Parity::exact_at`] must give, over all sets.
    ///
    /// If a case lowers it, a comment says why.
    const COMPARED: f64 = 0.9;

    /// The sets of inputs, each with a name.
    fn sets() -> Vec<(String, Self)>;

    /// Runs the kernel.
    ///
    /// # Errors
    /// Any error of the device.
    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>>;

    /// The error allowed for an element. `cpu` is the CPU's output.
    fn bound(&self, cpu: &Output, index: usize, rounding: Rounding) -> Bound {
        let _ = rounding;
        Bound::relative_to(cpu.floats()[index].abs())
    }

    /// The equation in f64, for an element of an output. `None` for padding, for elements that the kernel does not write, and if
    /// rounding decides.
    fn exact_at(&self, output: &str, index: usize) -> Option<f64> {
        let _ = (output, index);
        None
    }

    /// Like [`exact_at`](Self::exact_at), for all `len` elements of an output: for equations that compute them together.
    /// Missing elements at the end count as `None`.
    fn exact(&self, output: &str, len: usize) -> Vec<Option<f64>> {
        (0..len).map(|index| self.exact_at(output, index)).collect()
    }

    /// The error allowed between a device's element and `exact`. By default it is the same as between the device and
    /// the CPU.
    ///
    /// It is wider only if the kernel's roundings, which are the same on all devices, exceed the differences between
    /// devices.
    fn exact_bound(&self, exact: &Output, index: usize, rounding: Rounding) -> Bound {
        self.bound(exact, index, rounding)
    }
}

/// Declares a case whose inputs are those of its kernel: `case!(pub Square(SquareInputs))` is a struct around them.
#[macro_export]
macro_rules! case {
    ($visibility:vis $case:ident($inputs:ty)) => {
        #[doc = concat!("A case around [`", stringify!($inputs), "`].")]
        #[derive(Clone)]
        $visibility struct $case($visibility $inputs);

        impl ::core::ops::Deref for $case {
            type Target = $inputs;

            fn deref(&self) -> &$inputs {
                &self.0
            }
        }

        impl ::core::ops::DerefMut for $case {
            fn deref_mut(&mut self) -> &mut $inputs {
                &mut self.0
            }
        }
    };
}

/// The rounding of a device.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rounding {
    /// Operations run as written: SPIR-V is passed through, with its `NoContraction`.
    AsWritten,
    /// The driver may fuse and regroup operations: naga drops the decoration.
    Regrouped,
}
