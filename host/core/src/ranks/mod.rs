//! Ranks: processes, or threads of one process, that train or render one scene together.
//!
//! A rank is one of them, numbered from 0. In a training, each holds the whole scene and computes its share of every step,
//! or each holds [a share](crate::scene::SceneShare) of the Gaussians, as for rendering. What they tell each other are the
//! calls of [`Ranks`]. All ranks make the same calls in the same order.

mod group;
mod meet;
#[cfg(feature = "mpi")]
mod mpi;
#[cfg(any(test, feature = "mpi"))]
mod rounds;
mod threads;

use std::fmt::Debug;

use crate::error::{Error, Result};

pub use group::Grid;
pub use meet::meet;
#[cfg(feature = "mpi")]
pub use mpi::MpiRanks;
pub use threads::ThreadRanks;

/// What ranks tell each other. Every call waits for all ranks.
pub trait Ranks: Debug + Send + Sync {
    /// This rank, from 0.
    fn rank(&self) -> usize;

    /// How many there are.
    fn size(&self) -> usize;

    /// The largest of all ranks' values, place by place.
    ///
    /// # Errors
    /// [`Error::Rank`] where another rank has failed; so do all calls.
    fn max(&self, values: &mut [u32]) -> Result<()>;

    /// The bits that any rank has set, place by place.
    ///
    /// # Errors
    /// As [`Ranks::max`].
    fn or(&self, values: &mut [u32]) -> Result<()>;

    /// The sum of all ranks' values, place by place. It wraps.
    ///
    /// # Errors
    /// As [`Ranks::max`].
    fn sum(&self, values: &mut [i64]) -> Result<()>;

    /// Every rank's bytes, in the order of the ranks.
    ///
    /// # Errors
    /// As [`Ranks::max`].
    fn gather(&self, mine: Vec<u8>) -> Result<Vec<Vec<u8>>>;

    /// Sends each rank its own bytes; returns what each rank has sent to this one.
    ///
    /// # Errors
    /// As [`Ranks::max`].
    fn exchange(&self, for_each: Vec<Vec<u8>>) -> Result<Vec<Vec<u8>>>;

    /// The bytes of rank 0; those of the others do not count.
    ///
    /// # Errors
    /// As [`Ranks::max`].
    fn broadcast(&self, mine: Vec<u8>) -> Result<Vec<u8>>;

    /// This rank cannot go on. The other ranks end, with this message.
    fn fail(&self, message: &str);

    /// Bytes that this rank has handed over to all of these calls.
    fn sent(&self) -> u64;
}

/// The error of a rank that ends because another one has failed.
fn ended(rank: usize, message: &str) -> Error {
    Error::Rank { rank, message: message.to_owned() }
}
