//! Kernels that tests declare.  They enter the registry of the binary that they are in, so that this one looks at no
//! kernel of organza's.

mod cpu_execution;
mod guide;
