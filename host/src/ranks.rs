//! Ranks: processes, or threads of one process, that train or render one scene together. See [`organza_core::ranks`].

#[cfg(feature = "mpi")]
mod mpi;

#[cfg(feature = "mpi")]
pub use mpi::MpiRanks;
pub use organza_core::ranks::*;
