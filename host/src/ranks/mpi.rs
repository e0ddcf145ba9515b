//! Ranks that are MPI's processes.

use std::fmt;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};

use mpi::Threading;
use mpi::collective::SystemOperation;
use mpi::datatype::{Partition, PartitionMut};
use mpi::environment::Universe;
use mpi::topology::SimpleCommunicator;
use mpi::traits::{Communicator, CommunicatorCollectives, Equivalence, Root};

use super::Ranks;
use crate::error::{Error, Result};

/// Bytes of one call of MPI's, which counts in 31 bits.
const AT_ONCE: usize = 1 << 28;

/// A rank that is a process started by `mpirun`, `srun` or the like.
pub struct MpiRanks {
    rank: usize,
    size: usize,
    calls: Mutex<Calls>,
    sent: AtomicU64,
}

/// What calls of MPI's need. The communicator goes before MPI ends.
struct Calls {
    world: SimpleCommunicator,
    _universe: Universe,
}

// SAFETY: MPI was started so that any thread may call it while no other does, and calls are made under a lock
unsafe impl Send for Calls {}

impl fmt::Debug for MpiRanks {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "rank {} of MPI's {}", self.rank, self.size)
    }
}

impl MpiRanks {
    /// Starts MPI; a process can do so once. A process that nobody has started by MPI is the only rank.
    ///
    /// # Errors
    /// [`Error::Argument`] where MPI was started before, or where it does not let threads take turns.
    pub fn start() -> Result<Self> {
        let refuse = |reason: &str| Err(Error::Argument { reason: reason.to_owned() });
        let Some((universe, threading)) = mpi::initialize_with_threading(Threading::Serialized)
        else {
            return refuse("MPI was started before in this process");
        };
        if threading < Threading::Serialized {
            return refuse("this MPI allows calls of one thread alone");
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

/// Where each part begins.
fn begins(counts: &[i32]) -> Vec<i32> {
    let begin = |end: &mut i32, count: &i32| Some(std::mem::replace(end, *end + count));
    counts.iter().scan(0, begin).collect()
}

/// Cuts what all ranks have sent.
fn cut(all: &[u8], counts: &[i32]) -> Vec<Vec<u8>> {
    let parts = begins(counts).into_iter().zip(counts);
    parts.map(|(begin, &count)| all[begin as usize..(begin + count) as usize].to_vec()).collect()
}

/// The bytes of all parts; fails where MPI cannot count them.
fn total(parts: impl Iterator<Item = u64>) -> Result<usize> {
    let total: u64 = parts.sum();
    if total <= i32::MAX as u64 {
        return Ok(total as usize);
    }
    let reason = format!(
        "the messages of a step have {total} bytes, and MPI counts them in 31 bits: use fewer tiles in a step"
    );
    Err(Error::Argument { reason })
}

fn length(bytes: &[u8]) -> Result<i32> {
    total(std::iter::once(bytes.len() as u64)).map(|length| length as i32)
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
        let mut counts = vec![0_i32; self.size];
        calls.world.all_gather_into(&length(&mine)?, &mut counts[..]);
        let mut all = vec![0_u8; total(counts.iter().map(|&count| count as u64))?];
        {
            let mut parts = PartitionMut::new(&mut all[..], &counts[..], begins(&counts));
            calls.world.all_gather_varcount_into(&mine[..], &mut parts);
        }
        Ok(cut(&all, &counts))
    }

    fn exchange(&self, for_each: Vec<Vec<u8>>) -> Result<Vec<Vec<u8>>> {
        self.count(total(for_each.iter().map(|bytes| bytes.len() as u64))?);
        let counts: Vec<i32> = for_each.iter().map(|bytes| bytes.len() as i32).collect();
        let calls = self.calls();
        let mut received = vec![0_i32; self.size];
        calls.world.all_to_all_into(&counts[..], &mut received[..]);
        let mine = for_each.concat();
        let mut all = vec![0_u8; total(received.iter().map(|&count| count as u64))?];
        {
            let parts = Partition::new(&mine[..], &counts[..], begins(&counts));
            let mut others = PartitionMut::new(&mut all[..], &received[..], begins(&received));
            calls.world.all_to_all_varcount_into(&parts, &mut others);
        }
        Ok(cut(&all, &received))
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

    /// Says why, and ends all processes: the others may be waiting for this one.
    fn fail(&self, message: &str) {
        eprintln!("error: rank {}: {message}", self.rank);
        match self.calls.try_lock() {
            Ok(calls) => calls.world.abort(2),
            // another thread waits in a call; what started the processes ends them
            Err(_) => std::process::exit(2),
        }
    }

    fn sent(&self) -> u64 {
        self.sent.load(Ordering::Relaxed)
    }
}
