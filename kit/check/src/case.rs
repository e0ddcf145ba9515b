//! The test case of a kernel: its inputs and its equation, and the comparison of a device with both.

use std::any::TypeId;
use std::cell::OnceCell;
use std::collections::BTreeMap;
use std::ops::Deref;
use std::sync::Arc;

use crate::number::Rounded;
use crate::{Canary, KernelRunner, Measure, Output};
use muslin_device::{Device, Result};
use muslin_kernel::given::Inputs;
use parking_lot::Mutex;

/// A kernel's case, without the type of its inputs.
#[derive(Clone, Copy, Debug)]
pub struct Case {
    /// Name of the kernel.
    pub kernel: &'static str,
    /// The package that declares the case.
    pub package: &'static str,
    /// See [`Parity::COMPARED`].
    pub compared: f64,
    measure: fn(&Device, &Device, Rounding) -> Result<Measure>,
    hold: fn(&Device, Rounding) -> Result<Measure>,
}

/// Every case that the program is linked with. [`case!`] adds to it.
#[doc(hidden)]
#[linkme::distributed_slice]
pub static CASES: [Case];

/// The cases of a package, such as `env!("CARGO_PKG_NAME")`, by the names of their kernels.
#[must_use]
pub fn cases(package: &str) -> Vec<Case> {
    let mut cases: Vec<_> = CASES.iter().copied().collect();
    cases.retain(|case| case.package == package);
    cases.sort_by_key(|case| case.kernel);
    cases
}

impl Case {
    /// The case of a kernel that implements [`Parity`].
    #[doc(hidden)]
    #[must_use]
    pub const fn new<P: Parity>(package: &'static str) -> Self {
        Self {
            kernel: P::KERNEL,
            package,
            compared: P::COMPARED,
            measure: measure::<P>,
            hold: compare_with_exact::<P>,
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

    /// Runs all sets on a device, and compares with the equations in f64, within the equations' own errors.
    ///
    /// [`Measure::values`] is the number of elements for which the equations have a value.
    ///
    /// # Errors
    /// Any error of the device.
    pub fn compare_with_exact(&self, device: &Device, rounding: Rounding) -> Result<Measure> {
        (self.hold)(device, rounding)
    }
}

/// The equations' values for all elements of an output.
type Values = Arc<[Option<Rounded>]>;

/// A case, the index of a set, the name of an output, and a rounding.
type Key = (TypeId, usize, &'static str, Rounding);

/// The values that have been computed. Equations take longer than kernels, and many devices are compared with the same
/// values.
static COMPUTED: Mutex<BTreeMap<Key, Values>> = Mutex::new(BTreeMap::new());

/// The equations' values for all elements of an output of the set with this index.
fn exact<P: Parity>(index: usize, set: &P, output: &Output, rounding: Rounding) -> Values {
    let key = (TypeId::of::<P>(), index, output.name, rounding);
    if let Some(values) = COMPUTED.lock().get(&key) {
        return Arc::clone(values);
    }
    let all = output.values.len();
    let mut exact = match rounding {
        Rounding::AsWritten => set.exact(output.name, all),
        Rounding::Regrouped => set.exact_regrouped(output.name, all),
    };
    let given = exact.len();
    assert!(given <= all, "`{}` has {all} values in `{}`, `exact` {given}", P::KERNEL, output.name);
    exact.resize(all, None);
    let values = Values::from(exact);
    COMPUTED.lock().insert(key, Arc::clone(&values));
    values
}

/// Compares the outputs of two devices: each may be off by the equations' errors.
fn measure<P: Parity>(cpu: &Device, device: &Device, rounding: Rounding) -> Result<Measure> {
    let mut measure = Measure::default();
    for (at, (name, set)) in P::sets().into_iter().enumerate() {
        let expected = set.run(&KernelRunner::new(cpu, P::KERNEL))?;
        let found = set.run(&KernelRunner::with_other_canaries(device, P::KERNEL))?;
        assert_eq!(expected.len(), found.len(), "outputs of `{}`", P::KERNEL);
        for (expected, found) in expected.iter().zip(&found) {
            let values = OnceCell::new();
            measure.add(&name, expected, found, |index| {
                let value = values.get_or_init(|| exact(at, &set, expected, rounding))[index];
                let value = value.unwrap_or(Rounded::exact(0.0));
                Rounded { error: 2.0 * value.error, ..value }
            });
        }
    }
    Ok(measure)
}

/// Runs all sets and compares them with [`Parity::exact`].
fn compare_with_exact<P: Parity>(device: &Device, rounding: Rounding) -> Result<Measure> {
    let mut measure = Measure::default();
    for (at, (name, set)) in P::sets().into_iter().enumerate() {
        for output in set.run(&KernelRunner::new(device, P::KERNEL))? {
            add(&mut measure, &name, &output, &exact(at, &set, &output, rounding));
        }
    }
    Ok(measure)
}

/// Compares one output of a set.
fn add(measure: &mut Measure, name: &str, output: &Output, exact: &[Option<Rounded>]) {
    let canary = if output.is_exact { f64::from(u32::CANARY) } else { f64::from(f32::CANARY) };
    let expected = |(exact, found): (&Option<Rounded>, &f64)| match exact {
        Some(exact) if output.is_exact && exact.error.is_finite() => Rounded::exact(exact.value),
        Some(exact) => *exact,
        // an output that is the sum of two rows has two canaries
        None if !output.is_exact && *found == 2.0 * canary => Rounded::exact(*found),
        None => Rounded::exact(canary),
    };
    let expected: Vec<_> = exact.iter().zip(&output.values).map(expected).collect();
    let compared = exact.iter().flatten().filter(|exact| exact.error.is_finite()).count();
    let written = exact.iter().flatten().count();
    let values = expected.iter().map(|exact| exact.value);
    let all = measure.values;
    measure.add(name, &Output::float(output.name, values), output, |index| expected[index]);
    measure.values = all + compared;
    let share = measure.compared.entry(output.name).or_default();
    *share = [share[0] + compared, share[1] + written];
}

/// A set of a kernel's inputs, and the kernel's equation. [`case!`](crate::case!) declares the type.
pub trait Parity: Deref<Target: Inputs> + Sized + 'static {
    /// Name of the kernel.
    const KERNEL: &'static str = <Self::Target as Inputs>::KERNEL;
    /// The least part of each output's written elements, over all sets, for which [`Parity::exact`] must know the value.
    ///
    /// If a case lowers it, a comment says why.
    const COMPARED: f64 = 0.9;

    /// The sets of inputs, each with a name.
    fn sets() -> Vec<(String, Self)>;

    /// Runs the kernel.
    ///
    /// # Errors
    /// Any error of the device.
    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        Ok(self.convert(runner.run(&self.kernel())?))
    }

    /// The outputs, in the form that the equation has.
    fn convert(&self, outputs: Vec<Output>) -> Vec<Output> {
        outputs
    }

    /// The equation, for an element of an output: its value, and the error allowed. `None` for an element that the kernel does
    /// not write, and [`Rounded::UNKNOWN`] where rounding decides the value. Integers must be equal.
    fn exact_at(&self, output: &str, index: usize) -> Option<Rounded> {
        let _ = (output, index);
        None
    }

    /// Like [`exact_at`](Self::exact_at), for all `len` elements of an output: for equations that compute them together.
    /// Missing elements at the end count as `None`.
    fn exact(&self, output: &str, len: usize) -> Vec<Option<Rounded>> {
        (0..len).map(|index| self.exact_at(output, index)).collect()
    }

    /// Like [`exact`](Self::exact), for drivers that regroup operations. Only kernels with numbers of two f32 need it: such
    /// drivers lose the second f32.
    fn exact_regrouped(&self, output: &str, len: usize) -> Vec<Option<Rounded>> {
        self.exact(output, len)
    }
}

/// Declares and registers a case: `case!(pub Square(SquareInputs))` is a struct around the inputs of its kernel.
///
/// A case may keep more values: `case!(pub Normals(NormalsInputs) { scene: Scene })` has the fields `inputs` and `scene`.
#[macro_export]
macro_rules! case {
    ($visibility:vis $case:ident($inputs:ty)) => {
        #[doc = concat!("A case around [`", stringify!($inputs), "`].")]
        #[derive(Clone)]
        $visibility struct $case($visibility $inputs);

        $crate::case!(@register $case, $inputs, 0);
    };
    ($visibility:vis $case:ident($inputs:ty) { $($(#[$doc:meta])* $of:vis $field:ident: $type:ty),+ $(,)? }) => {
        #[doc = concat!("A case around [`", stringify!($inputs), "`], and what they are made of.")]
        #[derive(Clone)]
        $visibility struct $case {
            inputs: $inputs,
            $($(#[$doc])* $of $field: $type,)+
        }

        $crate::case!(@register $case, $inputs, inputs);
    };
    (@register $case:ident, $inputs:ty, $field:tt) => {
        impl ::core::ops::Deref for $case {
            type Target = $inputs;

            fn deref(&self) -> &$inputs {
                &self.$field
            }
        }

        impl ::core::ops::DerefMut for $case {
            fn deref_mut(&mut self) -> &mut $inputs {
                &mut self.$field
            }
        }

        const _: () = {
            #[$crate::linkme::distributed_slice($crate::case::CASES)]
            #[linkme(crate = $crate::linkme)]
            static CASE: $crate::Case = $crate::Case::new::<$case>(::core::env!("CARGO_PKG_NAME"));
        };
    };
}

/// The rounding of a device.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Rounding {
    /// Operations run as written: SPIR-V is passed through, with its `NoContraction`.
    AsWritten,
    /// The driver may fuse and regroup operations: naga drops the decoration.
    Regrouped,
}
