//! Ranks that are MPI processes.

use std::fmt;
use std::sync::{Mutex, MutexGuard, PoisonError};

use mpi::collective::SystemOperation;
use mpi::datatype::{Partition, PartitionMut};
use mpi::environment::Universe;
use mpi::topology::SimpleCommunicator;
use mpi::traits::{Communicator, CommunicatorCollectives, Equivalence, Root};
use mpi::{Count, Threading};

use super::Ranks;
use crate::Result;
use crate::error::argument;

/// Most values in one MPI call that can be made several times: MPI counts in 31 bits.
const AT_ONCE: usize = 1 << 28;
/// Bytes of a word. Messages of any length are sent as words, so that 31 bits count 16 GiB.
const WORD: usize = size_of::<u64>();

/// A rank that is a process started by `mpirun`, `srun` or the like.
pub struct MpiRanks {
    rank: usize,
    size: usize,
    calls: Mutex<Calls>,
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
    /// [`Error::Argument`](crate::Error::Argument) if MPI was started before, or if it does not support calls from
    /// alternating threads.
    pub fn start() -> Result<Self> {
        let Some((universe, threading)) = mpi::initialize_with_threading(Threading::Serialized)
        else {
            return argument("MPI was started before in this process");
        };
        if threading < Threading::Serialized {
            return argument(
                "this MPI allows calls from one thread only; use one that was built with threads",
            );
        }
        let world = universe.world().duplicate();
        let [rank, size] = [world.rank(), world.size()].map(|number| number as usize);
        let calls = Mutex::new(Calls { world, _universe: universe });
        Ok(Self { rank, size, calls })
    }

    fn calls(&self) -> MutexGuard<'_, Calls> {
        self.calls.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn reduce<T: Equivalence + Copy>(
        &self,
        values: &mut [T],
        operation: impl Fn() -> SystemOperation,
    ) {
        let calls = self.calls();
        for values in values.chunks_mut(AT_ONCE) {
            let mine = values.to_vec();
            calls.world.all_reduce_into(&mine[..], values, operation());
        }
    }
}

/// Messages one after another, each filled up with zeros to whole words.
fn words(messages: &[Vec<u8>]) -> Vec<u64> {
    let padded = messages.iter().flat_map(|bytes| {
        let mut bytes = bytes.clone();
        bytes.resize(bytes.len().next_multiple_of(WORD), 0);
        bytemuck::pod_collect_to_vec::<u8, u64>(&bytes)
    });
    padded.collect()
}

/// The words of messages of these lengths in bytes: how many each has, and where it begins.
fn layout(lengths: &[u64]) -> Result<(Vec<Count>, Vec<Count>)> {
    let counts: Vec<_> = lengths.iter().map(|length| length.div_ceil(WORD as u64)).collect();
    if counts.iter().sum::<u64>() > Count::MAX as u64 {
        return argument("ranks cannot send one another more than 16 GiB at once");
    }
    let counts: Vec<_> = counts.into_iter().map(|count| count as Count).collect();
    let begin = |end: &mut Count, count: &Count| Some(std::mem::replace(end, *end + count));
    let begins = counts.iter().scan(0, begin).collect();
    Ok((counts, begins))
}

/// Receives messages of these lengths in bytes, of which `call` gets all words at once.
fn receive(
    lengths: &[u64],
    call: impl FnOnce(&mut PartitionMut<'_, [u64], &[Count], &[Count]>),
) -> Result<Vec<Vec<u8>>> {
    let (counts, begins) = layout(lengths)?;
    let mut all = vec![0_u64; counts.iter().sum::<Count>() as usize];
    call(&mut PartitionMut::new(&mut all[..], &counts[..], &begins[..]));
    let message = |(begin, length): (&Count, &u64)| {
        bytemuck::cast_slice(&all[*begin as usize..])[..*length as usize].to_vec()
    };
    Ok(begins.iter().zip(lengths).map(message).collect())
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
        let world = &self.calls().world;
        let mut lengths = vec![0_u64; self.size];
        world.all_gather_into(&(mine.len() as u64), &mut lengths[..]);
        let mine = words(&[mine]);
        receive(&lengths, |all| world.all_gather_varcount_into(&mine[..], all))
    }

    fn exchange(&self, for_each: Vec<Vec<u8>>) -> Result<Vec<Vec<u8>>> {
        let world = &self.calls().world;
        let sent: Vec<_> = for_each.iter().map(|bytes| bytes.len() as u64).collect();
        let mut lengths = vec![0_u64; self.size];
        world.all_to_all_into(&sent[..], &mut lengths[..]);
        let (counts, begins) = layout(&sent)?;
        let mine = words(&for_each);
        let mine = Partition::new(&mine[..], &counts[..], &begins[..]);
        receive(&lengths, |all| world.all_to_all_varcount_into(&mine, all))
    }

    fn broadcast(&self, mine: Vec<u8>) -> Result<Vec<u8>> {
        let mut bytes = if self.rank == 0 { mine } else { Vec::new() };
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
}

/// A rank that has panicked ends all processes, which would wait for it forever.
impl Drop for MpiRanks {
    fn drop(&mut self) {
        if std::thread::panicking() {
            self.fail("it has panicked");
        }
    }
}
