//! `organza train` as a user meets it: what a run leaves, whatever happens to it.

mod bits;
mod endings;
mod eval;
mod faults;
mod folder;
mod hook;
mod hostile;
mod memory;
mod mistakes;
mod monstrous;
mod own_loss;
mod processes;
mod results;
pub mod runs;
mod settings;
mod signals;
mod waits;
