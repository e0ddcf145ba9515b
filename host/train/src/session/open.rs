//! Opens a run in its folder: checks that it may continue there, and its settings, log and scores.

use std::path::Path;

use crate::evaluate::save_csv;
use crate::folder::EVALUATIONS;
use crate::held_out;
use crate::metrics::{MetricsLog, Record};
use crate::{Binding, CONFIG, Change, Event, METRICS, Session, TrainConfig, Watch};
use organza_core::{Error, Result};

/// The open log of a run that begins or continues.
pub(super) struct OpenLog {
    pub log: MetricsLog,
    /// The last evaluation: its step, and its number of views.
    pub evaluated: Option<(u64, usize)>,
    /// The PSNR of the best evaluation.
    pub best: Option<f64>,
}

impl Session<'_> {
    /// Compares the settings and the data with the checkpoint's. Returns the settings that changed, in this resume and in
    /// earlier ones.
    pub(super) fn check_binding(
        &self,
        path: &Path,
        (gaussians, step): (usize, u32),
        watch: &mut Watch<'_>,
    ) -> Result<Vec<Change>> {
        let max = self.config.densification.max_gaussians;
        if gaussians as u64 > u64::from(max) {
            let reason = format!(
                "`densification.max_gaussians` is {max}, but the scene already has {gaussians} Gaussians"
            );
            return Err(Error::Invalid { origin: self.folder.path().join(CONFIG), reason });
        }
        let binding = Binding::load(path)?;
        if let Some(version) = binding.other_version() {
            watch(Event::Warning(&version))?;
        }
        let changed = binding.check_settings(self.config, step, self.folder.path())?;
        binding.check_data(&self.dataset.fingerprint, &self.dataset.path)?;
        Ok([binding.changes(), &changed].concat())
    }

    /// Opens the log. Writes the settings, and records the ones that `changed` in this resume.
    pub(super) fn open_log(&self, resume: bool, step: u64, changed: &[&Change]) -> Result<OpenLog> {
        let path = self.folder.path().join(METRICS);
        if !resume {
            self.config.save(self.folder.path().join(CONFIG))?;
            let log = MetricsLog::create(path)?;
            return Ok(OpenLog { log, evaluated: None, best: None });
        }
        let mut log = MetricsLog::resume(&path, step)?;
        let config = self.folder.path().join(CONFIG);
        if TrainConfig::load(&config)? != *self.config {
            self.config.save(config)?;
        }
        for change in changed {
            log.append(&Record::Change((*change).clone()))?;
        }
        let records = MetricsLog::read(path)?;
        self.save_scores(&records)?;
        let count = self.dataset.held_out.len();
        let measured = self.config.run.evaluate_views;
        let mut evaluated = None;
        let mut best = None::<f64>;
        for record in &records {
            if let Record::Evaluation { step, views, .. } = record {
                evaluated = Some((*step, views.len()));
                let psnr = held_out::comparable(views, count, measured);
                best = psnr.into_iter().chain(best).reduce(f64::max);
            }
        }
        Ok(OpenLog { log, evaluated, best })
    }

    /// Writes the scores of all evaluations as a table. Without evaluations, it only overwrites an existing table.
    pub(super) fn save_scores(&self, records: &[Record]) -> Result<()> {
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
