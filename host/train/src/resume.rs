//! Checks a session against the checkpoint that it continues, and writes its records before the first step.

use std::path::Path;

use super::binding::{Binding, Change};
use super::config::TrainConfig;
use super::folder::{CONFIG, METRICS};
use super::held_out;
use super::metrics::{MetricsLog, Record};
use super::session::{Event, Session, Watch};
use organza_core::error::{Error, Result};

/// The open log of a run that begins or continues.
pub(super) struct OpenLog {
    pub log: MetricsLog,
    /// The last evaluation: its step, and its number of views.
    pub evaluated: Option<(u64, usize)>,
    /// The PSNR of the best evaluation.
    pub best: Option<f64>,
}

impl Session<'_> {
    /// Compares the settings and the data with those of the checkpoint. Returns the settings that changed, in this
    /// resume and in earlier ones.
    pub(super) fn check_binding(
        &self,
        path: &Path,
        (gaussians, step): (usize, u32),
        watch: &mut Watch<'_>,
    ) -> Result<Vec<Change>> {
        let most = self.config.growth.max_gaussians;
        if gaussians as u64 > u64::from(most) {
            let reason = format!(
                "`growth.max_gaussians` is {most}, but the scene already has {gaussians} Gaussians"
            );
            return Err(Error::Invalid { origin: self.folder.path().join(CONFIG), reason });
        }
        let Some(binding) = Binding::load(path)? else {
            watch(Event::Warning(
                "the checkpoint does not say which settings and data it belongs to, as an older \
                 program wrote it: those of the run's folder are taken as they are",
            ))?;
            return Ok(Vec::new());
        };
        let changed = binding.check_settings(self.config, step, self.folder.path())?;
        binding.check_data(&self.dataset.fingerprint, &self.dataset.path)?;
        Ok([binding.changes(), &changed].concat())
    }

    /// Opens the log. Writes the settings, and records those that `changed` in this resume.
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
}
