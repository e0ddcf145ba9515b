//! `organza train` from a user's point of view: the files that a run leaves, however it ends.

mod bits;
#[cfg(target_os = "linux")]
mod data;
mod endings;
mod eval;
mod exposure;
mod extend;
mod faults;
mod folder;
mod hostile;
mod mistakes;
pub mod monstrous;
mod mpi;
mod own_loss;
mod placement;
mod poses;
pub mod processes;
mod ranks;
mod results;
pub mod runs;
mod settings;
mod signals;
mod transmittance;
