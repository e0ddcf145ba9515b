//! `organza train`: trains a scene on photographs.

mod blocks;
mod job;
mod settings;

use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

use organza::error;
use organza::evaluate::Score;
use organza::train::{CAPTURED, CHECKPOINT, CONFIG, Event, Outcome, REPORT, TrainConfig};
use organza::{Error, Result};
use serde::Serialize;

use super::console::{Console, print, print_json};
use super::device::DeviceArgs;
use super::inputs::check_place;
use super::ranks::{RankGroup, RanksArgs};
use super::signals::Signals;
use super::view::ServerArgs;
use super::{absolute, capture, quoted, refuse, text_of};
use job::TrainJob;
use settings::{SettingsArgs, long_help};

const EXAMPLES: &str = include_str!("../help/train.txt");

/// Train a scene on photographs or a video, or on the built-in scene
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES, after_long_help = long_help(EXAMPLES))]
pub struct Args {
    /// The data set: a folder of nerfstudio, Blender or COLMAP, or a transforms.json. Of a video or a folder of photographs,
    /// RUN/data becomes the data set first, as by `organza capture`. Of the folder of a split, all blocks are trained
    /// [default: the built-in scene, with --preset built-in unless --config is given]
    data: Option<PathBuf>,
    /// The folder for the run; created if it does not exist
    #[arg(short, long, value_name = "RUN", required_unless_present_any = ["resume", "print_config"])]
    output: Option<PathBuf>,
    /// Continue a run that was stopped, with its own settings. Only these options may change them: --steps and
    /// --max-gaussians; --minutes, which trains for that many more minutes; --evaluate-every, --checkpoint-every and --set
    /// run.log_every
    #[arg(long, value_name = "RUN", conflicts_with_all = ["output", "data", "preset", "config"])]
    resume: Option<PathBuf>,
    #[command(flatten)]
    settings: SettingsArgs,
    /// Print all settings as TOML, and do nothing else
    #[arg(long)]
    print_config: bool,
    /// Finish after this many seconds of training, at any step of the run. Unlike with --minutes, learning
    /// rates and densification do not depend on this time
    #[arg(long, value_name = "SECONDS", conflicts_with = "minutes")]
    #[arg(value_parser = clap::value_parser!(u32).range(1..))]
    time_limit: Option<u32>,
    /// Print JSON when the run ends: the reason for its end, and the results (docs/json.md)
    #[arg(long)]
    json: bool,
    /// While training, show a page with the scene, the curves, and buttons to pause and stop
    #[arg(long, help_heading = "Page")]
    view: bool,
    /// The part of the time that the page's images may take, in percent
    #[arg(long, value_name = "PERCENT", help_heading = "Page", default_value_t = 10)]
    #[arg(value_parser = clap::value_parser!(u8).range(1..=90))]
    view_share: u8,
    #[command(flatten)]
    server: ServerArgs,
    #[command(flatten)]
    ranks: RanksArgs,
    #[command(flatten)]
    device: DeviceArgs,
}

pub fn run(args: &Args, console: Console) -> Result<()> {
    if args.print_config {
        let config = match &args.resume {
            Some(folder) => args.settings.resumed(folder)?,
            None => args.settings.settings(args.data.as_deref())?.0,
        };
        return if args.json { print_json(&config) } else { print(&config.to_toml()) };
    }
    if !args.view && args.server.is_given() {
        return refuse("`--port`, `--bind` and `--open` are for the page of `--view`");
    }
    if let Some(blocks) = args.data.as_deref().map(blocks::of_split).transpose()?.flatten() {
        return blocks::train(args, &blocks, console);
    }
    let Some(group) = args.ranks.start()? else { return lead(args, None, console) };
    if group.mine.rank() > 0 {
        return group.follow_process(&args.device);
    }
    // threads end when rank 0 is gone, but processes need a message
    let processes = group.is_mpi.then(|| group.mine.clone());
    lead(args, Some(group), console).inspect_err(|error| {
        if let Some(processes) = processes {
            processes.fail(&error::chain(error));
        }
    })
}

/// Trains as the first rank, or alone.
fn lead(args: &Args, group: Option<RankGroup>, console: Console) -> Result<()> {
    let signals = Signals::listen()?;
    let prepared = prepare(args, &signals, console)?;
    let ended = prepared.train(args, group, &signals, console)?;
    if args.json { print_json(&ended) } else { Ok(()) }
}

/// A run that can begin or go on.
struct Prepared {
    folder: PathBuf,
    config: TrainConfig,
    /// Whether the folder has a run to resume.
    resume: bool,
    /// Whether photographs may shrink.
    shrinks: bool,
}

impl Prepared {
    /// Trains to the end, and says what comes next.
    fn train(
        self,
        args: &Args,
        group: Option<RankGroup>,
        signals: &Signals,
        console: Console,
    ) -> Result<Ended> {
        let Self { folder, config, resume, shrinks } = self;
        let share = f64::from(args.view_share) / 100.0;
        let job = TrainJob {
            config,
            folder: &folder,
            resume,
            shrinks,
            scheduled: args.settings.minutes.map(|minutes| 60.0 * minutes),
            time_limit: args.time_limit.map(f64::from),
            view: args.view.then_some((&args.server, share)),
            group,
        };
        let mut ended = Ended::default();
        let outcome = job.run(&args.device, console, signals, &mut |event| ended.see(event));
        let outcome = outcome.map_err(|error| with_resume(error, &folder))?;
        console.note(&match outcome {
            Outcome::Stopped => {
                format!("saved; `organza train --resume {}` continues from here", quoted(&folder))
            }
            _ => {
                format!(
                    "wrote {} and {}\nnext: organza view {}",
                    folder.join(CHECKPOINT).display(),
                    folder.join(REPORT).display(),
                    quoted(&folder)
                )
            }
        });
        Ok(ended.with_outcome(&folder, outcome))
    }
}

/// The error, and what continues the run once a full disk has room again.
fn with_resume(error: Error, folder: &Path) -> Error {
    match error {
        Error::WriteFile { path, source }
            if [ErrorKind::StorageFull, ErrorKind::QuotaExceeded].contains(&source.kind())
                && folder.join(CONFIG).exists() =>
        {
            let resume = format!("{source}, then `organza train --resume {}`", quoted(folder));
            Error::WriteFile { path, source: io::Error::new(source.kind(), resume) }
        }
        error => error,
    }
}

/// The outcome of a run that was stopped.
const STOPPED: &str = "stopped";

/// The output of `--json` at the end of a run.
#[derive(Debug, Default, Serialize)]
struct Ended {
    folder: String,
    outcome: &'static str,
    checkpoint: String,
    report: String,
    step: u32,
    seconds: Option<f64>,
    gaussians: Option<usize>,
    /// Scores of the last evaluation.
    #[serde(flatten)]
    mean: Score,
}

impl Ended {
    fn see(&mut self, event: &Event<'_>) {
        match event {
            Event::Begin(step) => self.step = *step,
            Event::Step { step, seconds, gaussians, .. } => {
                self.step = *step;
                self.seconds = Some(*seconds);
                self.gaussians = Some(*gaussians);
            }
            Event::Evaluated(evaluation) => self.mean = evaluation.mean,
            _ => {}
        }
    }

    fn with_outcome(self, folder: &Path, outcome: Outcome) -> Self {
        let outcome = match outcome {
            Outcome::Finished => "finished",
            Outcome::TimeLimit => "time limit",
            _ => STOPPED,
        };
        let checkpoint = text_of(&folder.join(CHECKPOINT));
        let report = text_of(&folder.join(REPORT));
        Self { folder: text_of(folder), outcome, checkpoint, report, ..self }
    }
}

/// The run's folder and settings. A video and photographs become a data set in the folder.
fn prepare(args: &Args, signals: &Signals, console: Console) -> Result<Prepared> {
    if let Some(folder) = &args.resume {
        if folder.join(CAPTURED).exists() && !folder.join(CONFIG).exists() {
            return refuse(format!(
                "{} has no training yet, only what it trains on: continue with the command that began it, \
                 `organza train VIDEO|PHOTOS -o {}`",
                folder.display(),
                quoted(folder)
            ));
        }
        let config = args.settings.resumed(folder)?;
        check_place(&config.data, folder)?;
        return Ok(Prepared { folder: folder.clone(), config, resume: true, shrinks: false });
    }
    let folder = args.output.clone().expect("clap requires it");
    let (mut config, shrinks) = args.settings.settings(args.data.as_deref())?;
    if let Some(source) = config.data.path.take_if(|path| capture::is_source(path)) {
        if folder.join(CONFIG).exists() {
            let folder = folder.display();
            return refuse(format!(
                "{folder} holds a run already; continue it with `--resume`, or name another folder"
            ));
        }
        let data = folder.join(CAPTURED);
        config.data.path = Some(absolute(&data));
        config.validate()?;
        config.check_memory()?;
        let source = args.data.as_deref().unwrap_or(&source);
        capture::for_training(source, &data, signals, console)?;
    }
    Ok(Prepared { folder, config, resume: false, shrinks })
}
