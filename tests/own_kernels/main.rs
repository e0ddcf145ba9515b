//! The guide's kernel. It is registered in this binary, so this binary must not check organza's own kernels. The
//! tests of the CPU run are in `kit/check/tests/`.

mod guide;
