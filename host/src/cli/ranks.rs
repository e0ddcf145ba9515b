//! Options of commands that ranks share, and the work of ranks other than the first.

use std::path::Path;
use std::str::FromStr;
use std::sync::Arc;
use std::thread;

use organza::ranks::{Ranks, ThreadRanks, check_agreement};
use organza::scene::{Placement, SceneShard};
use organza::train::{self, TrainConfig};
use organza::{Dataset, DeviceOptions, DeviceShard, Renderer, Result, UploadOptions, error};

use super::console::{Console, Level};
use super::device::DeviceArgs;
use super::inputs::{DataSet, Expected, told_apart};
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
    /// The work that ranks share. `views`: each rank holds the whole scene. `gaussians`: each rank holds some of the
    /// Gaussians, for scenes that do not fit on one device. The scene's bits depend on this [default: views]
    #[arg(long, value_name = "WHAT", requires = "ranks")]
    split: Option<Split>,
    /// With `--split gaussians`: form groups of N ranks. The ranks of a group share the Gaussians, and the groups share
    /// the views. N must divide the number of ranks. The scene's bits do not depend on it [default: one group of all
    /// ranks]
    #[arg(long, value_name = "N", requires = "split")]
    shards: Option<usize>,
    /// Allow ranks with different programs or devices; the scene's bits then depend on which rank computes what
    #[arg(long, requires = "ranks")]
    mixed: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Split {
    Views,
    Gaussians,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Launch {
    Threads(usize),
    Mpi,
}

/// Largest number of threads. More are a mistake: each holds the whole scene.
const MOST_THREADS: usize = 64;

impl FromStr for Launch {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.parse() {
            _ if text == "mpi" => Ok(Self::Mpi),
            Ok(threads) if (1..=MOST_THREADS).contains(&threads) => Ok(Self::Threads(threads)),
            _ => Err(format!("expected a number of threads, 1 to {MOST_THREADS}, or `mpi`")),
        }
    }
}

impl RanksArgs {
    /// Starts the ranks; `None` without `--ranks`.
    pub fn start(&self) -> Result<Option<Team>> {
        let is_split = self.split == Some(Split::Gaussians);
        if !is_split && self.shards.is_some() {
            return super::refuse("`--shards` is for `--split gaussians`");
        }
        let team = self.ranks.map(|kind| Team::start(kind, self.mixed)).transpose()?;
        Ok(team.map(|team| {
            let shards = is_split.then(|| self.shards.unwrap_or(team.mine.size()));
            Team { shards, ..team }
        }))
    }
}

/// Options of rendering with Gaussians that are distributed over ranks.
#[derive(Debug, clap::Args)]
pub struct SharesArgs {
    /// Distribute the Gaussians over N threads, each with its own device; or `mpi`: over the processes that mpirun or
    /// srun has started. For scenes that do not fit on one device. Any number of ranks gives the same bits
    /// (docs/cluster.md)
    #[arg(long, value_name = "N|mpi", help_heading = "Ranks")]
    ranks: Option<Launch>,
    /// Allow ranks with different programs or devices; the image's bits then depend on which rank computes what
    #[arg(long, requires = "ranks", help_heading = "Ranks")]
    mixed: bool,
}

impl SharesArgs {
    /// Starts the ranks; `None` without `--ranks`.
    pub fn start(&self) -> Result<Option<Team>> {
        self.ranks.map(|kind| Team::start(kind, self.mixed)).transpose()
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
pub struct Team {
    /// The rank of this process, or of its first thread.
    pub mine: Arc<dyn Ranks>,
    /// The ranks of the other threads.
    pub others: Vec<ThreadRanks>,
    pub mixed: bool,
    /// Number of shards of the Gaussians in a training; none where each rank has the whole scene.
    pub shards: Option<usize>,
    pub is_mpi: bool,
}

impl Team {
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
        Self { mine, others, mixed, shards: None, is_mpi: false }
    }

    /// Runs `lead` on rank 0 and `follow` on the others. A failure of one rank ends all.
    pub fn run(
        self,
        lead: impl FnOnce(Member<'_>) -> Result<()>,
        follow: impl Fn(Member<'_>) -> Result<()> + Sync,
    ) -> Result<()> {
        let places = self.places();
        let Self { mine, others, mixed, is_mpi, .. } = self;
        thread::scope(|scope| {
            for ranks in others {
                let follow = &follow;
                scope.spawn(move || {
                    let result = follow(Member { ranks: &ranks, places, mixed });
                    let _ = result.inspect_err(|error| ranks.fail(&error::chain(error)));
                });
            }
            let member = Member { ranks: &*mine, places, mixed };
            let result = if mine.rank() == 0 { lead(member) } else { follow(member) };
            if is_mpi && let Err(error) = &result {
                mine.fail(&error::chain(error));
            }
            // before the threads are joined: they end when rank 0 is gone
            drop(mine);
            result
        })
    }

    /// Sends rank 0's settings, and the placement of a resumed scene, to the other ranks, which cannot read them while rank 0 writes the file.
    pub fn tell(&self, config: &TrainConfig, placement: Option<Placement>) -> Result<()> {
        if self.is_mpi {
            self.mine.broadcast(config.to_toml().into_bytes())?;
            self.mine.broadcast(serde_json::to_vec(&placement).expect("numbers"))?;
        }
        Ok(())
    }

    /// The way in which ranks choose their devices.
    pub fn places(&self) -> Places {
        Places { is_mpi: self.is_mpi, size: self.mine.size() }
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
            let console = Console::new(Level::Quiet);
            let data = DataSet::open(config.data, placement, console)?;
            let options = self.places().device(device.options()?, ranks.rank());
            let renderer = device.open_as(&options, console)?;
            let dataset = Arc::new(data.read(&renderer, console)?);
            train::follow(&renderer, &dataset, ranks, self.mixed)
        };
        follow().inspect_err(|error| ranks.fail(&error::chain(error)))
    }
}

/// The way in which ranks choose their devices.
#[derive(Clone, Copy, Debug)]
pub struct Places {
    is_mpi: bool,
    size: usize,
}

impl Places {
    /// The device of a rank: threads share the cores, and ranks on one machine share its GPUs.
    pub fn device(self, options: DeviceOptions, rank: usize) -> DeviceOptions {
        if self.is_mpi {
            return options.place(local_rank().unwrap_or(rank));
        }
        let cores = thread::available_parallelism().map_or(1, usize::from);
        let threads = options.threads.unwrap_or((cores / self.size).max(1));
        options.threads(threads).place(rank)
    }
}

/// One of the ranks that hold shards of a scene.
#[derive(Clone, Copy, Debug)]
pub struct Member<'a> {
    pub ranks: &'a dyn Ranks,
    places: Places,
    mixed: bool,
}

impl Member<'_> {
    /// Opens the rank's device.
    pub fn open(&self, device: &DeviceArgs, console: Console) -> Result<Renderer> {
        let options = self.places.device(device.options()?, self.ranks.rank());
        device.open_as(&options, console)
    }

    /// Loads the rank's shard of a scene file to its device. `input` identifies the other inputs that all ranks have
    /// read.
    pub fn shard(
        &self,
        renderer: &Renderer,
        file: &Path,
        input: &str,
        options: UploadOptions,
    ) -> Result<DeviceShard> {
        let shard = SceneShard::load(file, self.ranks.rank(), self.ranks.size())
            .map_err(|error| told_apart(error, file, Expected::Scene))?;
        let input = format!("{} {:?} {input}", shard.gaussians, shard.scene.config);
        check_agreement(
            self.ranks,
            renderer.device(),
            organza::COMMIT.unwrap_or_default(),
            ("input", &input),
            self.mixed,
        )?;
        renderer.upload_shard(&shard, options)
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
        let renderer = Renderer::new(organza::open_device(options)?);
        train::follow(&renderer, dataset, &ranks, mixed)
    };
    if let Err(error) = follow() {
        ranks.fail(&error::chain(&error));
    }
}

/// The number of this process among those on its machine.
fn local_rank() -> Option<usize> {
    // Open MPI, Slurm, MPICH, Intel MPI
    const NAMES: [&str; 4] =
        ["OMPI_COMM_WORLD_LOCAL_RANK", "SLURM_LOCALID", "MPI_LOCALRANKID", "PMI_LOCAL_RANK"];
    NAMES.iter().find_map(|name| std::env::var(name).ok()?.parse().ok())
}
