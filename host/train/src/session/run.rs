//! A run: it begins, takes its steps, and tells other ranks if it fails.

use std::collections::BTreeMap;
use std::sync::Arc;
use std::time::Instant;

use super::first_steps::FirstSteps;
use super::open::OpenLog;
use super::state::SessionState;
use crate::ranks;
use crate::schedule::Scheduler;
use crate::start::first_scene;
use crate::{CHECKPOINT, Change, Checkpoint, Event, Outcome, Progress, Session, Trainer, Watch};
use organza_core::error::{self, Result};
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
        config.resolve_sizes(self.dataset, self.renderer.device());
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
        watch(Event::Opened(step))?;
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
            let (scene, notes) = first_scene(self.config, self.dataset)?;
            notes.iter().try_for_each(|note| watch(note.into()))?;
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
}
