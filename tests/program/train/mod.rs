//! `organza train` as a user meets it: what a run leaves, whatever happens to it.

mod bits;
mod endings;
mod eval;
mod hook;
mod memory;
mod mistakes;
mod results;
mod runs;
mod settings;
mod waits;
