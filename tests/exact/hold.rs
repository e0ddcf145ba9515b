//! Holds a kernel's CPU outputs to numbers that were computed otherwise.

use organza::Device;
use organza_check::{Bench, Bound, Canary, Measure, Output, Parity, Rounding, Values};
use organza_tests::devices;

/// Compares every set of a kernel's case on the CPU with `exact`, within the case's own tolerance.
///
/// `exact` gives an output's element: none where the equations say nothing of it.
pub fn hold<P: Parity>(exact: impl Fn(&P, &str, usize) -> Option<f64>) {
    hold_to(Rounding::AsWritten, exact);
}

/// As [`hold`], for a kernel whose own roundings add up.
pub fn hold_to<P: Parity>(rounding: Rounding, exact: impl Fn(&P, &str, usize) -> Option<f64>) {
    hold_all(rounding, |set: &P, output, len| {
        (0..len).map(|index| exact(set, output, index)).collect()
    });
}

/// The bound of what a kernel has to leave alone.
const NOTHING: Bound = Bound { scale: 0.0, floor: 0.0 };

/// What stands where a kernel has written nothing: two of them, where an output adds two rows.
fn canary(found: f64) -> f64 {
    let canary = f64::from(f32::CANARY);
    if found == 2.0 * canary { found } else { canary }
}

/// As [`hold_to`], all elements of an output at once; those that are not given are not compared.
pub fn hold_all<P: Parity>(
    rounding: Rounding,
    exact: impl Fn(&P, &str, usize) -> Vec<Option<f64>>,
) {
    for (instruction_set, cpu) in devices::cpus() {
        println!("{instruction_set}:");
        hold_all_on(&cpu, rounding, &exact);
    }
}

fn hold_all_on<P: Parity>(
    cpu: &Device,
    rounding: Rounding,
    exact: &impl Fn(&P, &str, usize) -> Vec<Option<f64>>,
) {
    let (mut measure, mut compared) = (Measure::default(), 0);
    for (name, set) in P::sets() {
        for output in set.run(&Bench::new(cpu, P::KERNEL)).expect("the kernel runs") {
            let found = output.to_f64();
            let mut expected = found.clone();
            let exact = exact(&set, output.name, found.len());
            for (index, (expected, exact)) in expected.iter_mut().zip(exact).enumerate() {
                compared += usize::from(exact.is_some());
                let is_float = matches!(output.values, Values::Float(_));
                let is_untouched = || is_float && set.bound(&output, index, rounding) == NOTHING;
                *expected = match exact {
                    Some(exact) => exact,
                    None if is_untouched() => canary(*expected),
                    None => *expected,
                };
            }
            let expected = Output { name: output.name, values: Values::Float(expected) };
            let found = Output { name: output.name, values: Values::Float(found) };
            measure.add(&name, &expected, &found, P::TOLERANCE, |index| match output.values {
                Values::Float(_) => set.bound(&expected, index, rounding),
                Values::Exact(_) => NOTHING,
            });
        }
    }
    let (kernel, share, ulp) = (P::KERNEL, &measure.share, measure.ulp.value);
    println!(
        "{kernel}: {compared} values, {:.0}% of what is allowed, {ulp:.1} ulp",
        share.value * 100.0
    );
    assert!(compared > 100, "{kernel}: only {compared} values were compared");
    assert!(measure.is_ok(), "{kernel}: {} failures, most {share:?}", measure.failures);
}
