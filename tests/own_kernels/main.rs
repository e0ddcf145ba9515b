//! The guide's kernel. It enters the registry of the binary that it is in, so that this one looks at no kernel of organza's.
//! The CPU run is tested in `kit/check/tests/`.

mod guide;
