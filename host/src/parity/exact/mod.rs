//! The equations in f64, a file for each stage: what [`Parity::exact`](super::Parity::exact) is made of.
//!
//! They are written from docs/pipeline.md and docs/conventions.md, over plain numbers, and share no code with the
//! kernels: no constant either.

pub mod numeric;
