//! `organza train` as a user meets it: what a run leaves, whatever happens to it.

mod background;
mod bits;
mod endings;
mod eval;
mod exposure;
mod extend;
mod faults;
mod folder;
mod held_out;
mod hook;
mod hostile;
mod memory;
mod mistakes;
mod monstrous;
mod mpi;
mod own_loss;
pub mod processes;
mod progress;
mod ranks;
mod results;
pub mod runs;
mod settings;
mod signals;
mod split;
mod tables;
mod volume;
mod waits;
