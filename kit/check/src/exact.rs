//! Compares a device's outputs with the equations in f64.

use muslin_device::{Device, Result};

use super::measure::{Bound, Measure, Output, Values};
use super::parity::{Parity, Rounding};
use super::runner::Canary;
use super::runner::KernelRunner;

/// Runs all sets and compares them with [`Parity::exact`].
pub fn compare_with_exact<P: Parity>(device: &Device, rounding: Rounding) -> Result<Measure> {
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
