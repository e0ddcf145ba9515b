//! A run from its first step, or from a checkpoint, to its end; everything that it leaves in its folder.

use std::collections::BTreeMap;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use super::binding::{Binding, Change};
use super::checkpoint::{BEST, CHECKPOINT, Checkpoint, Progress};
use super::config::TrainConfig;
use super::folder::{CONFIG, EVALUATIONS, METRICS, REPORT, RunFolder};
use super::hooks::StepHooks;
use super::metrics::{MetricsLog, Record, SessionInfo, TimingRow};
use super::plan::{Now, Planner};
use super::report::{Pictures, Run, write_report};
use super::tensorboard::{EventLog, MAX_VIEWS};
use super::trainer::{StepReport, Trainer};
use crate::data::{Dataset, Frame};
use crate::error::Result;
use crate::evaluate::csv::save_csv;
use crate::evaluate::{self, Evaluation, evaluate_with};
use crate::image::Image;
use crate::render::{DeviceScene, Renderer};

/// A training run in a folder: a [`Trainer`] with a log, checkpoints, evaluations and a report.
///
/// ```
/// use std::sync::Arc;
///
/// use organza::train::{Outcome, RunFolder, Session, TrainConfig, built_in};
/// use organza::{DeviceOptions, Renderer};
///
/// let renderer = Renderer::new(organza::open_device(&DeviceOptions::cpu(None))?);
/// let dataset = Arc::new(built_in::dataset(&renderer, 4, 32, 2)?);
/// let mut config = TrainConfig::default();
/// (config.run.steps, config.run.tiles_per_step, config.run.tile_size) = (2, 2, 16);
/// config.start.gaussians = 100;
///
/// let path = tempfile::tempdir().expect("a folder");
/// let folder = RunFolder::lock(path.path(), false)?;
/// let session = Session::new(&renderer, &config, &dataset, &folder);
/// let outcome = session.run(false, &mut |event| println!("{event:?}"))?;
/// assert_eq!(outcome, Outcome::Finished);
/// assert!(path.path().join("report.html").exists());
/// # Ok::<(), organza::Error>(())
/// ```
#[derive(Debug)]
#[non_exhaustive]
pub struct Session<'a> {
    /// Renders and trains.
    pub renderer: &'a Renderer,
    /// Every setting.
    pub config: &'a TrainConfig,
    /// The photographs.
    pub dataset: &'a Arc<Dataset>,
    /// The folder of the run. A run that begins writes its settings there.
    pub folder: &'a RunFolder,
    /// Training ends after so many seconds, those before a resume included, as it does after the last step.
    pub time_limit: Option<f64>,
    /// The number of steps is chosen so that the run takes so many seconds, and written to its settings. Those of
    /// `config` do not count then.
    pub planned: Option<f64>,
    /// The command line, for the log and the report.
    pub command: Option<String>,
    /// Set from outside to save and stop.
    pub stop: &'a AtomicBool,
}

/// What happens during a run.
#[derive(Debug)]
#[non_exhaustive]
pub enum Event<'a> {
    /// Something that should not be missed.
    Warning(&'a str),
    /// Training goes on after so many steps; 0 where it begins. Nothing was written to the folder yet.
    Begin(u32),
    /// A setting is another than before the resume.
    Changed(&'a Change),
    /// The number of all steps was chosen, once more.
    Planned(u32),
    /// A step is done.
    Step {
        /// Steps so far.
        step: u32,
        /// Seconds of training so far.
        seconds: f64,
        /// What it measured.
        report: &'a StepReport,
        /// The scene, on the device.
        scene: &'a DeviceScene,
    },
    /// Held-out views are being measured.
    Evaluating,
    /// The held-out views were measured.
    Evaluated(&'a Evaluation),
}

/// Why a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Outcome {
    /// After its last step.
    Finished,
    /// At its time limit.
    TimeLimit,
    /// Because it was told to.
    Stopped,
}

/// What changes while a run goes on.
struct State<'a, 'w, 'h> {
    session: &'a Session<'a>,
    trainer: Trainer,
    log: MetricsLog,
    /// How the settings changed, in this resume and in earlier ones.
    changes: Vec<Change>,
    pictures: Pictures,
    /// Whether this session has taken a step: one that has not leaves no record.
    has_begun: bool,
    /// The log for TensorBoard, if the settings ask for it.
    events: Option<EventLog>,
    /// The step of the log's last evaluation.
    evaluated: Option<u64>,
    seconds: f64,
    /// When this session began.
    begin: Instant,
    planner: Option<Planner>,
    /// The PSNR of the best checkpoint.
    best: Option<f64>,
    /// Seconds of each kernel and of what surrounds them.
    stages: BTreeMap<&'static str, f64>,
    /// When the last line was logged: tiles since, and the seconds then.
    since: (usize, f64),
    watch: &'w mut dyn FnMut(Event<'_>),
    hooks: &'w mut StepHooks<'h>,
}

/// Nothing sets it.
static NEVER: AtomicBool = AtomicBool::new(false);

impl<'a> Session<'a> {
    /// A run without a time limit, that nobody stops.
    #[must_use]
    pub fn new(
        renderer: &'a Renderer,
        config: &'a TrainConfig,
        dataset: &'a Arc<Dataset>,
        folder: &'a RunFolder,
    ) -> Self {
        Self {
            renderer,
            config,
            dataset,
            folder,
            time_limit: None,
            planned: None,
            command: None,
            stop: &NEVER,
        }
    }

    /// The same run with a limit: it ends after this many seconds of training, as it does after the last step.
    #[must_use]
    pub fn with_time_limit(mut self, seconds: Option<f64>) -> Self {
        self.time_limit = seconds;
        self
    }

    /// The same run in so many seconds: the number of steps is chosen, see [`Session::planned`].
    #[must_use]
    pub fn with_planned(mut self, seconds: Option<f64>) -> Self {
        self.planned = seconds;
        self
    }

    /// The same run with a command line, for the log and the report.
    #[must_use]
    pub fn with_command(mut self, command: Option<String>) -> Self {
        self.command = command;
        self
    }

    /// The same run with a flag. Set it from another thread to save and stop.
    #[must_use]
    pub fn with_stop(mut self, stop: &'a AtomicBool) -> Self {
        self.stop = stop;
        self
    }

    /// Trains to the end; goes on from the folder's checkpoint where `resume`, and from the first step where there is
    /// none yet.
    ///
    /// # Errors
    /// Whatever a step, the files or the device run into; what was saved stays.
    pub fn run(&self, resume: bool, watch: &mut dyn FnMut(Event<'_>)) -> Result<Outcome> {
        self.run_with(resume, watch, &mut StepHooks::new())
    }

    /// Like [`Session::run`]; every step calls `hooks`, see [`Trainer::step_with`].
    ///
    /// # Errors
    /// As [`Session::run`], and those of the hooks.
    pub fn run_with(
        &self,
        resume: bool,
        watch: &mut dyn FnMut(Event<'_>),
        hooks: &mut StepHooks<'_>,
    ) -> Result<Outcome> {
        let begin = Instant::now();
        let path = self.folder.path().join(CHECKPOINT);
        let (config, dataset) = (self.config.clone(), Arc::clone(self.dataset));
        let mut changes = Vec::new();
        let (trainer, progress) = if resume && path.exists() {
            let checkpoint = Checkpoint::load(&path)?;
            changes = self.check_binding(&path, &checkpoint, watch)?;
            let trainer = Trainer::resume(self.renderer, config, dataset, &checkpoint)?;
            (trainer, checkpoint.progress)
        } else {
            (Trainer::start(self.renderer, config, dataset)?, Progress::default())
        };
        // only what can begin leaves anything
        watch(Event::Begin(progress.step));
        let now = |change: &&Change| change.step == u64::from(progress.step);
        let changed: Vec<_> = changes.iter().filter(now).collect();
        changed.iter().for_each(|change| watch(Event::Changed(change)));
        let (log, evaluated, best) = self.open_log(resume, u64::from(progress.step), &changed)?;
        let pictures = Pictures::of_run(self.folder.path());
        pictures.begin(u64::from(progress.step))?;
        let events = self.open_events(resume, u64::from(progress.step))?;
        let _ = self.renderer.device().take_timings();
        State {
            session: self,
            trainer,
            log,
            changes,
            pictures,
            has_begun: false,
            events,
            evaluated,
            seconds: progress.seconds,
            begin,
            planner: self.planned.map(Planner::new),
            best,
            stages: BTreeMap::new(),
            since: (0, progress.seconds),
            watch,
            hooks,
        }
        .run()
    }

    fn open_events(&self, resume: bool, step: u64) -> Result<Option<EventLog>> {
        let folder = self.folder.path();
        let open =
            || if resume { EventLog::resume(folder, step) } else { EventLog::create(folder) };
        self.config.run.tensorboard.then(open).transpose()
    }

    /// Writes the scores of all evaluations as a table. Where there are none, it writes only over a table that there is.
    pub(super) fn save_scores(&self, records: &[Record]) -> Result<()> {
        let path = self.folder.path().join(EVALUATIONS);
        let rows = records.iter().flat_map(|record| match record {
            Record::Evaluation { step, views, .. } => {
                views.iter().map(|view| (Some(*step), view)).collect()
            }
            _ => Vec::new(),
        });
        let rows: Vec<_> = rows.collect();
        if rows.is_empty() && !path.exists() { Ok(()) } else { save_csv(path, &rows) }
    }
}

impl State<'_, '_, '_> {
    fn run(mut self) -> Result<Outcome> {
        let mut saved = None;
        let outcome = loop {
            let step = self.trainer.steps();
            self.plan()?;
            let run = self.trainer.config().run.clone();
            if step >= run.steps {
                break Outcome::Finished;
            }
            if self.session.time_limit.is_some_and(|limit| self.seconds >= limit) {
                break Outcome::TimeLimit;
            }
            if self.session.stop.load(Ordering::Relaxed) {
                break Outcome::Stopped;
            }
            // here, so that whoever was ended between a checkpoint and this makes up for it
            let is_due = run.evaluate_every > 0 && step.is_multiple_of(run.evaluate_every);
            let is_due = is_due && step > 0 && self.evaluated != Some(u64::from(step));
            if is_due && !self.evaluate()? {
                break Outcome::Stopped;
            }
            self.begin()?;
            self.step()?;
            let step = self.trainer.steps();
            if step.is_multiple_of(run.checkpoint_every) {
                self.save(CHECKPOINT)?;
                saved = Some(step);
            }
        };
        if saved != Some(self.trainer.steps()) {
            self.save(CHECKPOINT)?;
        }
        if outcome == Outcome::Stopped || !self.evaluate()? {
            self.report()?;
            return Ok(Outcome::Stopped);
        }
        Ok(outcome)
    }

    /// Where the run has a time and not a number of steps: chooses the number once more, and writes it down.
    fn plan(&mut self) -> Result<()> {
        let Some(planner) = &mut self.planner else { return Ok(()) };
        let (step, gaussians) = (self.trainer.steps(), self.trainer.scene().len());
        let elapsed = self.begin.elapsed().as_secs_f64();
        let now = Now { step, gaussians, training: self.seconds, elapsed };
        if let Some(steps) = planner.plan(self.trainer.config(), now) {
            self.trainer.replan(steps);
            self.trainer.config().save(self.session.folder.path().join(CONFIG))?;
            (self.watch)(Event::Planned(steps));
        }
        Ok(())
    }

    /// Before the first step of this session.
    fn begin(&mut self) -> Result<()> {
        if std::mem::replace(&mut self.has_begun, true) {
            return Ok(());
        }
        let renderer = self.session.renderer;
        let session = SessionInfo::now(self.session.command.clone(), renderer.device().choice());
        let step = u64::from(self.trainer.steps());
        self.log.append(&Record::Session { step, session })?;
        if step > 0 {
            return Ok(());
        }
        // one view, so that a report shows where training began
        if let Some(first) = self.session.dataset.held_out_frames().next() {
            let mut written = Ok(());
            evaluate_with(renderer, self.trainer.scene(), &[first], &mut |event| {
                if let evaluate::Event::View { image, .. } = event {
                    written = self.pictures.write_first(image);
                }
            })?;
            written?;
            let _ = renderer.device().take_timings();
        }
        Ok(())
    }

    /// The rates of the step that was just done.
    fn rates(&self) -> BTreeMap<String, f32> {
        let config = self.trainer.config();
        let at = self.trainer.steps().saturating_sub(1);
        let share = config.run.share(at);
        let rates = config.optimizer.named_rates();
        rates.map(|(name, rate)| (name.to_owned(), rate.at(share) as f32)).collect()
    }

    fn step(&mut self) -> Result<()> {
        let begin = Instant::now();
        let report = self.trainer.step_with(self.hooks)?;
        let seconds = begin.elapsed().as_secs_f64();
        self.seconds += seconds;
        self.add_times(seconds);
        let (step, scene) = (self.trainer.steps(), self.trainer.scene());
        self.since.0 += report.tiles;
        let numbers = (u64::from(step), scene.len() as u64);
        if let Some(grown) = report.grown {
            self.log.append(&Record::Growth {
                step: numbers.0,
                split: u64::from(grown.split),
                cloned: u64::from(grown.cloned),
                pruned: u64::from(grown.pruned),
                gaussians: numbers.1,
            })?;
        }
        if step.is_multiple_of(self.trainer.config().run.log_every) {
            let (tiles, then) = std::mem::replace(&mut self.since, (0, self.seconds));
            self.log.append(&Record::Step {
                step: numbers.0,
                seconds: self.seconds,
                loss: report.loss,
                l1: report.l1,
                ssim: report.ssim,
                psnr: report.psnr,
                tiles_per_second: tiles as f64 / (self.seconds - then).max(1e-9),
                gaussians: numbers.1,
                rates: self.rates(),
            })?;
            if let Some(events) = &mut self.events {
                log_step(events, step, self.trainer.config(), &report, scene.len())?;
            }
        }
        let seconds = self.seconds;
        (self.watch)(Event::Step { step, seconds, report: &report, scene });
        Ok(())
    }

    /// Writes an evaluation for TensorBoard: scores, and pictures of the first views.
    fn log_evaluation_events(
        &mut self,
        frames: &[&Frame],
        evaluation: &Evaluation,
        images: &[Image],
        is_first: bool,
    ) -> Result<()> {
        let Some(events) = &mut self.events else { return Ok(()) };
        let step = u64::from(self.trainer.steps());
        let mean = evaluation.mean;
        let scores = [("psnr", mean.psnr), ("ssim", mean.ssim)];
        events.scalars(step, scores.map(|(tag, score)| (format!("held_out/{tag}"), score)))?;
        for (frame, rendered) in frames.iter().zip(images) {
            events.picture(step, format!("{}/rendered", frame.name), rendered)?;
            if is_first {
                let photograph = Image::of_pixels(rendered.size(), frame.image.pixels());
                events.picture(step, format!("{}/photograph", frame.name), &photograph)?;
            }
        }
        Ok(())
    }

    /// What a step's kernels took, and what remains of it.
    fn add_times(&mut self, seconds: f64) {
        let mut rest = seconds;
        for time in self.session.renderer.device().take_timings() {
            *self.stages.entry(time.kernel).or_default() += time.seconds;
            rest -= time.seconds;
        }
        *self.stages.entry("beside the kernels").or_default() += rest.max(0.0);
    }

    fn save(&self, name: &str) -> Result<()> {
        let Session { dataset, folder, .. } = self.session;
        let config = self.trainer.config();
        let binding = Binding::new(config, &dataset.fingerprint, self.changes.clone());
        let path = folder.path().join(name);
        self.trainer.checkpoint(self.seconds)?.save(path, Some(&binding))
    }

    /// Measures the held-out views; false where it was told to stop before the last.
    fn evaluate(&mut self) -> Result<bool> {
        let frames: Vec<_> = self.session.dataset.held_out_frames().collect();
        if frames.is_empty() {
            return self.report().map(|()| true);
        }
        (self.watch)(Event::Evaluating);
        let begin = Instant::now();
        let step = u64::from(self.trainer.steps());
        let (renderer, scene) = (self.session.renderer, self.trainer.scene());
        let (mut parts, mut images) = (Vec::with_capacity(frames.len()), Vec::new());
        for (index, frame) in frames.iter().enumerate() {
            if self.session.stop.load(Ordering::Relaxed) {
                return Ok(false);
            }
            let mut written = Ok(());
            let mut write = |event: evaluate::Event<'_>| {
                if let evaluate::Event::View { image, .. } = event {
                    written = self.pictures.write(index, step, &frame.image, image);
                    if self.events.is_some() && index < MAX_VIEWS {
                        images.push(image.clone());
                    }
                }
            };
            parts.push(evaluate_with(renderer, scene, &[frame], &mut write)?);
            written?;
        }
        let evaluation = Evaluation::of_parts(parts);
        // before the log says so: who is killed in between makes up for both
        if let Some(psnr) = evaluation.mean.psnr
            && self.best.is_none_or(|best| psnr > best)
        {
            self.best = Some(psnr);
            self.save(BEST)?;
        }
        let before = self.evaluated.replace(step);
        if before != Some(step) {
            self.log.append(&Record::evaluation(step, self.seconds, &evaluation))?;
            self.log_evaluation_events(&frames, &evaluation, &images, before.is_none())?;
            let records = MetricsLog::read(self.session.folder.path().join(METRICS))?;
            self.session.save_scores(&records)?;
        }
        self.pictures.keep(step);
        (self.watch)(Event::Evaluated(&evaluation));
        if let Some(planner) = &mut self.planner {
            planner.evaluated(begin.elapsed().as_secs_f64());
        }
        // what evaluating took is no part of training
        let _ = renderer.device().take_timings();
        self.report().map(|()| true)
    }

    fn report(&mut self) -> Result<()> {
        self.timing()?;
        let folder = self.session.folder.path();
        write_report(folder.join(REPORT), &Run::load(folder)?)
    }

    /// Where the time of this session went, the longest first.
    fn timing(&mut self) -> Result<()> {
        if self.stages.is_empty() {
            return Ok(());
        }
        let all: f64 = self.stages.values().sum();
        let row = |(stage, seconds): (&&str, &f64)| TimingRow {
            stage: (*stage).to_owned(),
            seconds: *seconds,
            share: seconds / all.max(1e-9),
        };
        let mut rows: Vec<_> = self.stages.iter().map(row).collect();
        rows.sort_by(|a, b| b.seconds.total_cmp(&a.seconds));
        self.log.append(&Record::Timing { step: u64::from(self.trainer.steps()), rows })
    }
}

/// Writes a step for TensorBoard. Learning rates are those of the step that is done, as the settings have them.
fn log_step(
    events: &mut EventLog,
    step: u32,
    config: &TrainConfig,
    report: &StepReport,
    gaussians: usize,
) -> Result<()> {
    let numbers = [("loss", report.loss), ("psnr", report.psnr), ("gaussians", gaussians as f64)];
    let numbers = numbers.map(|(tag, value)| (format!("train/{tag}"), Some(value)));
    let rates = config.optimizer.named_rates().map(|(name, rate)| {
        (format!("learning_rate/{name}"), Some(rate.at(config.run.share(step - 1))))
    });
    events.scalars(u64::from(step), numbers.into_iter().chain(rates))
}
