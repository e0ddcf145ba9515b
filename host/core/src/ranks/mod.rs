//! Ranks: processes, or threads of one process, that train one scene together.
//!
//! Ranks are numbered from 0. Each holds the whole scene, and computes some views of every step. Ranks communicate
//! through the calls of [`Ranks`]. All ranks make the same calls in the same order.

mod threads;

use std::fmt::Debug;

use crate::error::{Error, Result};
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

    /// The bytes of rank 0. Other ranks' bytes are ignored.
    ///
    /// # Errors
    /// The same errors as [`Ranks::max`].
    fn broadcast(&self, mine: Vec<u8>) -> Result<Vec<u8>>;

    /// Reports that this rank cannot go on. The other ranks end with this message.
    fn fail(&self, message: &str);
}

/// The error of a rank that ends because another one has failed.
fn ended(rank: usize, message: &str) -> Error {
    Error::Rank { rank, message: message.to_owned() }
}

/// Makes sure that all ranks compute the same bits from the same input: that they run the same version of the
/// program, on devices that round alike. `arithmetic` names the device's rounding, and `commit` the program's commit.
/// `input` names each input that the ranks have read, with a value that identifies it, such as a hash. `mixed` allows
/// different programs and devices.
///
/// # Errors
/// [`Error::Rank`], on every rank, for the first rank that differs from rank 0; the same errors as [`Ranks::max`].
pub fn check_agreement(
    ranks: &dyn Ranks,
    arithmetic: &str,
    commit: &str,
    (what, input): (&str, &str),
    mixed: bool,
) -> Result<()> {
    let program = format!("organza {} {commit}", env!("CARGO_PKG_VERSION"));
    let mine = [program.trim_end(), arithmetic, input].join("\n");
    let all = ranks.gather(mine.into_bytes())?;
    let parts = |bytes: &[u8]| -> Vec<String> {
        String::from_utf8_lossy(bytes).splitn(3, '\n').map(str::to_owned).collect()
    };
    let first = parts(&all[0]);
    for (rank, bytes) in all.iter().enumerate() {
        let found = parts(bytes);
        let differs = |part: usize| found.get(part) != first.get(part);
        let message = if differs(2) {
            format!("it has read other {what} than rank 0: give all ranks the same files")
        } else if !mixed && (differs(0) || differs(1)) {
            format!(
                "it is {} on {}, but rank 0 is {} on {}: the result would depend on which of them computes what; \
                 use the same program, device and `--instruction-set` everywhere, or allow it with `--mixed`",
                found[0], found[1], first[0], first[1]
            )
        } else {
            continue;
        };
        return Err(Error::Rank { rank, message });
    }
    Ok(())
}
