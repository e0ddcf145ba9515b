//! Ranks that are MPI processes.

use std::fmt;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};

use mpi::collective::SystemOperation;
use mpi::datatype::{Partition, PartitionMut};
use mpi::environment::Universe;
use mpi::topology::SimpleCommunicator;
use mpi::traits::{Communicator, CommunicatorCollectives, Equivalence, Root};
use mpi::{Count, Threading};

use super::Ranks;
use super::rounds::{part, receive};
use crate::{Error, Result};

/// Most bytes in one MPI call: MPI counts bytes in 31 bits.
const AT_ONCE: usize = 1 << 28;

/// A rank that is a process started by `mpirun`, `srun` or the like.
pub struct MpiRanks {
    rank: usize,
    size: usize,
    calls: Mutex<Calls>,
    sent: AtomicU64,
}

/// State that MPI calls need. The communicator must be freed before MPI ends.
struct Calls {
    world: SimpleCommunicator,
    _universe: Universe,
}

// SAFETY: MPI was started in a mode in which any thread may call it while no other does. A lock guards all calls.
unsafe impl Send for Calls {}

impl fmt::Debug for MpiRanks {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "rank {} of {} MPI processes", self.rank, self.size)
    }
}

impl MpiRanks {
    /// Starts MPI. A process can do so once. A process that MPI did not start is the only rank.
    ///
    /// # Errors
    /// [`Error::Argument`] if MPI was started before, or if it does not support calls from alternating threads.
    pub fn start() -> Result<Self> {
        let refuse = |reason: &str| Err(Error::Argument { reason: reason.to_owned() });
        let Some((universe, threading)) = mpi::initialize_with_threading(Threading::Serialized)
        else {
            return refuse("MPI was started before in this process");
        };
        if threading < Threading::Serialized {
            return refuse(
                "this MPI allows calls from one thread only; use one that was built with threads",
            );
        }
        let world = universe.world().duplicate();
        let [rank, size] = [world.rank(), world.size()].map(|number| number as usize);
        let calls = Mutex::new(Calls { world, _universe: universe });
        Ok(Self { rank, size, calls, sent: 0.into() })
    }

    fn calls(&self) -> MutexGuard<'_, Calls> {
        self.calls.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn count(&self, bytes: usize) {
        self.sent.fetch_add(bytes as u64, Ordering::Relaxed);
    }

    /// Most bytes per rank in one round.
    fn max_bytes(&self) -> usize {
        (AT_ONCE / self.size).max(1)
    }

    fn reduce<T: Equivalence + Copy>(
        &self,
        values: &mut [T],
        operation: impl Fn() -> SystemOperation,
    ) {
        self.count(size_of_val(values));
        let calls = self.calls();
        for values in values.chunks_mut(AT_ONCE / size_of::<T>()) {
            let mine = values.to_vec();
            calls.world.all_reduce_into(&mine[..], values, operation());
        }
    }
}

/// The same bytes at a valid address. An empty vector has the address 1, which Open MPI takes for `MPI_IN_PLACE`.
fn addressed(bytes: &[u8]) -> &[u8] {
    static NOTHING: [u8; 1] = [0];
    if bytes.is_empty() { &NOTHING[..0] } else { bytes }
}

/// The number of bytes of each part, and its offset.
fn layout(counts: &[usize]) -> (Vec<Count>, Vec<Count>) {
    let counts: Vec<_> = counts.iter().map(|&count| count as Count).collect();
    let begin = |end: &mut Count, count: &Count| Some(std::mem::replace(end, *end + count));
    let begins = counts.iter().scan(0, begin).collect();
    (counts, begins)
}

/// A buffer for all parts that is never empty: see [`addressed`].
fn room(counts: &[usize]) -> Vec<u8> {
    vec![0; counts.iter().sum::<usize>().max(1)]
}

impl Ranks for MpiRanks {
    fn rank(&self) -> usize {
        self.rank
    }

    fn size(&self) -> usize {
        self.size
    }

    fn max(&self, values: &mut [u32]) -> Result<()> {
        self.reduce(values, SystemOperation::max);
        Ok(())
    }

    fn or(&self, values: &mut [u32]) -> Result<()> {
        self.reduce(values, SystemOperation::bitwise_or);
        Ok(())
    }

    fn sum(&self, values: &mut [i64]) -> Result<()> {
        self.reduce(values, SystemOperation::sum);
        Ok(())
    }

    fn gather(&self, mine: Vec<u8>) -> Result<Vec<Vec<u8>>> {
        self.count(mine.len());
        let calls = self.calls();
        let max_bytes = self.max_bytes();
        let mut lengths = vec![0_u64; self.size];
        calls.world.all_gather_into(&(mine.len() as u64), &mut lengths[..]);
        let lengths: Vec<_> = lengths.iter().map(|&length| length as usize).collect();
        let longest = lengths.iter().copied().max().unwrap_or(0);
        receive(&lengths, longest, max_bytes, |begin, counts| {
            let mine = addressed(part(&mine, begin, max_bytes));
            let mut all = room(counts);
            let (counts, begins) = layout(counts);
            let mut parts = PartitionMut::new(&mut all[..], &counts[..], &begins[..]);
            calls.world.all_gather_varcount_into(mine, &mut parts);
            Ok(all)
        })
    }

    fn exchange(&self, for_each: Vec<Vec<u8>>) -> Result<Vec<Vec<u8>>> {
        self.count(for_each.iter().map(Vec::len).sum());
        let calls = self.calls();
        let max_bytes = self.max_bytes();
        let sent: Vec<_> = for_each.iter().map(|bytes| bytes.len() as u64).collect();
        let mut lengths = vec![0_u64; self.size];
        calls.world.all_to_all_into(&sent[..], &mut lengths[..]);
        let mut longest = 0_u64;
        let mine = lengths.iter().copied().max().unwrap_or(0);
        calls.world.all_reduce_into(&mine, &mut longest, SystemOperation::max());
        let lengths: Vec<_> = lengths.iter().map(|&length| length as usize).collect();
        receive(&lengths, longest as usize, max_bytes, |begin, counts| {
            let parts: Vec<_> =
                for_each.iter().map(|bytes| part(bytes, begin, max_bytes)).collect();
            let mine = parts.concat();
            let (sent, sent_begins) =
                layout(&parts.iter().map(|part| part.len()).collect::<Vec<_>>());
            let mine = Partition::new(addressed(&mine), &sent[..], &sent_begins[..]);
            let mut all = room(counts);
            let (counts, begins) = layout(counts);
            let mut others = PartitionMut::new(&mut all[..], &counts[..], &begins[..]);
            calls.world.all_to_all_varcount_into(&mine, &mut others);
            Ok(all)
        })
    }

    fn broadcast(&self, mine: Vec<u8>) -> Result<Vec<u8>> {
        let mut bytes = if self.rank == 0 { mine } else { Vec::new() };
        self.count(bytes.len());
        let calls = self.calls();
        let root = calls.world.process_at_rank(0);
        let mut length = bytes.len() as u64;
        root.broadcast_into(&mut length);
        bytes.resize(length as usize, 0);
        for bytes in bytes.chunks_mut(AT_ONCE) {
            root.broadcast_into(bytes);
        }
        Ok(bytes)
    }

    /// Prints the message and ends all processes, which may be waiting for this one.
    fn fail(&self, message: &str) {
        match message.starts_with("rank ") {
            true => eprintln!("error: {message}"),
            false => eprintln!("error: rank {}: {message}", self.rank),
        }
        match self.calls.try_lock() {
            Ok(calls) => calls.world.abort(2),
            // another thread is waiting in a call; the launcher ends the other processes
            Err(_) => std::process::exit(2),
        }
    }

    fn sent(&self) -> u64 {
        self.sent.load(Ordering::Relaxed)
    }
}

/// A rank that has panicked ends all processes, which would wait for it forever.
impl Drop for MpiRanks {
    fn drop(&mut self) {
        if std::thread::panicking() {
            self.fail("it has panicked");
        }
    }
}
