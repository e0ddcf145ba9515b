//! Kernels that test the kernel language: each device must give the CPU's values, where core computes them.
#![no_std]
// the shader compiler cannot compile what clippy suggests instead
#![allow(clippy::implicit_saturating_sub, clippy::manual_range_contains, clippy::manual_clamp)]

pub mod atomics;
pub mod core_functions;
pub mod elementary;
pub mod integers;
pub mod language;
pub mod loops;
pub mod vectors;

/// Parameters of a kernel over a number of items.
#[muslin::prelude::params]
pub struct CountParams {
    /// Items: values, pairs or rows.
    pub count: u32,
}

/// Writes values to one element of each row of an output.
macro_rules! rows {
    ($output:ident [$count:expr] at $index:expr; $($value:expr,)*) => {
        let mut at = $index;
        $(
            $output.write(at, $value);
            at += $count;
        )*
        let _ = at;
    };
}
pub(crate) use rows;
