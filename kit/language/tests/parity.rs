//! The kernels of the language on every device, beside the CPU and the equations.

use muslin_language::{MODULES, cases};

#[test]
fn the_language_is_right_on_every_device() {
    muslin_check::assert_parity(&cases(), &MODULES);
}
