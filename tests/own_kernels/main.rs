//! Kernels that tests declare.  They enter the registry of the binary that they are in, so that this one looks at no
//! kernel of organza's.

mod cpu_execution;
mod guide;

// what `#[kernel]` writes, and what the guide's files look for in their crates
use organza::error;
use organza_kernels::{invocation, kernel, prelude};
