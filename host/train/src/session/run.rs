//! How a run begins, what it says if its first steps show or learn nothing, and what it leaves beside its checkpoints.

use std::collections::BTreeMap;
use std::sync::Arc;
use std::time::Instant;

use super::state::SessionState;
use crate::evaluate::save_csv;
use crate::folder::{CHECKPOINT, EVALUATIONS, OpenLog};
use crate::metrics::Record;
use crate::ranks;
use crate::schedule::Scheduler;
use crate::start::first_scene;
use crate::{Change, Checkpoint, Event, Outcome, Progress, Session, StepReport, Trainer, Watch};
use organza_core::camera::Camera;
use organza_core::error::{self, Result};
use organza_core::scene::Scene;
use organza_render::OwnLoss;

/// A trainer, the progress of its run, and the settings that have changed.
type Begun = (Trainer, Progress, Vec<Change>);

impl Session<'_> {
    /// Trains to the end, and calls `watch` with what happens. With `resume`, it continues from the folder's checkpoint,
    /// or starts at the first step if there is none.
    ///
    /// # Errors
    /// Any error of a step, of the files, of the device or of `watch`. What was saved stays.
    pub fn run(&self, resume: bool, watch: &mut Watch<'_>) -> Result<Outcome> {
        self.run_with(resume, watch, None)
    }

    /// Like [`Session::run`], with a caller's own loss in every step: see [`Trainer::step_with`].
    ///
    /// # Errors
    /// The errors of [`Session::run`] and of the loss.
    pub fn run_with(
        &self,
        resume: bool,
        watch: &mut Watch<'_>,
        own: Option<&mut OwnLoss<'_>>,
    ) -> Result<Outcome> {
        let mut config = self.config.clone();
        config.choose(self.dataset, self.renderer.device());
        let command = self.command.clone();
        let session = Session { config: &config, command, ranks: self.ranks.clone(), ..*self };
        let outcome = session.run_alone_or_first(resume, watch, own);
        if let (Some(ranks), Err(error)) = (&self.ranks, &outcome) {
            ranks.fail(&error::chain(error));
        }
        outcome
    }

    fn run_alone_or_first(
        &self,
        resume: bool,
        watch: &mut Watch<'_>,
        own: Option<&mut OwnLoss<'_>>,
    ) -> Result<Outcome> {
        let begin = Instant::now();
        let (trainer, progress, changes) = self.begin(resume, watch, own.is_some())?;
        // a run that cannot begin writes nothing
        watch(Event::Begin(progress.step))?;
        let now = |change: &&Change| change.step == u64::from(progress.step);
        let changed: Vec<_> = changes.iter().filter(now).collect();
        changed.iter().try_for_each(|change| watch(Event::Changed(change)))?;
        let step = u64::from(progress.step);
        let OpenLog { log, evaluated, best } = self.open_log(resume, step, &changed)?;
        watch(Event::Opened { step, resume })?;
        let _ = self.renderer.device().take_timings();
        SessionState {
            session: self,
            trainer,
            log,
            changes,
            has_begun: false,
            evaluated,
            seconds: progress.seconds,
            begin,
            scheduler: self
                .scheduled
                .map(|seconds| Scheduler::new(seconds, self.dataset.held_out.len())),
            best,
            stages: BTreeMap::new(),
            since: (0, progress.seconds),
            first_steps: FirstSteps::default(),
            watch,
            own,
        }
        .run()
    }

    /// The trainer, the progress of its run, and the settings that have changed.
    fn begin(&self, resume: bool, watch: &mut Watch<'_>, has_own_loss: bool) -> Result<Begun> {
        let path = self.folder.path().join(CHECKPOINT);
        let resumes = resume && path.exists();
        let checkpoint = if resumes {
            Checkpoint::load(&path)?
        } else {
            let scene = first_scene(self.config, self.dataset, watch)?;
            Checkpoint::begin(scene, self.config)?
        };
        let progress = checkpoint.progress;
        let mut changes = Vec::new();
        if resumes {
            let found = (checkpoint.scene.gaussians.len(), progress.step);
            changes = self.check_binding(&path, found, watch)?;
        }
        let config = self.config.clone();
        let dataset = Arc::clone(self.dataset);
        if let Some(ranks) = &self.ranks {
            let run = (self.config, &**self.dataset);
            ranks::lead(&**ranks, self.renderer, run, &checkpoint, has_own_loss, self.mixed)?;
        }
        let mut trainer = Trainer::resume(self.renderer, config, dataset, &checkpoint)?;
        if let Some(ranks) = &self.ranks {
            trainer = trainer.with_ranks(ranks.clone());
        }
        Ok((trainer, progress, changes))
    }

    /// Writes the scores of all evaluations as a table. Without evaluations, it only overwrites an existing table.
    pub(crate) fn save_scores(&self, records: &[Record]) -> Result<()> {
        let path = self.folder.path().join(EVALUATIONS);
        let rows = records.iter().flat_map(|record| match record {
            Record::Evaluation { step, views, .. } => {
                views.iter().map(|view| (*step, view)).collect()
            }
            _ => Vec::new(),
        });
        let rows: Vec<_> = rows.collect();
        if rows.is_empty() && !path.exists() { Ok(()) } else { save_csv(path, &rows) }
    }
}

/// Steps after which some Gaussian must have been in a tile.
pub(super) const SEEN_AFTER: u32 = 10;
/// Steps after which the loss must have moved, and number of steps at each end whose mean is compared.
const MOVED_AFTER: u32 = 200;
const ENDS: u32 = 50;
/// Least part of the loss that must be gone by then. Tiles differ, so a loss that stands still moves a little, too.
const MIN_GAIN: f64 = 0.03;

/// The mean losses of the first steps of a new run, and of the last ones before it is judged.
#[derive(Debug, Default)]
pub(super) struct FirstSteps([f64; 2]);

impl SessionState<'_, '_, '_> {
    /// Judges a new run by the steps so far.
    pub(super) fn judge(&mut self, report: &StepReport) -> Result<()> {
        let step = report.step;
        // the other part of the loss depends on how coarse images are
        let loss = if report.l1.is_finite() { report.l1 } else { report.loss };
        if step <= ENDS {
            self.first_steps.0[0] += loss / f64::from(ENDS);
        } else if (MOVED_AFTER - ENDS + 1..=MOVED_AFTER).contains(&step) {
            self.first_steps.0[1] += loss / f64::from(ENDS);
        }
        // Gaussians that another program has made may be as good as they can be
        let is_new = self.trainer.config().start.path.is_none();
        let reason = match step {
            // densification forgets what was seen
            SEEN_AFTER if report.densified.is_none() && self.trainer.seen()? == 0 => {
                format!("the first {SEEN_AFTER} steps have shown no Gaussian")
            }
            MOVED_AFTER if is_new => {
                let [first, last] = self.first_steps.0;
                // also false if the run was resumed meanwhile, and the first losses are unknown
                if first == 0.0 || last < (1.0 - MIN_GAIN) * first {
                    return Ok(());
                }
                format!(
                    "the loss has not moved in {step} steps: the mean difference from the photographs was {first:.4}, \
                     and is {last:.4}"
                )
            }
            _ => return Ok(()),
        };
        let looked_at = self.looked_at()?;
        (self.watch)(Event::Warning(&format!("{reason}; {looked_at}")))
    }

    /// The facts that explain an empty image.
    fn looked_at(&self) -> Result<String> {
        let cameras = self.trainer.cameras();
        let dataset = self.session.dataset;
        let device = self.session.renderer.device();
        let Scene { gaussians, config, .. } = self.trainer.scene().download(device)?;
        let in_image = |place: &&[f32; 3]| {
            let place = place.map(f64::from);
            cameras.iter().any(|camera| camera.depth_in_image(place).is_some())
        };
        let inside = gaussians.position.iter().filter(in_image).count();
        let all = gaussians.len();
        let box_of = |places: &mut dyn Iterator<Item = [f64; 3]>| {
            let ends = places.fold([[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]], |ends, place| {
                let [low, high] = ends;
                let low = std::array::from_fn(|axis| low[axis].min(place[axis]));
                let high = std::array::from_fn(|axis| high[axis].max(place[axis]));
                [low, high]
            });
            let shown = |corner: [f64; 3]| corner.map(|x| format!("{x:.3}")).join(",");
            let [low, high] = ends.map(shown);
            format!("{low} to {high}")
        };
        let world = |place: [f64; 3]| config.placement.world(place);
        let mut places = gaussians.position.iter().map(|place| world(place.map(f64::from)));
        let mut eyes = cameras.iter().map(Camera::eye).map(world);
        let places = box_of(&mut places);
        let eyes = box_of(&mut eyes);
        let mut text = format!(
            "{inside} of {all} Gaussians are in the image of some photograph; they lie at {places}, and the cameras at {eyes}"
        );
        if let Some(file) = &dataset.points_file {
            text += &format!("; the points of {} may belong to other cameras", file.display());
        }
        Ok(text)
    }
}
