//! Leads a debugger to the invocation that has written a wrong element.

use std::env;

use muslin_device::InstructionSet;
use muslin_kernel::running::stop_at;

use crate::case::Case;
use crate::devices;
use crate::measure::Worst;

/// A kernel, an invocation and a set of inputs.
const STOP: &str = "MUSLIN_STOP";

/// The command that stops in the invocation that has written an element, if the CPU run knows it.
pub fn command(case: &Case, worst: &Worst) -> Option<String> {
    let device = devices::checked();
    device.watch(worst.output, worst.index);
    case.run(&device, &worst.set).ok()?;
    let [x, y, z] = device.writer()?;
    let kernel = case.kernel;
    let set = &worst.set;
    let program = env::current_exe().ok()?;
    let test = std::thread::current().name().unwrap_or_default().to_owned();
    Some(format!(
        "  its invocation [{x}, {y}, {z}] in a debugger: {STOP}='{kernel} {x} {y} {z} {set}' rust-gdb -ex 'break muslin_stop' \
         -ex run -ex 'up 2' --args {} {test}",
        program.display()
    ))
}

/// If a [`command`] has started this test, runs what it names, and nothing else.
pub fn answer(cases: &[Case]) -> bool {
    let Ok(stop) = env::var(STOP) else { return false };
    let parts: Vec<_> = stop.splitn(5, ' ').collect();
    let [kernel, invocation @ .., set] = &parts[..] else { panic!("{STOP}='{stop}'") };
    let place = |axis: usize| invocation.get(axis).and_then(|place| place.parse().ok());
    stop_at([0, 1, 2].map(|axis| place(axis).unwrap_or_else(|| panic!("{STOP}='{stop}'"))));
    let device = devices::with(InstructionSet::Scalar);
    for case in cases.iter().filter(|case| case.kernel == *kernel) {
        case.run(&device, set).unwrap_or_else(|error| panic!("{error}"));
    }
    true
}
