//! Ranks that are threads of one process.

use std::sync::Arc;

use parking_lot::{Condvar, Mutex};

use super::{Ranks, ended};
use crate::error::Result;

/// The bytes that a rank sends. Every rank can read the bytes of all others.
type Message = Arc<Vec<Vec<u8>>>;

/// A rank that is a thread. Give each thread one of [`ThreadRanks::new`].
///
/// ```
/// use organza_core::ranks::{Ranks, ThreadRanks};
///
/// let sums = ThreadRanks::run(3, |ranks| {
///     let mut values = [1_i64 << ranks.rank()];
///     ranks.sum(&mut values)?;
///     Ok::<_, organza_core::Error>(values)
/// });
/// for sum in sums {
///     assert_eq!(sum?, [7]);
/// }
/// # Ok::<(), organza_core::Error>(())
/// ```
#[derive(Debug)]
pub struct ThreadRanks {
    rank: usize,
    shared: Arc<Shared>,
}

#[derive(Debug)]
struct Shared {
    size: usize,
    state: Mutex<CallState>,
    changed: Condvar,
}

#[derive(Debug, Default)]
struct CallState {
    /// Number of calls that all ranks have completed.
    calls: u64,
    /// Messages of the ranks that have joined the current call.
    messages: Vec<Option<Message>>,
    /// Messages of the last call. The next call cannot end before every rank has read them.
    last: Vec<Message>,
    /// The first rank that has failed, and why.
    failed: Option<(usize, String)>,
}

impl ThreadRanks {
    /// All ranks, in order.
    ///
    /// # Panics
    /// If `size` is 0.
    pub fn new(size: usize) -> Vec<Self> {
        assert!(size > 0, "no rank");
        let state = CallState { messages: vec![None; size], ..CallState::default() };
        let shared = Arc::new(Shared { size, state: state.into(), changed: Condvar::new() });
        let rank = |rank| Self { rank, shared: shared.clone() };
        (0..size).map(rank).collect()
    }

    /// Does the work of each rank in a thread, and returns what they found, in order.
    ///
    /// # Panics
    /// If `size` is 0, or if the work of a rank panics.
    pub fn run<R: Send>(size: usize, work: impl Fn(Self) -> R + Sync) -> Vec<R> {
        let work = &work;
        std::thread::scope(|scope| {
            let ranks = Self::new(size).into_iter();
            let threads: Vec<_> = ranks.map(|ranks| scope.spawn(move || work(ranks))).collect();
            threads.into_iter().map(|thread| thread.join().expect("a rank")).collect()
        })
    }

    /// A rank without others.
    pub fn alone() -> Self {
        Self::new(1).swap_remove(0)
    }

    /// Sends a message to all ranks, and waits for theirs.
    fn all(&self, mine: Vec<Vec<u8>>) -> Result<Vec<Message>> {
        let mut state = self.shared.state.lock();
        let call = state.calls;
        state.messages[self.rank] = Some(Arc::new(mine));
        if state.messages.iter().all(Option::is_some) {
            state.last = state.messages.iter_mut().filter_map(Option::take).collect();
            state.calls += 1;
            self.shared.changed.notify_all();
        }
        while state.calls == call {
            if let Some((rank, message)) = &state.failed {
                return Err(ended(*rank, message));
            }
            self.shared.changed.wait(&mut state);
        }
        Ok(state.last.clone())
    }

    /// Combines the values of all ranks, element by element, in the order of the ranks.
    fn reduce<T: bytemuck::Pod>(
        &self,
        values: &mut [T],
        combine: impl Fn(T, T) -> T,
    ) -> Result<()> {
        let all = self.all(vec![bytemuck::cast_slice(values).to_vec()])?;
        for (rank, message) in all.iter().enumerate() {
            let other: Vec<T> = bytemuck::pod_collect_to_vec(&message[0]);
            assert_eq!(other.len(), values.len(), "all ranks make the same call");
            match rank {
                0 => values.copy_from_slice(&other),
                _ => values
                    .iter_mut()
                    .zip(other)
                    .for_each(|(sum, value)| *sum = combine(*sum, value)),
            }
        }
        Ok(())
    }
}

impl Ranks for ThreadRanks {
    fn rank(&self) -> usize {
        self.rank
    }

    fn size(&self) -> usize {
        self.shared.size
    }

    fn max(&self, values: &mut [u32]) -> Result<()> {
        self.reduce(values, u32::max)
    }

    fn or(&self, values: &mut [u32]) -> Result<()> {
        self.reduce(values, |a, b| a | b)
    }

    fn sum(&self, values: &mut [i64]) -> Result<()> {
        self.reduce(values, i64::wrapping_add)
    }

    fn gather(&self, mine: Vec<u8>) -> Result<Vec<Vec<u8>>> {
        Ok(self.all(vec![mine])?.iter().map(|message| message[0].clone()).collect())
    }

    fn exchange(&self, for_each: Vec<Vec<u8>>) -> Result<Vec<Vec<u8>>> {
        assert_eq!(for_each.len(), self.size(), "something for every rank");
        Ok(self.all(for_each)?.iter().map(|message| message[self.rank].clone()).collect())
    }

    fn broadcast(&self, mine: Vec<u8>) -> Result<Vec<u8>> {
        let mine = if self.rank == 0 { mine } else { Vec::new() };
        Ok(self.all(vec![mine])?[0][0].clone())
    }

    fn fail(&self, message: &str) {
        let mut state = self.shared.state.lock();
        state.failed.get_or_insert_with(|| (self.rank, message.to_owned()));
        self.shared.changed.notify_all();
    }
}

/// A rank that ends counts as failed, even after a panic, so that no other rank waits for it.
impl Drop for ThreadRanks {
    fn drop(&mut self) {
        self.fail("it has ended");
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::Error;

    #[test]
    fn a_rank_that_fails_ends_the_others() {
        let found = ThreadRanks::run(3, |ranks| match ranks.rank() {
            1 => {
                ranks.fail("no memory");
                String::new()
            }
            _ => match ranks.sum(&mut [1]) {
                Err(error @ Error::Rank { rank: 1, .. }) => error.to_string(),
                other => panic!("{other:?}"),
            },
        });
        assert!(found[0] == found[2] && found[0].contains("rank 1: no memory"), "{found:?}");
    }
}
