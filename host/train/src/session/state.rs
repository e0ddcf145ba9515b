//! The loop of a run: its steps, and the logging, saving and measuring between them.

use std::collections::BTreeMap;
use std::sync::atomic::Ordering;
use std::time::{Duration, Instant};

use super::first_steps::{FirstSteps, SEEN_AFTER};
use crate::held_out;
use crate::metrics::{MetricsLog, Record, SessionInfo, TimingRow};
use crate::ranks::{Order, tell};
use crate::schedule::{Now, Scheduler};
use crate::{
    BEST, Binding, CAMERAS, CHECKPOINT, CONFIG, Change, Evaluation, Event, METRICS, Outcome,
    Session, StepReport, Trainer, Watch,
};
use organza_core::{Camera, Result};
use organza_render::OwnLoss;

/// A run has a first checkpoint after this time, if not before.
const FIRST_CHECKPOINT: Duration = Duration::from_secs(30);

/// State that changes while a run goes on.
pub(super) struct SessionState<'a, 'w, 'h> {
    pub session: &'a Session<'a>,
    pub trainer: Trainer,
    pub log: MetricsLog,
    /// Changed settings, in this resume and in earlier ones.
    pub changes: Vec<Change>,
    /// Whether this session has taken a step. A session without a step leaves no record.
    pub has_begun: bool,
    /// The log's last evaluation: its step, and its number of views.
    pub evaluated: Option<(u64, usize)>,
    pub seconds: f64,
    /// When this session began.
    pub begin: Instant,
    pub scheduler: Option<Scheduler>,
    /// PSNR of the best checkpoint, over the views that all evaluations measure.
    pub best: Option<f64>,
    /// Seconds of each kernel and of other stages.
    pub stages: BTreeMap<&'static str, f64>,
    /// Tiles since the last logged line, and the seconds at that time.
    pub since: (usize, f64),
    pub first_steps: FirstSteps,
    pub watch: &'w mut Watch<'w>,
    pub own: Option<&'w mut OwnLoss<'h>>,
}

impl SessionState<'_, '_, '_> {
    /// Trains to the end.
    pub fn run(mut self) -> Result<Outcome> {
        let mut saved = None;
        let mut has_checkpoint = self.trainer.steps() > 0;
        let outcome = loop {
            let step = self.trainer.steps();
            self.schedule()?;
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
            // here, so that a resume catches up if the run was killed between a checkpoint and this
            let is_due = run.evaluate_every > 0 && step.is_multiple_of(run.evaluate_every);
            let evaluated = self.evaluated.is_some_and(|(at, _)| at == u64::from(step));
            let is_due = is_due && step > 0 && !evaluated;
            if is_due {
                self.finish_steps()?;
                if !self.evaluate(false)? {
                    break Outcome::Stopped;
                }
            }
            self.begin()?;
            self.order(Order::Step(run.steps))?;
            self.step()?;
            let step = self.trainer.steps();
            // an early one, so that `view`, `film` and others can look at a run that has just begun
            let is_first = !has_checkpoint && self.begin.elapsed() >= FIRST_CHECKPOINT;
            if is_first || step.is_multiple_of(run.checkpoint_every) {
                self.finish_steps()?;
                self.save(CHECKPOINT)?;
                saved = Some(step);
                has_checkpoint = true;
            }
        };
        self.finish_steps()?;
        if saved != Some(self.trainer.steps()) {
            self.save(CHECKPOINT)?;
        }
        if outcome == Outcome::Stopped || !self.evaluate(true)? {
            self.complete()?;
            self.order(Order::End)?;
            return Ok(Outcome::Stopped);
        }
        self.order(Order::End)?;
        Ok(outcome)
    }

    /// Sends the other ranks what comes next.
    fn order(&self, order: Order) -> Result<()> {
        self.session.ranks.as_deref().map_or(Ok(()), |ranks| tell(ranks, &order))
    }

    /// In a run with a time to end at, updates the number of steps and writes it to the settings.
    fn schedule(&mut self) -> Result<()> {
        let Some(scheduler) = &mut self.scheduler else { return Ok(()) };
        let step = self.trainer.finished();
        let gaussians = self.trainer.scene().len();
        let elapsed = self.begin.elapsed().as_secs_f64();
        let now = Now { step, gaussians, training: self.seconds, elapsed };
        if let Some(steps) = scheduler.schedule(self.trainer.config(), now) {
            self.trainer.reschedule(steps);
            self.trainer.config().save(self.session.folder.path().join(CONFIG))?;
            (self.watch)(Event::Scheduled(steps))?;
        }
        Ok(())
    }

    /// Writes the records that belong before the first step of this session.
    fn begin(&mut self) -> Result<()> {
        if std::mem::replace(&mut self.has_begun, true) {
            return Ok(());
        }
        let renderer = self.session.renderer;
        let mut device = renderer.device().choice().to_owned();
        if let Some(ranks) = &self.session.ranks {
            device += &format!(", rank 0 of {}", ranks.size());
        }
        let session = SessionInfo::now(self.session.command.clone(), &device);
        let step = u64::from(self.trainer.steps());
        self.log.append(&Record::Session { step, session })?;
        if step > 0 {
            return Ok(());
        }
        // a single view, so that a report shows the start of training
        let frames: Vec<_> = self.session.dataset.held_out_frames().take(1).collect();
        if !frames.is_empty() {
            let begin = Instant::now();
            let (_, image) = self.trainer.measure_one(frames[0])?;
            (self.watch)(Event::FirstView(&image))?;
            if let Some(scheduler) = &mut self.scheduler {
                scheduler.evaluated(begin.elapsed().as_secs_f64(), frames.len());
            }
            let _ = renderer.device().take_timings();
        }
        Ok(())
    }

    /// The learning rates of a step, of what is learned; `step` counts from 1.
    fn rates(&self, step: u32) -> BTreeMap<String, f32> {
        let config = self.trainer.config();
        let fraction = config.run.fraction(step - 1);
        let optimizer = &config.optimizer;
        let is_learned = |name: &str| match name {
            "exposure" => self.trainer.fits_colors(),
            "pose" => config.poses.refine,
            _ => true,
        };
        let rates = config.optimizer.named_rates();
        rates
            .filter(|(name, _)| is_learned(name))
            .map(|(name, rate)| (name.to_owned(), optimizer.rate_at(rate, fraction) as f32))
            .collect()
    }

    fn step(&mut self) -> Result<()> {
        let begin = Instant::now();
        let mut reports = self.trainer.advance(self.own.as_deref_mut(), self.session.ahead)?;
        if self.trainer.steps() == SEEN_AFTER {
            reports.extend(self.trainer.finish_steps()?);
        }
        self.report(begin, reports)
    }

    /// Waits for the queued steps, before the scene is read.
    fn finish_steps(&mut self) -> Result<()> {
        let begin = Instant::now();
        let reports = self.trainer.finish_steps()?;
        // a run without a step keeps its time
        if reports.is_empty() { Ok(()) } else { self.report(begin, reports) }
    }

    /// Adds the time since `begin`, and reports steps.
    fn report(&mut self, begin: Instant, reports: Vec<StepReport>) -> Result<()> {
        let seconds = begin.elapsed().as_secs_f64();
        self.seconds += seconds;
        self.add_times(seconds);
        reports.iter().try_for_each(|report| self.report_step(report))
    }

    fn report_step(&mut self, report: &StepReport) -> Result<()> {
        let StepReport { step, gaussians, .. } = *report;
        self.since.0 += report.tiles;
        let numbers = (u64::from(step), gaussians as u64);
        if let Some(densified) = report.densified {
            self.log.append(&Record::Densification {
                step: numbers.0,
                split: u64::from(densified.split),
                pruned: u64::from(densified.pruned),
                gaussians: numbers.1,
            })?;
        }
        if step.is_multiple_of(self.trainer.config().run.log_every) {
            let (tiles, then) = std::mem::replace(&mut self.since, (0, self.seconds));
            let rates = self.rates(step);
            self.log.append(&Record::Step {
                step: numbers.0,
                seconds: self.seconds,
                loss: report.loss,
                l1: report.l1,
                ssim: report.ssim,
                psnr: report.psnr,
                tiles_per_second: tiles as f64 / (self.seconds - then).max(1e-9),
                gaussians: numbers.1,
                rates,
            })?;
        }
        if let Some(warning) = self.first_steps.judge(report, &self.trainer)? {
            (self.watch)(Event::Warning(&warning))?;
        }
        let seconds = self.seconds;
        let scene = self.trainer.scene();
        (self.watch)(Event::Step { step, seconds, report, gaussians, scene })
    }

    /// Adds the times of a step's kernels, and the rest of the step's time.
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
        let folder = folder.path();
        let binding = Binding::new(config, &dataset.fingerprint, self.changes.clone(), folder);
        let path = folder.join(name);
        self.trainer.checkpoint(self.seconds)?.save(&path, Some(&binding))?;
        if name == CHECKPOINT { self.save_cameras() } else { Ok(()) }
    }

    /// If poses are refined, writes all cameras of the data set. Held-out cameras keep their given pose.
    fn save_cameras(&self) -> Result<()> {
        let Some(refined) = self.trainer.refined_cameras() else { return Ok(()) };
        let Session { dataset, folder, .. } = self.session;
        let given = dataset.frames.iter().zip(&dataset.poses).map(|(frame, &camera_to_world)| {
            let file_path = Some(frame.name.clone());
            Camera { camera_to_world, file_path, ..frame.camera.clone() }
        });
        let mut cameras: Vec<_> = given.collect();
        for (&frame, camera) in dataset.train.iter().zip(refined) {
            cameras[frame].camera_to_world = dataset.placement.world_camera(camera).camera_to_world;
        }
        Camera::save_all(folder.path().join(CAMERAS), &cameras)
    }

    /// Measures the held-out views: all of them, or an intermediate evaluation's. Returns false if the run was
    /// stopped before the last view.
    fn evaluate(&mut self, all: bool) -> Result<bool> {
        let views = self.trainer.config().run.evaluate_views;
        let dataset = self.session.dataset;
        let count = dataset.held_out.len();
        let frames = held_out::frames(dataset, views, all);
        if frames.is_empty() {
            return self.complete().map(|()| true);
        }
        (self.watch)(Event::Evaluating)?;
        let begin = Instant::now();
        let step = u64::from(self.trainer.steps());
        let mut parts = Vec::with_capacity(frames.len());
        for first in (0..frames.len()).step_by(self.trainer.views_at_once()) {
            if self.session.stop.load(Ordering::Relaxed) {
                return Ok(false);
            }
            self.order(Order::Evaluate { first, all })?;
            let found = self.trainer.measure(&frames, first)?;
            for (index, (part, image)) in (first..).zip(found) {
                let frame = frames[index];
                (self.watch)(Event::View { index, step, frame, image: &image })?;
                parts.push(part);
            }
        }
        let evaluation = Evaluation::join(parts);
        // written before the log entry: if the run is killed in between, a resume makes both again
        if let Some(psnr) = held_out::comparable(&evaluation.views, count, views)
            && self.best.is_none_or(|best| psnr > best)
        {
            self.best = Some(psnr);
            self.save(BEST)?;
        }
        let before = self.evaluated.replace((step, frames.len()));
        if before.is_none_or(|(at, views)| at != step || views < frames.len()) {
            self.log.append(&Record::evaluation(step, self.seconds, &evaluation))?;
        }
        (self.watch)(Event::Evaluated(&evaluation))?;
        if let Some(scheduler) = &mut self.scheduler {
            scheduler.evaluated(begin.elapsed().as_secs_f64(), frames.len());
        }
        // the time of an evaluation is not part of training
        let _ = self.session.renderer.device().take_timings();
        self.complete().map(|()| true)
    }

    /// Completes the log and the table of scores.
    fn complete(&mut self) -> Result<()> {
        self.timing()?;
        let records = MetricsLog::read(self.session.folder.path().join(METRICS))?;
        self.session.save_scores(&records)?;
        (self.watch)(Event::Complete)
    }

    /// Logs the time of each stage in this session, longest first.
    fn timing(&mut self) -> Result<()> {
        // kernels are not timed on a GPU
        if self.stages.len() < 2 {
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
