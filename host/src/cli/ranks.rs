//! A training that ranks share: threads of this process.

use std::sync::Arc;
use std::thread;

use organza::ranks::{Ranks, ThreadRanks};
use organza::{Dataset, DeviceOptions, Renderer, Result, error, train};

/// Options of a training that ranks share.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Ranks")]
pub struct RanksArgs {
    /// Share the training among N threads, each with a device of its own; any N gives the same bits, which are not those of
    /// a training without this (docs/cluster.md)
    #[arg(long, value_name = "N")]
    #[arg(value_parser = clap::value_parser!(u16).range(1..=64))]
    ranks: Option<u16>,
}

impl RanksArgs {
    /// The ranks, if there are to be any.
    pub fn start(&self) -> Option<Team> {
        let mut ranks = ThreadRanks::new(usize::from(self.ranks?)).into_iter();
        let mine = Arc::new(ranks.next().expect("one at least"));
        Some(Team { mine, others: ranks.collect() })
    }
}

/// The ranks of a training, as the first of them sees it.
#[derive(Debug)]
pub struct Team {
    pub mine: Arc<dyn Ranks>,
    /// Those of other threads.
    pub others: Vec<ThreadRanks>,
}

impl Team {
    /// What a rank's device is: ranks share the cores, and take a machine's GPUs in turn.
    pub fn device(&self, options: DeviceOptions, rank: usize) -> DeviceOptions {
        let cores = thread::available_parallelism().map_or(1, usize::from);
        let threads = options.threads.unwrap_or((cores / self.mine.size()).max(1));
        options.threads(threads).place(rank)
    }
}

/// What a thread does that is not the first rank.
pub fn follow_thread(ranks: ThreadRanks, options: &DeviceOptions, dataset: &Arc<Dataset>) {
    let ranks: Arc<dyn Ranks> = Arc::new(ranks);
    let follow = || -> Result<()> {
        let renderer = Renderer::new(organza::open_device(options)?);
        train::follow(&renderer, dataset, &ranks, false)
    };
    if let Err(error) = follow() {
        ranks.fail(&error::chain(&error));
    }
}
