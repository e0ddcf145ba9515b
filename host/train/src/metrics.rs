//! `metrics.jsonl`: the measurements of a run, one JSON object per line.

#[cfg(test)]
mod tests;

use std::collections::BTreeMap;
use std::fs::File;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime, UNIX_EPOCH};

use serde::{Deserialize, Deserializer, Serialize};

use super::binding::Change;
use crate::evaluate::{Evaluation, Score, ViewScore};
use organza_core::input::read_file;
use organza_core::{Error, Result, write_inside};

/// Largest log, in bytes. No run logs as much; a larger file is not a log.
const MAX_BYTES: u64 = 1 << 30;

/// One line of `metrics.jsonl`: an object. Its `kind` names the variant.
///
/// A number that is NaN or infinite is null in the file. Reading it gives NaN or `None`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Record {
    /// A program begins or continues to train.
    Session {
        /// Optimizer steps so far.
        step: u64,
        /// The program and its device.
        #[serde(flatten)]
        session: SessionInfo,
    },
    /// The state of training after a step.
    Step {
        /// Optimizer steps so far.
        step: u64,
        /// Seconds of training so far, including those before a resume.
        seconds: f64,
        /// The loss of this step's batch.
        #[serde(deserialize_with = "nan_for_null")]
        loss: f64,
        /// The mean absolute difference of this step's batch, the first part of the loss.
        #[serde(deserialize_with = "nan_for_null")]
        l1: f64,
        /// The mean SSIM of this step's batch, the second part of the loss.
        #[serde(deserialize_with = "nan_for_null")]
        ssim: f64,
        /// The PSNR of this step's batch, in decibels.
        #[serde(deserialize_with = "nan_for_null")]
        psnr: f64,
        /// Training speed, in tiles per second.
        #[serde(deserialize_with = "nan_for_null")]
        tiles_per_second: f64,
        /// Number of Gaussians.
        gaussians: u64,
        /// The learning rate of each group of parameters in this step, by the name of its setting.
        rates: BTreeMap<String, f32>,
    },
    /// The scores of the held-out frames.
    Evaluation {
        /// Optimizer steps so far.
        step: u64,
        /// Seconds of training so far, including those before a resume.
        seconds: f64,
        /// Means over the views.
        #[serde(flatten)]
        mean: Score,
        /// Scores of each view.
        views: Vec<ViewScore>,
    },
    /// The number of Gaussians changed.
    Densification {
        /// Optimizer steps so far.
        step: u64,
        /// Number of Gaussians that were replaced by smaller ones.
        split: u64,
        /// Number of Gaussians that were removed.
        pruned: u64,
        /// Number of Gaussians afterwards.
        gaussians: u64,
    },
    /// The resume changed a setting.
    Change(Change),
    /// The time of each stage.
    Timing {
        /// Optimizer steps so far.
        step: u64,
        /// The stages.
        rows: Vec<TimingRow>,
    },
}

/// The program that trains, and its device, from the program's start to its end.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct SessionInfo {
    /// Start in UTC: `2026-01-31T09:30:00Z`.
    pub date: String,
    /// The command line; `None` if a user of the library trains.
    pub command: Option<String>,
    /// Organza's version.
    pub version: String,
    /// The commit that organza was built from, if known: see [`crate::COMMIT`].
    pub commit: Option<String>,
    /// The device, in the words of [`Device::choice`](muslin_device::Device::choice).
    pub device: String,
}

impl SessionInfo {
    /// A session that begins now.
    #[must_use]
    pub fn now(command: Option<String>, device: &str) -> Self {
        Self {
            date: date(SystemTime::now()),
            command,
            version: env!("CARGO_PKG_VERSION").to_owned(),
            commit: crate::COMMIT.map(str::to_owned),
            device: device.to_owned(),
        }
    }
}

/// The time of a stage of training.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TimingRow {
    /// The stage's name.
    pub stage: String,
    /// Time of the stage, in seconds.
    pub seconds: f64,
    /// Part of the total time, 0 to 1.
    pub share: f64,
}

impl Record {
    /// The record of an evaluation after `step` steps and `seconds` of training.
    #[must_use]
    pub fn evaluation(step: u64, seconds: f64, evaluation: &Evaluation) -> Self {
        let views = evaluation.views.clone();
        Self::Evaluation { step, seconds, mean: evaluation.mean, views }
    }

    /// Number of optimizer steps so far.
    #[must_use]
    pub fn step(&self) -> u64 {
        match self {
            Self::Session { step, .. }
            | Self::Step { step, .. }
            | Self::Evaluation { step, .. }
            | Self::Densification { step, .. }
            | Self::Change(Change { step, .. })
            | Self::Timing { step, .. } => *step,
        }
    }
}

fn nan_for_null<'de, D: Deserializer<'de>>(deserializer: D) -> Result<f64, D::Error> {
    Ok(Option::deserialize(deserializer)?.unwrap_or(f64::NAN))
}

/// A `metrics.jsonl` that is open for writing.
#[derive(Debug)]
pub struct MetricsLog {
    path: PathBuf,
    file: File,
}

impl MetricsLog {
    /// Starts a new log and replaces an old one.
    ///
    /// # Errors
    /// [`Error::WriteFile`].
    pub fn create(path: impl AsRef<Path>) -> Result<Self> {
        Self::begin(path.as_ref(), &[])
    }

    /// Continues a log after `step`. Later records are dropped, and so is an incomplete last line. Earlier lines keep
    /// their bytes. Changes at this very step are dropped, too, because the resume decides about them again. If there
    /// is no log, a new one is started.
    ///
    /// # Errors
    /// The same errors as [`Self::read`], except for a missing file; [`Error::WriteFile`].
    pub fn resume(path: impl AsRef<Path>, step: u64) -> Result<Self> {
        let path = path.as_ref();
        if !path.exists() {
            return Self::create(path);
        }
        let text = read(path)?;
        let kept = parse(path, &text)?;
        let kept = kept.iter().filter(|(_, record)| match record {
            Record::Change(change) => change.step < step,
            other => other.step() <= step,
        });
        Self::begin(path, &kept.map(|(line, _)| *line).collect::<Vec<_>>())
    }

    /// Reads a log, without an incomplete last line.
    ///
    /// # Errors
    /// [`Error::ReadFile`]; [`Error::Invalid`] for the first other line that is no record.
    pub fn read(path: impl AsRef<Path>) -> Result<Vec<Record>> {
        let path = path.as_ref();
        let text = read(path)?;
        Ok(parse(path, &text)?.into_iter().map(|(_, record)| record).collect())
    }

    /// Appends a record. It is in the file when this returns.
    ///
    /// # Errors
    /// [`Error::WriteFile`].
    pub fn append(&mut self, record: &Record) -> Result<()> {
        self.write_line(record).map_err(|source| Error::write(&self.path, source))
    }

    fn write_line(&mut self, record: &Record) -> io::Result<()> {
        let mut line = serde_json::to_vec(record)?;
        line.push(b'\n');
        // written in one call, so that only a crash can leave half a line
        self.file.write_all(&line)?;
        self.file.flush()
    }

    fn begin(path: &Path, lines: &[&[u8]]) -> Result<Self> {
        write_inside(path, |writer| {
            for line in lines {
                writer.write_all(line)?;
                writer.write_all(b"\n")?;
            }
            Ok(())
        })?;
        let file = File::options().append(true).open(path);
        let file = file.map_err(|source| Error::write(path, source))?;
        Ok(Self { path: path.to_owned(), file })
    }
}

/// A date in UTC. A clock that is wrong by so much that RFC 3339 has no date for it shows the nearest one.
fn date(time: SystemTime) -> String {
    /// The last second of the year 9999, in seconds since 1970.
    const LAST: u64 = 253_402_300_799;
    let last = UNIX_EPOCH + Duration::from_secs(LAST);
    humantime::format_rfc3339_seconds(time.clamp(UNIX_EPOCH, last)).to_string()
}

fn read(path: &Path) -> Result<Vec<u8>> {
    read_file(path, MAX_BYTES, "a log of training")
}

/// The records of a log with their lines. Errors name `path`.
///
/// # Errors
/// [`Error::Invalid`] for a line that is no record, unless it is the last: a run that is killed leaves half a line.
pub fn parse<'a>(path: &Path, text: &'a [u8]) -> Result<Vec<(&'a [u8], Record)>> {
    let mut records = Vec::new();
    let mut bad = None;
    for (number, line) in (1..).zip(text.split(|&byte| byte == b'\n')) {
        if line.trim_ascii().is_empty() {
            continue;
        }
        if let Some((number, error)) = bad {
            let reason = format!(
                "line {number} is no record of a training run: {error}; remove the line, or \
                 choose another folder"
            );
            return Err(Error::Invalid { origin: path.to_owned(), reason });
        }
        match serde_json::from_slice(line) {
            Ok(record) => records.push((line, record)),
            Err(error) => bad = Some((number, error)),
        }
    }
    Ok(records)
}
