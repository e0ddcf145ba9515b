//! A run as read from its folder.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use serde::Serialize;

use super::pictures::Pictures;
use organza_core::error::Result;
use organza_train::evaluate::{Score, ViewScore};
use organza_train::metrics::{MetricsLog, Record, SessionInfo, TimingRow};
use organza_train::{CONFIG, Change, METRICS, TrainConfig};

/// The files of a run that pages are made from: settings, log and pictures.
#[derive(Debug)]
pub struct Run {
    pub(super) folder: PathBuf,
    pub(super) config: TrainConfig,
    pub(super) records: Vec<Record>,
    pub(super) pictures: Pictures,
}

/// The progress of a run, at its last evaluation or else at its last logged step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Summary {
    /// Means of the held-out views.
    #[serde(flatten)]
    pub mean: Score,
    /// Number of steps at that time.
    pub step: u64,
    /// Seconds of training at that time.
    pub seconds: f64,
    /// Number of Gaussians at that time.
    pub gaussians: Option<u64>,
    /// Median of the logged speeds.
    pub tiles_per_second: Option<f64>,
}

impl Run {
    /// Reads a run's folder.
    ///
    /// # Errors
    /// [`Error::ReadFile`](organza_core::Error::ReadFile) and [`Error::Invalid`](organza_core::Error::Invalid), like
    /// [`TrainConfig::load`] and [`MetricsLog::read`].
    pub fn load(folder: impl AsRef<Path>) -> Result<Self> {
        let folder = folder.as_ref();
        Ok(Self {
            config: TrainConfig::load(folder.join(CONFIG))?,
            records: MetricsLog::read(folder.join(METRICS))?,
            pictures: Pictures::from_run(folder),
            folder: folder.to_owned(),
        })
    }

    /// The progress of the run.
    pub fn summary(&self) -> Summary {
        let last = |is: fn(&Record) -> bool| self.records.iter().rfind(|record| is(record));
        let evaluation = last(|record| matches!(record, Record::Evaluation { .. }));
        let last = evaluation.or_else(|| last(|record| matches!(record, Record::Step { .. })));
        let mut summary = Summary::default();
        match last {
            Some(Record::Evaluation { step, seconds, mean, .. }) => {
                summary.mean = *mean;
                summary.step = *step;
                summary.seconds = *seconds;
            }
            Some(Record::Step { step, seconds, .. }) => {
                summary.step = *step;
                summary.seconds = *seconds;
            }
            _ => {}
        }
        let mut until = self.records.iter().rev().filter(|record| record.step() <= summary.step);
        let gaussians = |record: &Record| match record {
            Record::Step { gaussians, .. } | Record::Densification { gaussians, .. } => {
                Some(*gaussians)
            }
            _ => None,
        };
        summary.gaussians = until.find_map(gaussians);
        summary.tiles_per_second = self.median_speed();
        summary
    }

    fn median_speed(&self) -> Option<f64> {
        let speeds = self.records.iter().filter_map(|record| match record {
            Record::Step { tiles_per_second, .. } => Some(*tiles_per_second),
            _ => None,
        });
        let mut speeds: Vec<_> = speeds.filter(|speed| speed.is_finite()).collect();
        speeds.sort_by(f64::total_cmp);
        speeds.get(speeds.len() / 2).copied()
    }

    /// Name of the folder.
    pub fn name(&self) -> String {
        name_of(&self.folder)
    }

    /// Name of the data that the run was trained on.
    pub(super) fn data(&self) -> String {
        let path = self.config.data.path.as_deref();
        path.map_or_else(|| "the built-in scene".to_owned(), name_of)
    }

    /// What held-out views are compared with.
    pub(super) fn truth(&self) -> &'static str {
        if self.config.data.path.is_some() { "Photograph" } else { "Rendering" }
    }

    /// Number of all steps, also after the last evaluation.
    pub fn last_step(&self) -> u64 {
        self.records.iter().map(Record::step).max().unwrap_or_default()
    }

    pub(super) fn sessions<'a>(&'a self) -> Vec<(u64, &'a SessionInfo)> {
        let session = |record: &'a Record| match record {
            Record::Session { step, session } => Some((*step, session)),
            _ => None,
        };
        self.records.iter().filter_map(session).collect()
    }

    /// All evaluations.
    pub(super) fn evaluations<'a>(&'a self) -> Vec<Evaluation<'a>> {
        let evaluation = |record: &'a Record| match *record {
            Record::Evaluation { step, seconds, mean, ref views } => {
                Some(Evaluation { step, seconds, mean, views })
            }
            _ => None,
        };
        self.records.iter().filter_map(evaluation).collect()
    }

    /// The settings that resumes changed.
    pub(super) fn changes<'a>(&'a self) -> Vec<&'a Change> {
        let change = |record: &'a Record| match record {
            Record::Change(change) => Some(change),
            _ => None,
        };
        self.records.iter().filter_map(change).collect()
    }

    /// The time of each stage in the last session.
    pub(super) fn timing<'a>(&'a self) -> &'a [TimingRow] {
        let timing = |record: &'a Record| match record {
            Record::Timing { rows, .. } => Some(rows.as_slice()),
            _ => None,
        };
        self.records.iter().rev().find_map(timing).unwrap_or_default()
    }

    /// Numbers of split and pruned Gaussians, and the number of changes.
    pub(super) fn densification(&self) -> ([u64; 2], usize) {
        let events = self.records.iter().filter_map(|record| match record {
            Record::Densification { split, pruned, .. } => Some([split, pruned]),
            _ => None,
        });
        events.fold(([0; 2], 0), |(sums, times), event| {
            (std::array::from_fn(|at| sums[at].saturating_add(*event[at])), times + 1)
        })
    }
}

/// A setting that differs between runs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Difference {
    /// The setting's name.
    pub setting: String,
    /// Value in each run, as in `config.toml`; `None` if it is not set.
    pub values: Vec<Option<String>>,
}

/// The settings that differ between runs, in the order of `config.toml`, without `run.schedule`: no user sets it.
pub fn differences<'a>(runs: impl IntoIterator<Item = &'a Run>) -> Vec<Difference> {
    let lists: Vec<_> = runs.into_iter().map(|run| run.config.list()).collect();
    let mut seen = BTreeSet::new();
    let names = lists.iter().flatten().map(|(name, _)| name);
    let names = names.filter(|name| *name != "run.schedule" && seen.insert(*name));
    let value = |list: &Vec<(String, String)>, name: &str| {
        list.iter().find(|(other, _)| other == name).map(|(_, value)| value.clone())
    };
    let difference = |name: &String| {
        let values: Vec<_> = lists.iter().map(|list| value(list, name)).collect();
        let is_one = values.windows(2).all(|pair| pair[0] == pair[1]);
        (!is_one).then(|| Difference { setting: name.clone(), values })
    };
    names.filter_map(difference).collect()
}

/// The fields of an evaluation's record.
#[derive(Clone, Copy, Debug)]
pub(super) struct Evaluation<'a> {
    pub step: u64,
    pub seconds: f64,
    pub mean: Score,
    pub views: &'a [ViewScore],
}

fn name_of(path: &Path) -> String {
    let path = path.canonicalize().unwrap_or_else(|_| path.to_owned());
    path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned()
}
