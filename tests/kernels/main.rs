//! Each kernel alone: on every device, compared with the CPU and with the equations, in its compiled and in its
//! declared form.

mod atomics;
mod compiled;
mod isa;
mod kernel_rules;
mod large;
mod memory;
mod parity;
mod timings;
mod variants;
