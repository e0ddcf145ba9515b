//! The kernels one by one: on every device, beside the CPU and the equations, as they are compiled and as they are
//! declared.

mod atomics;
mod compiled;
mod isa;
mod kernel_rules;
mod large;
mod parity;
mod timings;
mod variants;
