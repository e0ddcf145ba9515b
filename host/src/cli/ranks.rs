//! The options of commands that ranks share, and what ranks other than the first do.

use std::path::Path;
use std::str::FromStr;
use std::sync::Arc;
use std::thread;

use organza::ranks::{Ranks, ThreadRanks, meet};
use organza::scene::SceneShare;
use organza::train::{self, Split, TrainConfig};
use organza::{Dataset, DeviceOptions, DeviceShare, Renderer, Result, UploadOptions, error};

use super::console::Console;
use super::device::DeviceArgs;
use super::inputs::{DataSet, Expected, told_apart};
use super::signals::Signals;
use super::verbosity::Level;

/// Options of a training that ranks share.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Ranks")]
pub struct RanksArgs {
    /// Share the training among N threads, each with a device of its own; or `mpi`: among the processes that mpirun or srun
    /// has started. Any number of ranks gives the bits of a training without this
    /// (docs/cluster.md)
    #[arg(long, value_name = "N|mpi")]
    ranks: Option<Kind>,
    /// What ranks share. `views`: each holds the whole scene. `gaussians`: each holds some of the Gaussians, for scenes that do
    /// not fit on one device. The scene's bits depend on this [default: views]
    #[arg(long, value_name = "WHAT", requires = "ranks")]
    split: Option<SplitName>,
    /// With `--split gaussians`: deal the Gaussians in N shares, to groups of N ranks. The groups share the views. N divides the
    /// number of ranks. The scene's bits do not depend on it [default: as many as ranks, one group]
    #[arg(long, value_name = "N", requires = "split")]
    shares: Option<usize>,
    /// Allow ranks with different programs or devices; the scene's bits then depend on which of them computes what
    #[arg(long, requires = "ranks")]
    mixed: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum SplitName {
    Views,
    Gaussians,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Threads(usize),
    Mpi,
}

/// More threads than that are a mistake: each holds the whole scene.
const MOST_THREADS: usize = 64;

impl FromStr for Kind {
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
    /// The ranks, if there are to be any.
    pub fn start(&self) -> Result<Option<Team>> {
        let split = match self.split {
            Some(SplitName::Gaussians) => Split::Gaussians,
            _ => Split::Views,
        };
        if split == Split::Views && self.shares.is_some() {
            return super::refuse("`--shares` is for `--split gaussians`");
        }
        let team = self.ranks.map(|kind| Team::start(kind, self.mixed)).transpose()?;
        Ok(team.map(|team| Team { split, shares: self.shares, ..team }))
    }
}

/// Options of rendering with Gaussians that are dealt to ranks.
#[derive(Debug, clap::Args)]
pub struct SharesArgs {
    /// Deal the Gaussians to N threads, each with a device of its own; or `mpi`: to the processes that mpirun or srun has
    /// started. For scenes that do not fit on one device. Any number of ranks gives the same bits (docs/cluster.md)
    #[arg(long, value_name = "N|mpi", help_heading = "Ranks")]
    ranks: Option<Kind>,
    /// Allow ranks with different programs or devices; the image's bits then depend on which of them computes what
    #[arg(long, requires = "ranks", help_heading = "Ranks")]
    mixed: bool,
}

impl SharesArgs {
    /// The ranks, if there are to be any.
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

/// Ranks, as one of them sees them.
#[derive(Debug)]
pub struct Team {
    /// This process's, or that of its first thread.
    pub mine: Arc<dyn Ranks>,
    /// Those of other threads.
    pub others: Vec<ThreadRanks>,
    pub mixed: bool,
    /// What they share of a training.
    pub split: Split,
    /// In how many shares its Gaussians are dealt, if not as many as ranks.
    pub shares: Option<usize>,
    pub is_mpi: bool,
}

impl Team {
    fn start(kind: Kind, mixed: bool) -> Result<Self> {
        match kind {
            Kind::Threads(size) => {
                let mut ranks = ThreadRanks::new(size).into_iter();
                let mine = Arc::new(ranks.next().expect("one at least"));
                Ok(Self::new(mine, ranks.collect(), mixed))
            }
            Kind::Mpi => Ok(Self { is_mpi: true, ..Self::new(start_mpi()?, Vec::new(), mixed) }),
        }
    }

    fn new(mine: Arc<dyn Ranks>, others: Vec<ThreadRanks>, mixed: bool) -> Self {
        Self { mine, others, mixed, split: Split::default(), shares: None, is_mpi: false }
    }

    /// Does `lead` on rank 0 and `follow` on the others. Who fails ends all.
    pub fn run(
        self,
        lead: impl FnOnce(Member<'_>) -> Result<()>,
        follow: impl Fn(Member<'_>) -> Result<()> + Sync,
    ) -> Result<()> {
        let (places, Self { mine, others, mixed, is_mpi, .. }) = (self.places(), self);
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
            // before the threads are waited for: they end when rank 0 is gone
            drop(mine);
            result
        })
    }

    /// Rank 0's settings, which the others cannot read while it writes them.
    pub fn tell(&self, config: &TrainConfig) -> Result<()> {
        if self.is_mpi {
            self.mine.broadcast(config.to_toml().into_bytes())?;
        }
        Ok(())
    }

    /// How ranks choose their devices.
    pub fn places(&self) -> Places {
        Places { is_mpi: self.is_mpi, size: self.mine.size() }
    }

    /// What an MPI process does that is not the first: reads the photographs, and does as it is told.
    pub fn follow_process(&self, device: &DeviceArgs) -> Result<()> {
        let ranks = &self.mine;
        let follow = || {
            // the first signal is for rank 0 to act on
            let signals = Signals::listen()?;
            signals.keeps_results();
            let text = String::from_utf8_lossy(&ranks.broadcast(Vec::new())?).into_owned();
            let config = TrainConfig::parse(&text, "the settings of rank 0".as_ref())?;
            let console = Console::new(Level::Quiet);
            let data = DataSet::open(config.data, console)?;
            let options = self.places().device(device.options()?, ranks.rank());
            let renderer = device.open_as(&options, console)?;
            let dataset = Arc::new(data.read(&renderer, console)?);
            train::follow(&renderer, &dataset, ranks, self.mixed)
        };
        follow().inspect_err(|error| ranks.fail(&error::chain(error)))
    }
}

/// How ranks choose their devices.
#[derive(Clone, Copy, Debug)]
pub struct Places {
    is_mpi: bool,
    size: usize,
}

impl Places {
    /// What a rank's device is: threads share the cores, and ranks of one machine its GPUs.
    pub fn device(self, options: DeviceOptions, rank: usize) -> DeviceOptions {
        if self.is_mpi {
            return options.place(local_rank().unwrap_or(rank));
        }
        let cores = thread::available_parallelism().map_or(1, usize::from);
        let threads = options.threads.unwrap_or((cores / self.size).max(1));
        options.threads(threads).place(rank)
    }
}

/// A rank of those that hold shares of a scene.
#[derive(Clone, Copy, Debug)]
pub struct Member<'a> {
    pub ranks: &'a dyn Ranks,
    places: Places,
    mixed: bool,
}

impl Member<'_> {
    /// Opens its device.
    pub fn open(&self, device: &DeviceArgs, console: Console) -> Result<Renderer> {
        let options = self.places.device(device.options()?, self.ranks.rank());
        device.open_as(&options, console)
    }

    /// Its share of the scene in a file, on its device. `input` identifies what else all ranks have read.
    pub fn share(
        &self,
        renderer: &Renderer,
        file: &Path,
        input: &str,
        options: UploadOptions,
    ) -> Result<DeviceShare> {
        let share = SceneShare::load(file, self.ranks.rank(), self.ranks.size())
            .map_err(|error| told_apart(error, file, Expected::Scene))?;
        let input = format!("{} {:?} {input}", share.gaussians, share.scene.config);
        meet(
            self.ranks,
            renderer.device(),
            organza::COMMIT.unwrap_or_default(),
            ("input", &input),
            self.mixed,
        )?;
        renderer.upload_share(&share, options)
    }
}

/// What a thread does that is not the first rank.
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

/// This process's number among those of its machine.
fn local_rank() -> Option<usize> {
    // Open MPI, Slurm, MPICH, Intel MPI
    const NAMES: [&str; 4] =
        ["OMPI_COMM_WORLD_LOCAL_RANK", "SLURM_LOCALID", "MPI_LOCALRANKID", "PMI_LOCAL_RANK"];
    NAMES.iter().find_map(|name| std::env::var(name).ok()?.parse().ok())
}
