//! A training, from its settings to its end.

use std::path::Path;
use std::sync::Arc;
use std::thread;
use std::time::Duration;

use indicatif::HumanDuration;
use organza::data::DatasetOptions;
use organza::error;
use organza::ranks::ThreadRanks;
use organza::scene::Placement;
use organza::train::config::{self, LearnExposure};
use organza::train::report::Reporter;
use organza::train::{CHECKPOINT, CROPPED, Event, Outcome, Session, TrainConfig, Watch};
use organza::view::TrainingView;
use organza::{Dataset, DeviceOptions, Renderer, Result, Scene};

use crate::cli::console::Console;
use crate::cli::device::DeviceArgs;
use crate::cli::inputs::DataSet;
use crate::cli::progress::{TrainingProgress, rounded};
use crate::cli::ranks::{RankGroup, follow_thread, of_many};
use crate::cli::signals::Signals;
use crate::cli::summary::{count, grouped};
use crate::cli::title;
use crate::cli::view::ServerArgs;

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

    /// Shrinks the photographs, if the run would not draw all of their pixels.
    fn shrink(&mut self, data: &mut DataSet, renderer: &Renderer, console: Console) -> Result<()> {
        let is_cpu_like = renderer.device().is_cpu_like();
        let steps = self.config.run.steps_for(f64::INFINITY, is_cpu_like);
        let gaussians = self.config.gaussians_for(f64::INFINITY, is_cpu_like);
        let pixels = self.pixels(steps, gaussians, renderer);
        self.config.data.downscale = data.shrink(pixels, console)?;
        Ok(())
    }

    /// Chooses the settings that depend on photographs and device. Of a new run, says what they are.
    fn resolve(&mut self, dataset: &Dataset, renderer: &Renderer, console: Console) {
        let measures_exposures = self.config.exposure.learn == LearnExposure::Auto;
        self.config.resolve(dataset, renderer.device());
        if self.resume {
            return;
        }
        self.say_plan(dataset, renderer, console);
        if measures_exposures {
            say_exposures(dataset, self.config.exposure.learn, console);
        }
    }

    /// Says how long the run is, before its first step.
    fn say_plan(&self, dataset: &Dataset, renderer: &Renderer, console: Console) {
        let of = config::pixels(dataset);
        let gaussians = self.config.densification.max_gaussians;
        let pixels = self.pixels(self.config.run.steps, gaussians, renderer);
        let per_step = self.config.run.pixels_per_step();
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
        self.config.check_memory()?;
        let placement = self.placement()?;
        let settings = &self.config.data;
        let options = DatasetOptions { placement, ..settings.options() };
        let mut data = DataSet::open(settings.clone(), &options, console)?;
        // a run that has begun may go on
        if !self.resume {
            data.check_downscale()?;
        }
        let server = self.view.map(|(server, _)| server.listen(console)).transpose()?;
        // until there is something in the folder
        let locked = signals.lock_run(self.folder, self.resume);
        let (_made, folder) =
            locked.map_err(|error| if self.group.is_none() { of_many(error) } else { error })?;
        let options = device.options()?;
        let mine = match &self.group {
            Some(group) => group.device(options.clone(), 0),
            None => options.clone(),
        };
        let renderer = device.open_as(&mine, console)?;
        if self.shrinks {
            self.shrink(&mut data, &renderer, console)?;
        }
        if let Some(group) = &self.group {
            group.tell(&self.config, placement)?;
        }
        let dataset = Arc::new(data.read(&renderer, console)?);
        self.resolve(&dataset, &renderer, console);
        let mut session = Session::new(&renderer, &self.config, &dataset, &folder);
        session.time_limit = self.time_limit;
        session.scheduled = self.scheduled;
        session.command = command_line();
        session.stop = signals.stop();
        let mut others = Vec::new();
        if let Some(group) = self.group.take() {
            let device_of = |rank| group.device(options.clone(), rank);
            let devices: Vec<_> = (1..=group.others.len()).map(device_of).collect();
            others = devices.into_iter().zip(group.others).collect();
            session.ranks = Some(group.mine);
            session.mixed = group.mixed;
        }
        let view = self.view.zip(server).map(|((args, share), server)| {
            args.announce(&server.url(), console);
            let title = title(self.folder);
            TrainingView::new(server, &renderer, &dataset, signals.stop(), share, title)
        });
        let progress = TrainingProgress::new(console, self.config.run.steps, self.time_limit);
        let mut listeners = Listeners {
            signals,
            reporter: Reporter::new(&folder),
            watch,
            progress,
            view,
            steps: self.config.run.steps,
            console,
        };
        let outcome = run_with(session, others, self.resume, &mut |event| listeners.see(&event))?;
        listeners.progress.end(outcome);
        if let Some(block) = dataset.block.as_ref().filter(|_| outcome != Outcome::Stopped) {
            let mut scene = Scene::load(self.folder.join(CHECKPOINT))?;
            block.crop(&mut scene)?;
            scene.save(self.folder.join(CROPPED))?;
            // last, as it says that the block is finished
            block.save(self.folder)?;
        }
        Ok(outcome)
    }
}

/// Those who learn of the events of a run.
struct Listeners<'a, 'w> {
    signals: &'a Signals,
    reporter: Reporter,
    watch: &'w mut dyn FnMut(&Event<'_>),
    progress: TrainingProgress,
    view: Option<TrainingView<'a>>,
    /// Number of steps of the run, as it begins.
    steps: u32,
    console: Console,
}

impl Listeners<'_, '_> {
    fn see(&mut self, event: &Event<'_>) -> Result<()> {
        if matches!(event, Event::Begin(_)) {
            self.signals.keeps_results();
        }
        self.reporter.see(event)?;
        (self.watch)(event);
        self.progress.show(event);
        // a run goes on without its page
        if let Some(view) = &mut self.view
            && let Err(error) = view.see(event, self.steps)
        {
            self.console.warn(&error::chain(&error));
        }
        Ok(())
    }
}

/// Runs a session, and the other ranks on threads of their own, each with its device.
fn run_with(
    session: Session<'_>,
    others: Vec<(DeviceOptions, ThreadRanks)>,
    resume: bool,
    see: &mut Watch<'_>,
) -> Result<Outcome> {
    let dataset = session.dataset;
    let mixed = session.mixed;
    thread::scope(|scope| {
        // the session ends before the threads are joined, because its end also ends them
        let session = session;
        for (options, ranks) in others {
            scope.spawn(move || follow_thread(ranks, &options, dataset, mixed));
        }
        session.run(resume, see)
    })
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
