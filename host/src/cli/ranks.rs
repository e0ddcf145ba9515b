//! Options of commands that ranks share, and the work of ranks other than the first.

use std::str::FromStr;
use std::sync::Arc;
use std::thread;

use organza::data::DatasetOptions;
use organza::ranks::{Ranks, ThreadRanks};
use organza::scene::Placement;
use organza::train::{self, TrainConfig};
use organza::{Dataset, DeviceOptions, Error, Renderer, Result, error};

use super::console::Console;
use super::device::DeviceArgs;
use super::inputs::DataSet;
use super::signals::Signals;

/// Options of a training that ranks share.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Ranks")]
pub struct RanksArgs {
    /// Share the training among N threads, each with its own device; or `mpi`: among the processes that mpirun or
    /// srun has started. The result has the same bits with any number of ranks, and without this option
    /// (docs/cluster.md)
    #[arg(long, value_name = "N|mpi")]
    ranks: Option<Launch>,
    /// Allow ranks with different programs or devices; the scene's bits then depend on which rank computes what
    #[arg(long, requires = "ranks")]
    mixed: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Launch {
    Threads(usize),
    Mpi,
}

/// Largest number of threads. More are a mistake: each holds the whole scene.
const MAX_THREADS: usize = 64;

impl FromStr for Launch {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.parse() {
            _ if text == "mpi" => Ok(Self::Mpi),
            Ok(threads) if (1..=MAX_THREADS).contains(&threads) => Ok(Self::Threads(threads)),
            _ => Err(format!("expected a number of threads, 1 to {MAX_THREADS}, or `mpi`")),
        }
    }
}

impl RanksArgs {
    /// Starts the ranks; `None` without `--ranks`.
    pub fn start(&self) -> Result<Option<RankGroup>> {
        self.ranks.map(|kind| RankGroup::start(kind, self.mixed)).transpose()
    }
}

#[cfg(feature = "mpi")]
fn start_mpi() -> Result<Arc<dyn Ranks>> {
    Ok(Arc::new(organza::ranks::MpiRanks::start()?))
}

#[cfg(not(feature = "mpi"))]
fn start_mpi() -> Result<Arc<dyn Ranks>> {
    super::refuse(
        "this program was built without MPI; build it with `cargo build --release --features mpi`",
    )
}

/// The ranks, from the point of view of one of them.
#[derive(Debug)]
pub struct RankGroup {
    /// The rank of this process, or of its first thread.
    pub mine: Arc<dyn Ranks>,
    /// The ranks of the other threads.
    pub others: Vec<ThreadRanks>,
    pub mixed: bool,
    pub is_mpi: bool,
}

impl RankGroup {
    fn start(kind: Launch, mixed: bool) -> Result<Self> {
        match kind {
            Launch::Threads(size) => {
                let mut ranks = ThreadRanks::new(size).into_iter();
                let mine = Arc::new(ranks.next().expect("one at least"));
                Ok(Self::new(mine, ranks.collect(), mixed))
            }
            Launch::Mpi => Ok(Self { is_mpi: true, ..Self::new(start_mpi()?, Vec::new(), mixed) }),
        }
    }

    fn new(mine: Arc<dyn Ranks>, others: Vec<ThreadRanks>, mixed: bool) -> Self {
        Self { mine, others, mixed, is_mpi: false }
    }

    /// Sends rank 0's settings, and the placement of a resumed scene, to the other ranks, which cannot read them while rank 0 writes the file.
    pub fn tell(&self, config: &TrainConfig, placement: Option<Placement>) -> Result<()> {
        if self.is_mpi {
            self.mine.broadcast(config.to_toml().into_bytes())?;
            self.mine.broadcast(serde_json::to_vec(&placement).expect("numbers"))?;
        }
        Ok(())
    }

    /// The device of a rank: threads share the cores, and ranks on one machine share its GPUs.
    pub fn device(&self, options: DeviceOptions, rank: usize) -> DeviceOptions {
        if self.is_mpi {
            return options.place(variable(&LOCAL_RANK).unwrap_or(rank));
        }
        let cores = thread::available_parallelism().map_or(1, usize::from);
        let threads = options.threads.unwrap_or((cores / self.mine.size()).max(1));
        options.threads(threads).place(rank)
    }

    /// The work of an MPI process other than the first: it reads the photographs and follows rank 0.
    pub fn follow_process(&self, device: &DeviceArgs) -> Result<()> {
        let ranks = &self.mine;
        let follow = || {
            // rank 0 acts on the first signal
            let signals = Signals::listen()?;
            signals.keeps_results();
            let text = String::from_utf8_lossy(&ranks.broadcast(Vec::new())?).into_owned();
            let config = TrainConfig::parse(&text, "the settings of rank 0".as_ref())?;
            let placement: Option<Placement> =
                serde_json::from_slice(&ranks.broadcast(Vec::new())?).expect("rank 0 wrote it");
            let console = Console::QUIET;
            let options = DatasetOptions { placement, ..config.data.options() };
            let data = DataSet::open(config.data, &options, console)?;
            let options = self.device(device.options()?, ranks.rank());
            let renderer = device.open_as(&options, console)?;
            let dataset = Arc::new(data.read(&renderer, console)?);
            train::follow(&renderer, &dataset, ranks, self.mixed, None)
        };
        follow().inspect_err(|error| ranks.fail(&error::chain(error)))
    }
}

/// The work of a thread other than the first rank.
pub fn follow_thread(
    ranks: ThreadRanks,
    options: &DeviceOptions,
    dataset: &Arc<Dataset>,
    mixed: bool,
) {
    let ranks: Arc<dyn Ranks> = Arc::new(ranks);
    let follow = || {
        train::follow(&Renderer::new(organza::open_device(options)?), dataset, &ranks, mixed, None)
    };
    if let Err(error) = follow() {
        ranks.fail(&error::chain(&error));
    }
}

/// The number of this process among the processes on its machine: Open MPI's, Slurm's, MPICH's, Intel MPI's.
const LOCAL_RANK: [&str; 4] =
    ["OMPI_COMM_WORLD_LOCAL_RANK", "SLURM_LOCALID", "MPI_LOCALRANKID", "PMI_LOCAL_RANK"];

/// The error of a training that found another one in its folder. Where MPI has started several processes, it names the option
/// that joins them.
pub fn of_many(error: Error) -> Error {
    let size = variable(&["OMPI_COMM_WORLD_SIZE", "SLURM_STEP_NUM_TASKS", "PMI_SIZE"]);
    match error {
        Error::Invalid { origin, reason } if size.is_some_and(|size| size > 1) => {
            let reason = format!("{reason}. With `--ranks mpi`, the processes share one training");
            Error::Invalid { origin, reason }
        }
        error => error,
    }
}

/// The number in the first of these environment variables that has one.
fn variable(names: &[&str]) -> Option<usize> {
    names.iter().find_map(|name| std::env::var(name).ok()?.parse().ok())
}
