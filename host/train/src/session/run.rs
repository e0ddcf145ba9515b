//! How a run begins, and what it leaves beside its checkpoints.

use std::collections::BTreeMap;
use std::sync::Arc;
use std::time::Instant;

use super::first_steps::FirstSteps;
use super::state::SessionState;
use super::{Event, Outcome, Session, Watch};
use crate::binding::Change;
use crate::checkpoint::Checkpoint;
use crate::evaluate::csv::save_csv;
use crate::folder::{CHECKPOINT, EVALUATIONS};
use crate::hooks::StepHooks;
use crate::metrics::Record;
use crate::plan::Planner;
use crate::progress::Progress;
use crate::ranks::{self, Team};
use crate::resume::OpenLog;
use crate::start::first_scene_with;
use crate::trainer::Trainer;
use organza_core::error::{self, Result};
use organza_core::scene::SceneShard;

/// A trainer, the progress of its run, and the settings that have changed.
type Begun = (Trainer, Progress, Vec<Change>);

impl Session<'_> {
    /// Trains to the end, and calls `watch` with what happens. With `resume`, it continues from the folder's checkpoint,
    /// or starts at the first step if there is none.
    ///
    /// # Errors
    /// Any error of a step, of the files, of the device or of `watch`. What was saved stays.
    pub fn run(&self, resume: bool, watch: &mut Watch<'_>) -> Result<Outcome> {
        self.run_with(resume, watch, &mut StepHooks::new())
    }

    /// Like [`Session::run`], but every step calls `hooks`: see [`Trainer::step_with`].
    ///
    /// # Errors
    /// The same errors as [`Session::run`], and those of the hooks.
    pub fn run_with(
        &self,
        resume: bool,
        watch: &mut Watch<'_>,
        hooks: &mut StepHooks<'_>,
    ) -> Result<Outcome> {
        let outcome = self.run_alone_or_first(resume, watch, hooks);
        if let (Some(ranks), Err(error)) = (&self.ranks, &outcome) {
            ranks.fail(&error::chain(error));
        }
        outcome
    }

    fn run_alone_or_first(
        &self,
        resume: bool,
        watch: &mut Watch<'_>,
        hooks: &mut StepHooks<'_>,
    ) -> Result<Outcome> {
        let begin = Instant::now();
        let (trainer, progress, changes) = self.begin(resume, watch)?;
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
            planner: self.planned.map(|seconds| Planner::new(seconds, self.dataset.held_out.len())),
            best,
            stages: BTreeMap::new(),
            since: (0, progress.seconds),
            first_steps: FirstSteps::default(),
            watch,
            hooks,
        }
        .run()
    }

    /// The trainer, the progress of its run, and the settings that have changed.
    fn begin(&self, resume: bool, watch: &mut Watch<'_>) -> Result<Begun> {
        let team = self.ranks.clone().map(|ranks| Team::new(self.config, ranks, self.shards));
        let team = team.transpose()?;
        let shards = team.as_ref().map_or(1, |team| team.grid().shards);
        let path = self.folder.path().join(CHECKPOINT);
        let resumes = resume && path.exists();
        let scene = match resumes {
            true => None,
            false => {
                let mut warn = |text: &str| watch(Event::Warning(text));
                Some(first_scene_with(self.config, self.dataset, &mut warn)?)
            }
        };
        let shard = |index: usize| match &scene {
            Some(scene) => {
                let shard = SceneShard::new(scene, index, shards);
                Checkpoint::begin_shard(shard, self.config)
            }
            None => Checkpoint::load_shard(&path, index, shards),
        };
        let mut mine = shard(0)?;
        let progress = mine.progress;
        let mut changes = Vec::new();
        if resumes {
            changes = self.check_binding(&path, (mine.gaussians, progress.step), watch)?;
        }
        let config = self.config.clone();
        let dataset = Arc::clone(self.dataset);
        if let Some(team) = &team {
            let run = (self.config, &**self.dataset);
            ranks::lead(team, self.renderer, run, &mut mine, shard, self.mixed)?;
        }
        drop(scene);
        let trainer = Trainer::with_team(self.renderer, config, dataset, &mine, team)?;
        Ok((trainer, progress, changes))
    }

    /// Writes the scores of all evaluations as a table. Without evaluations, it only overwrites an existing table.
    pub(crate) fn save_scores(&self, records: &[Record]) -> Result<()> {
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
