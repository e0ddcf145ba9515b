//! `organza train`: trains a scene on photographs.

use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::thread;
use std::time::Duration;

use clap::builder::PossibleValuesParser;
use clap::parser::ValueSource;
use clap::{Arg, ArgAction, ArgMatches, FromArgMatches};
use indicatif::HumanDuration;
use organza::error;
use organza::scene::Placement;
use organza::train::config::{self, LearnExposure, SETTINGS, Setting};
use organza::train::report::Reporter;
use organza::train::{
    self, CHECKPOINT, CONFIG, ConfigBuilder, Event, Outcome, Preset, REPORT, Session, TrainConfig,
};
use organza::view::TrainingView;
use organza::{Dataset, Error, Renderer, Result, Scene};
use serde::Serialize;

use super::console::{Console, print, print_json};
use super::demo::quoted;
use super::device::DeviceArgs;
use super::inputs::{DataSet, check_place};
use super::progress::{TrainingProgress, rounded};
use super::ranks::{RankGroup, RanksArgs, follow_thread, of_many};
use super::signals::Signals;
use super::summary::{count, grouped};
use super::view::ServerArgs;
use super::{absolute, capture, number_in, refuse, text_of, title};

const EXAMPLES: &str = "\
Examples:
  organza train -o run                                 the built-in scene, no files needed
  organza train data/fox -o run --minutes 10
  organza train garden.mp4 -o run                      finds the poses first, as `capture` does
  organza train --resume run                           continues after Ctrl-C, to the same bits
  organza train --resume run --steps 5000              extends a run, also one that is finished
  organza train data/fox -o quick --preset fast
  organza train data/fox -o other --config run/config.toml --seed 1
  organza train data/fox -o small --set scene.color_mlp.hidden=16,16 --set densification.end=0
  organza train data/fox -o run --refine-poses         poses of a phone, off by some pixels
  organza train data/fox -o run --view                 look at it while it trains
  organza train data/fox -o run --start scene.ply      from Gaussians that another program has made
  organza train data/fox -o run --ranks 2              on two GPUs
  mpirun -n 8 organza train data/fox -o run --ranks mpi
  organza train --preset best --print-config > mine.toml
  organza eval run

RUN gets config.toml (all settings; --config reads them back), metrics.jsonl (the log), \
checkpoint.safetensors (a scene that every other command accepts), checkpoint.best.safetensors (the one with the best \
held-out views), evaluations.csv (the scores of each held-out view), report.html and pictures/ (its images).";

/// The folder in a run for a data set that is made first.
const CAPTURED: &str = "data";

/// The examples, and the settings for `--set`.
fn long_help() -> String {
    let mut text = format!(
        "{EXAMPLES}\n\nSettings are overridden in this order: defaults, --preset, --config, --set, other options. \
         Settings for --set and --config, with their defaults (docs/training.md describes them):\n"
    );
    let hidden = |name: &str| SETTINGS.iter().any(|row| row.is_hidden() && row.name == name);
    for (name, value) in train::config::defaults().into_iter().filter(|(name, _)| !hidden(name)) {
        text += &format!("  {name}={value}\n");
    }
    text
}

/// Train a scene on photographs or a video, or on the built-in scene
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES, after_long_help = long_help())]
pub struct Args {
    /// The data set: a folder of nerfstudio, Blender or COLMAP, or a transforms.json. Of a video or a folder of photographs,
    /// RUN/data becomes the data set first, as by `organza capture`
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

/// Options for the settings of a training.
#[derive(Debug, clap::Args)]
pub struct SettingsArgs {
    /// The settings to start from: a settings file that is part of the program
    /// [default: default]
    #[arg(long, value_name = "NAME")]
    #[arg(value_parser = PossibleValuesParser::new(Preset::ALL.map(Preset::name)))]
    preset: Option<String>,
    /// A settings file, TOML, such as a run's config.toml; overrides the preset
    #[arg(long, value_name = "TOML")]
    config: Option<PathBuf>,
    /// Any setting, such as run.steps=3000; overrides the settings file. Give it once for each setting
    #[arg(long, value_name = "KEY=VALUE")]
    set: Vec<String>,
    #[command(flatten)]
    options: SettingOptions,
    /// Choose the number of steps so that the run takes this many minutes, evaluations included. config.toml keeps the
    /// number
    #[arg(long, value_name = "M", conflicts_with = "run.steps")]
    // a hundredth is enough for a few steps of anything, and nothing is trained for a year
    #[arg(value_parser = number_in(0.01..=500_000.0, "a number of minutes, such as 10 or 0.5"))]
    minutes: Option<f64>,
}

/// The options of single settings, such as `--steps`. [`SETTINGS`] has them.
#[derive(Debug, Default)]
struct SettingOptions {
    /// Names of settings and the values that were given, as `--set` takes them.
    given: Vec<(&'static str, String)>,
}

impl SettingOptions {
    fn get(&self, name: &str) -> Option<&str> {
        self.given.iter().find(|(given, _)| *given == name).map(|(_, value)| &**value)
    }

    /// The option of a setting that has one.
    fn arg(setting: &'static Setting) -> Option<Arg> {
        let (name, value) = match setting.option.split_once(' ') {
            Some((name, value)) => (name, Some(value)),
            None => (setting.option, None),
        };
        let arg = Arg::new(setting.name).long(name.strip_prefix("--")?).help(setting.text());
        let Some(value) = value else { return Some(arg.action(ArgAction::SetTrue)) };
        let parse = |text: &str| setting.check(text).map(|()| text.to_owned());
        Some(arg.value_name(value.trim_matches(['<', '>'])).value_parser(parse))
    }
}

impl clap::Args for SettingOptions {
    fn augment_args(command: clap::Command) -> clap::Command {
        command.args(SETTINGS.iter().filter_map(Self::arg))
    }

    fn augment_args_for_update(command: clap::Command) -> clap::Command {
        Self::augment_args(command)
    }
}

impl FromArgMatches for SettingOptions {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let mut options = Self::default();
        options.update_from_arg_matches(matches)?;
        Ok(options)
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        for setting in SETTINGS.iter().filter(|setting| !setting.option.is_empty()) {
            if matches.value_source(setting.name) != Some(ValueSource::CommandLine) {
                continue;
            }
            let value = match setting.option.contains(' ') {
                true => matches.get_one::<String>(setting.name).cloned(),
                false => Some("true".to_owned()),
            };
            self.given.extend(value.map(|value| (setting.name, value)));
        }
        Ok(())
    }
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
    let (folder, config, shrinks) = prepare(args, &signals, console)?;
    let scheduled = args.settings.scheduled();
    let time_limit = args.time_limit.map(f64::from);
    let share = f64::from(args.view_share) / 100.0;
    let view = args.view.then_some((&args.server, share));
    let resume = args.resume.is_some();
    let job =
        TrainJob { config, folder: &folder, resume, shrinks, scheduled, time_limit, view, group };
    let mut ended = Ended::default();
    let outcome = job.run(&args.device, console, &signals, &mut |event| ended.see(event));
    let outcome = outcome.map_err(|error| with_resume(error, &folder))?;
    console.note(&match outcome {
        Outcome::Stopped => {
            format!("saved; `organza train --resume {}` continues from here", folder.display())
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
    if args.json { print_json(&ended.with_outcome(&folder, outcome)) } else { Ok(()) }
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
    /// Score of the last evaluation.
    psnr: Option<f64>,
    ssim: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    psnr_fitted: Option<f64>,
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
            Event::Evaluated(evaluation) => {
                self.psnr = evaluation.mean.psnr;
                self.ssim = evaluation.mean.ssim;
                self.psnr_fitted = evaluation.mean.psnr_fitted;
            }
            _ => {}
        }
    }

    fn with_outcome(self, folder: &Path, outcome: Outcome) -> Self {
        let outcome = match outcome {
            Outcome::Finished => "finished",
            Outcome::TimeLimit => "time limit",
            _ => "stopped",
        };
        let checkpoint = text_of(&folder.join(CHECKPOINT));
        let report = text_of(&folder.join(REPORT));
        Self { folder: text_of(folder), outcome, checkpoint, report, ..self }
    }
}

/// A run to train, from its first step or from its checkpoint.
#[derive(Debug)]
pub struct TrainJob<'a> {
    /// Settings of the run.
    pub config: TrainConfig,
    /// Folder of the run.
    pub folder: &'a Path,
    /// Whether the folder has a run to resume.
    pub resume: bool,
    /// Whether photographs shrink if the run would not draw all of their pixels.
    pub shrinks: bool,
    /// See [`Session::scheduled`].
    pub scheduled: Option<f64>,
    /// See [`Session::time_limit`].
    pub time_limit: Option<f64>,
    /// The page's address, and the part of the time that its images may take.
    pub view: Option<(&'a ServerArgs, f64)>,
    /// The ranks that share the run, if this is the first of them.
    pub group: Option<RankGroup>,
}

impl TrainJob<'_> {
    /// The placement of the scene that the run goes on with.
    fn placement(&self) -> Result<Option<Placement>> {
        let checkpoint = self.folder.join(CHECKPOINT);
        let is_there = self.resume && checkpoint.exists();
        is_there.then(|| Ok(Scene::load_config(checkpoint)?.placement)).transpose()
    }

    /// Number of pixels that the run draws in so many steps, or in the time that it should take with so many Gaussians.
    fn pixels(&self, steps: u32, gaussians: u32, renderer: &Renderer) -> f64 {
        let in_time =
            self.scheduled.map(|seconds| seconds * pixels_per_second(renderer, gaussians));
        in_time.unwrap_or(f64::from(steps) * self.config.run.pixels_per_step())
    }

    /// Says how long the run is, before its first step.
    fn say_plan(
        &self,
        config: &TrainConfig,
        dataset: &Dataset,
        renderer: &Renderer,
        console: Console,
    ) {
        let of = config::pixels(dataset);
        let gaussians = config.densification.max_gaussians;
        let pixels = self.pixels(config.run.steps, gaussians, renderer);
        let per_step = config.run.pixels_per_step();
        let about = if self.scheduled.is_some() { "about " } else { "" };
        let time = Duration::from_secs_f64(pixels / pixels_per_second(renderer, gaussians));
        console.note(&format!(
            "planned: {about}{} of {} pixels, {} times the pixels of {}, and up to {}; that takes about {} here",
            count((pixels / per_step) as u64, "step"),
            grouped(per_step as u64),
            rounded(pixels / of),
            count(dataset.train.len() as u64, "photograph"),
            count(gaussians.into(), "Gaussian"),
            HumanDuration(time),
        ));
    }

    /// Creates the folder, reads the photographs, and trains.
    pub fn run(
        mut self,
        device: &DeviceArgs,
        console: Console,
        signals: &Signals,
        watch: &mut dyn FnMut(&Event<'_>),
    ) -> Result<Outcome> {
        let mut config = self.config.clone();
        config.check_memory()?;
        let group = self.group.take();
        let placement = self.placement()?;
        let mut data = DataSet::open(config.data.clone(), placement, console)?;
        // a run that has begun may go on
        if !self.resume {
            data.check_downscale()?;
        }
        let server = self.view.map(|(server, _)| server.listen(console)).transpose()?;
        // until there is something in the folder
        let (_made, folder) = signals.lock_run(self.folder, self.resume)?;
        let folder =
            folder.map_err(|error| if group.is_none() { of_many(error) } else { error })?;
        let options = device.options()?;
        let of_rank = |rank| match &group {
            Some(group) => group.places().device(options.clone(), rank),
            None => options.clone(),
        };
        let renderer = device.open_as(&of_rank(0), console)?;
        if self.shrinks {
            let is_cpu_like = renderer.device().is_cpu_like();
            let steps = config.run.steps_for(f64::INFINITY, is_cpu_like);
            let gaussians = config.gaussians_for(f64::INFINITY, is_cpu_like);
            let pixels = self.pixels(steps, gaussians, &renderer);
            config.data.downscale = data.shrink(pixels, console)?;
        }
        if let Some(group) = &group {
            group.tell(&config, placement)?;
        }
        let dataset = Arc::new(data.read(&renderer, console)?);
        let measures_exposures = !self.resume && config.exposure.learn == LearnExposure::Auto;
        config.resolve(&dataset, renderer.device());
        if !self.resume {
            self.say_plan(&config, &dataset, &renderer, console);
        }
        if measures_exposures {
            say_exposures(&dataset, config.exposure.learn, console);
        }
        let of_others: Vec<_> =
            group.iter().flat_map(|group| 1..=group.others.len()).map(of_rank).collect();
        let (mine, others, mixed) = match group {
            Some(RankGroup { mine, others, mixed, .. }) => (Some(mine), others, mixed),
            None => (None, Vec::new(), false),
        };
        let mut session = Session::new(&renderer, &config, &dataset, &folder);
        session.time_limit = self.time_limit;
        session.scheduled = self.scheduled;
        session.command = command_line();
        session.stop = signals.stop();
        session.ranks = mine;
        session.mixed = mixed;
        let mut view = self.view.zip(server).map(|((args, share), server)| {
            args.announce(&server.url(), console);
            let stop = signals.stop();
            let title = title(self.folder);
            TrainingView::new(server, &renderer, &dataset, stop, share, title)
        });
        let mut progress = TrainingProgress::new(console, config.run.steps, self.time_limit);
        let mut reporter = Reporter::new(&folder);
        let mut see = |event: Event<'_>| {
            if matches!(event, Event::Begin(_)) {
                signals.keeps_results();
            }
            reporter.see(&event)?;
            watch(&event);
            progress.show(&event);
            if let Some(view) = &mut view
                && let Err(error) = view.see(&event, config.run.steps)
            {
                console.warn(&error::chain(&error));
            }
            Ok(())
        };
        let outcome = thread::scope(|scope| {
            // the session ends before the threads are joined, because its end also ends them
            let session = session;
            for (ranks, options) in others.into_iter().zip(&of_others) {
                let dataset = &dataset;
                scope.spawn(move || follow_thread(ranks, options, dataset, mixed));
            }
            session.run(self.resume, &mut see)
        })?;
        progress.end(outcome);
        Ok(outcome)
    }
}

/// The pixels that training draws in a second, with at most so many Gaussians: a guess, before the first step.
fn pixels_per_second(renderer: &Renderer, gaussians: u32) -> f64 {
    let cores = thread::available_parallelism().map_or(1, usize::from);
    // docs/performance.md: what a core of Zen 5 and an H200 do over a whole run with 30,000 Gaussians
    let usual = if renderer.device().is_cpu_like() { 3e5 * cores as f64 } else { 9e6 };
    usual / (0.7 + 0.3 * f64::from(gaussians) / 30_000.0).max(1.0)
}

/// Says how much exposures differ, and whether they are learned.
fn say_exposures(dataset: &Dataset, learn: LearnExposure, console: Console) {
    let Some(spread) = dataset.exposure_spread() else { return };
    let found = format!("the photographs' exposures differ by {:.0}%", 100.0 * spread);
    match learn {
        LearnExposure::On => console.note(&format!(
            "{found}, so the run learns them; `--set exposure.learn=off` takes colors as they are"
        )),
        _ => console.detail(&found),
    }
}

/// The words of the command line, quoted for a shell. The program is without its folder.
fn command_line() -> Option<String> {
    let words: Vec<String> =
        std::env::args_os().skip(1).map(|word| word.to_string_lossy().into_owned()).collect();
    let words = std::iter::once("organza").chain(words.iter().map(String::as_str));
    shlex::try_join(words).ok()
}

/// The run's folder and settings, and whether photographs may shrink. A video and photographs become a data set in the folder.
fn prepare(
    args: &Args,
    signals: &Signals,
    console: Console,
) -> Result<(PathBuf, TrainConfig, bool)> {
    if let Some(folder) = &args.resume {
        if folder.join(CAPTURED).exists() && !folder.join(CONFIG).exists() {
            let folder = folder.display();
            return refuse(format!(
                "{folder} has no training yet, only what it trains on: continue with the command that began it, \
                 `organza train VIDEO|PHOTOS -o {folder}`"
            ));
        }
        let config = args.settings.resumed(folder)?;
        check_place(&config.data, folder)?;
        return Ok((folder.clone(), config, false));
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
    Ok((folder, config, shrinks))
}

impl SettingsArgs {
    /// The settings of a resumed run: its own, with the changes that the options make.
    pub fn resumed(&self, folder: &Path) -> Result<TrainConfig> {
        let mut config = train::changed_settings_of(folder, |config| {
            self.adjusted(ConfigBuilder::from_config(&config))?.build()
        })?;
        config.data.path = config.data.path.map(|path| absolute(&path));
        Ok(config)
    }

    /// The settings to train on a data set, or on the built-in scene, and whether they leave the size of photographs open.
    fn settings(&self, data: Option<&Path>) -> Result<(TrainConfig, bool)> {
        let named = self.preset.as_deref();
        let preset = match Preset::ALL.into_iter().find(|preset| Some(preset.name()) == named) {
            Some(preset) => preset,
            None if data.is_none() && self.config.is_none() => Preset::BuiltIn,
            None => Preset::Default,
        };
        let mut builder = ConfigBuilder::new(preset)?;
        if let Some(path) = &self.config {
            builder = builder.file(path)?;
        }
        builder = self.adjusted(builder)?;
        let shrinks = !builder.has("data", "downscale");
        let mut config = builder.build()?;
        if let Some(data) = data {
            config.data.path = Some(data.to_owned());
        }
        // a run can be resumed from any folder
        for path in [&mut config.data.path, &mut config.start.path].into_iter().flatten() {
            *path = absolute(path);
        }
        config.validate()?;
        Ok((config, shrinks))
    }

    /// Settings with single values from the command line.
    fn adjusted(&self, mut builder: ConfigBuilder) -> Result<ConfigBuilder> {
        for assignment in &self.set {
            builder = builder.set(assignment)?;
        }
        if self.options.get("run.steps").is_some() || self.minutes.is_some() {
            builder = builder.set("run.schedule=")?;
        }
        for (name, value) in &self.options.given {
            builder = builder.set(&format!("{name}={value}"))?;
        }
        Ok(builder)
    }

    /// Seconds that the run should take, if its number of steps is to be chosen.
    pub fn scheduled(&self) -> Option<f64> {
        self.minutes.map(|minutes| 60.0 * minutes)
    }
}
