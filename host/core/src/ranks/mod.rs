//! Ranks: processes, or threads of one process, that train or render one scene together.
//!
//! Ranks are numbered from 0. In a training run, each rank either holds the whole scene and computes its part of
//! every step, or it holds [a shard](crate::scene::SceneShard) of the Gaussians, as in rendering. Ranks communicate
//! through the calls of [`Ranks`]. All ranks make the same calls in the same order.

mod agreement;
mod group;
mod threads;

use std::fmt::Debug;

use crate::error::{Error, Result};

pub use agreement::check_agreement;
pub use group::Grid;
pub use threads::ThreadRanks;

/// Communication between ranks. Every call waits for all ranks.
pub trait Ranks: Debug + Send + Sync {
    /// Index of this rank, from 0.
    fn rank(&self) -> usize;

    /// Number of ranks.
    fn size(&self) -> usize;

    /// The maximum over all ranks, element by element.
    ///
    /// # Errors
    /// [`Error::Rank`] if another rank has failed. All calls have this error.
    fn max(&self, values: &mut [u32]) -> Result<()>;

    /// The bitwise or over all ranks, element by element.
    ///
    /// # Errors
    /// The same errors as [`Ranks::max`].
    fn or(&self, values: &mut [u32]) -> Result<()>;

    /// The sum over all ranks, element by element, with wraparound.
    ///
    /// # Errors
    /// The same errors as [`Ranks::max`].
    fn sum(&self, values: &mut [i64]) -> Result<()>;

    /// The bytes of every rank, in the order of the ranks.
    ///
    /// # Errors
    /// The same errors as [`Ranks::max`].
    fn gather(&self, mine: Vec<u8>) -> Result<Vec<Vec<u8>>>;

    /// Sends each rank its own bytes. Returns the bytes that each rank has sent to this one.
    ///
    /// # Errors
    /// The same errors as [`Ranks::max`].
    fn exchange(&self, for_each: Vec<Vec<u8>>) -> Result<Vec<Vec<u8>>>;

    /// The bytes of rank 0. Those of other ranks are ignored.
    ///
    /// # Errors
    /// The same errors as [`Ranks::max`].
    fn broadcast(&self, mine: Vec<u8>) -> Result<Vec<u8>>;

    /// Reports that this rank cannot go on. The other ranks end with this message.
    fn fail(&self, message: &str);

    /// Bytes that this rank has sent in all calls so far.
    fn sent(&self) -> u64;
}

/// The error of a rank that ends because another one has failed.
fn ended(rank: usize, message: &str) -> Error {
    Error::Rank { rank, message: message.to_owned() }
}
