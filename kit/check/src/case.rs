//! The test case of a kernel: its inputs, its equation in f64, its tolerance, and the comparison of a device with both.

use crate::{Bound, Canary, KernelRunner, Measure, Output, Values};
use muslin_device::{Device, Result};

/// A kernel's case, without the type of its inputs.
#[derive(Clone, Copy, Debug)]
pub struct Case {
    /// Name of the kernel.
    pub kernel: &'static str,
    /// See [`Parity::TOLERANCE`].
    pub tolerance: f64,
    /// See [`Parity::WHY`].
    pub why: &'static str,
    /// See [`Parity::COMPARED`].
    pub compared: f64,
    measure: fn(&Device, &Device, Rounding) -> Result<Measure>,
    hold: fn(&Device, Rounding) -> Result<Measure>,
    run: fn(&Device, &str) -> Result<()>,
}

impl Case {
    /// The case of a kernel that implements [`Parity`].
    #[must_use]
    pub fn new<P: Parity>() -> Self {
        Self {
            kernel: P::KERNEL,
            tolerance: P::TOLERANCE,
            why: P::WHY,
            compared: P::COMPARED,
            measure: measure::<P>,
            hold: compare_with_exact::<P>,
            run: run::<P>,
        }
    }

    /// The name of the entry point that a device runs.
    #[must_use]
    pub fn entry_point(&self, device: &Device) -> &'static str {
        let kernel = muslin_kernel::kernels().find(|kernel| kernel.name == self.kernel);
        kernel.map_or(self.kernel, |kernel| device.entry_point(kernel).name)
    }

    /// Runs all sets on both devices, and compares the results.
    ///
    /// # Errors
    /// Any error of a device.
    pub fn measure(&self, cpu: &Device, device: &Device, rounding: Rounding) -> Result<Measure> {
        (self.measure)(cpu, device, rounding)
    }

    /// Runs all sets on a device, and compares with the equations in f64, within the case's own bound.
    ///
    /// [`Measure::values`] is the number of elements for which the equations have a value.
    ///
    /// # Errors
    /// Any error of the device.
    pub fn compare_with_exact(&self, device: &Device, rounding: Rounding) -> Result<Measure> {
        (self.hold)(device, rounding)
    }

    /// Runs the set of this name.
    ///
    /// # Errors
    /// Any error of the device.
    pub fn run(&self, device: &Device, set: &str) -> Result<()> {
        (self.run)(device, set)
    }
}

fn run<P: Parity>(device: &Device, set: &str) -> Result<()> {
    let mut sets = P::sets().into_iter().filter(|(name, _)| name == set);
    sets.try_for_each(|(_, set)| set.run(&KernelRunner::new(device, P::KERNEL)).map(drop))
}

fn measure<P: Parity>(cpu: &Device, device: &Device, rounding: Rounding) -> Result<Measure> {
    let mut measure = Measure::default();
    for (name, set) in P::sets() {
        let expected = set.run(&KernelRunner::new(cpu, P::KERNEL))?;
        let found = set.run(&KernelRunner::with_other_canaries(device, P::KERNEL))?;
        assert_eq!(expected.len(), found.len(), "outputs of `{}`", P::KERNEL);
        for (expected, found) in expected.iter().zip(&found) {
            measure.add(&name, expected, found, P::TOLERANCE, |index| {
                set.bound(expected, index, rounding)
            });
        }
    }
    Ok(measure)
}

/// Runs all sets and compares them with [`Parity::exact`].
fn compare_with_exact<P: Parity>(device: &Device, rounding: Rounding) -> Result<Measure> {
    let mut measure = Measure::default();
    for (name, set) in P::sets() {
        for output in set.run(&KernelRunner::new(device, P::KERNEL))? {
            add(&mut measure, &name, &set, &output, rounding);
        }
    }
    Ok(measure)
}

/// Compares one output of a set.
fn add<P: Parity>(measure: &mut Measure, name: &str, set: &P, output: &Output, rounding: Rounding) {
    let found = output.to_f64();
    let mut exact = set.exact(output.name, found.len());
    let given = exact.len();
    let all = found.len();
    assert!(given <= all, "`{}` has {all} values in `{}`, `exact` {given}", P::KERNEL, output.name);
    exact.resize(all, None);
    let is_float = matches!(output.values, Values::Float(_));
    let bound = |expected: &Output, index| {
        if is_float { set.exact_bound(expected, index, rounding) } else { Bound::EXACT }
    };
    let compared = exact.iter().flatten().count();
    let written = (0..found.len())
        .filter(|&index| exact[index].is_some() || !is_canary(found[index], is_float))
        .count();
    // an element without a value in the equations is not checked, but padding must stay unwritten
    let expected = (0..found.len()).map(|index| match exact[index] {
        Some(exact) => exact,
        None if is_float
            && bound(output, index) == Bound::EXACT
            && !is_canary(found[index], true) =>
        {
            f64::from(f32::CANARY)
        }
        None => found[index],
    });
    let expected = Output { name: output.name, values: Values::Float(expected.collect()) };
    let found = Output { name: output.name, values: Values::Float(found) };
    let all = measure.values;
    measure.add(name, &expected, &found, P::TOLERANCE, |index| bound(&expected, index));
    measure.values = all + compared;
    let share = measure.compared.entry(output.name).or_default();
    *share = [share[0] + compared, share[1] + written];
}

/// Whether a kernel has not written an element. An output that is the sum of two rows has two canaries.
fn is_canary(found: f64, is_float: bool) -> bool {
    let float = f64::from(f32::CANARY);
    let integer = f64::from(u32::CANARY);
    if is_float { found == float || found == 2.0 * float } else { found == integer }
}

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
