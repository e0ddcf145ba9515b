//! Each kernel alone: on every device, compared with the CPU and with the equations, in its compiled and in its
//! declared form.

mod compiled;
mod kernel_rules;
mod large;
mod parity;
mod variants;
