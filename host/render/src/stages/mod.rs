//! The stages from Gaussians to pixels, one file each: a stage's derivative is in its file.
//!
//! A stage allocates buffers, binds them to a kernel by name, and dispatches it with `Device::run_all`. How many invocations that are
//! follows from the kernel's declaration, `#[kernel(over(..))]`.

pub mod channels;
pub mod color;
pub mod composite;
pub mod counts;
pub mod cut;
pub mod field;
pub mod pairs;
pub mod project;
pub mod scan;
pub mod tiles;
pub mod transmittance;
