//! Whether a run learns the photographs' exposures.

use std::fmt;
use std::str::FromStr;

use serde::{Deserialize, Serialize};

use organza_data::Dataset;

/// Exposures that differ by more than this are learned: see [`Dataset::exposure_spread`].
// docs/experiments.md: 10% is not worth it, 17% is.
const SPREAD: f64 = 0.15;

/// Whether a run learns the photographs' exposures: `auto`, true or false in a file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(try_from = "Written", into = "Written")]
pub enum LearnExposure {
    /// If they differ by more than 15%, measured at the data set's points. A data set without points tells nothing.
    #[default]
    Auto,
    /// Yes.
    On,
    /// No.
    Off,
}

/// The forms in a file.
#[derive(Serialize, Deserialize)]
#[serde(untagged, expecting = "expected auto, true or false")]
enum Written {
    Flag(bool),
    Text(String),
}

impl LearnExposure {
    /// Whether exposures of these photographs are learned.
    #[must_use]
    pub fn decide(self, dataset: &Dataset) -> bool {
        match self {
            Self::Auto => dataset.exposure_spread().is_some_and(|spread| spread > SPREAD),
            Self::On => true,
            Self::Off => false,
        }
    }
}

impl From<bool> for LearnExposure {
    fn from(learn: bool) -> Self {
        if learn { Self::On } else { Self::Off }
    }
}

impl FromStr for LearnExposure {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text {
            "auto" => Ok(Self::Auto),
            "true" => Ok(Self::On),
            "false" => Ok(Self::Off),
            _ => Err("expected auto, true or false".to_owned()),
        }
    }
}

impl fmt::Display for LearnExposure {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::Auto => "auto",
            Self::On => "true",
            Self::Off => "false",
        })
    }
}

impl TryFrom<Written> for LearnExposure {
    type Error = String;

    fn try_from(written: Written) -> Result<Self, String> {
        match written {
            Written::Flag(learn) => Ok(learn.into()),
            Written::Text(text) => text.parse(),
        }
    }
}

impl From<LearnExposure> for Written {
    fn from(learn: LearnExposure) -> Self {
        match learn {
            LearnExposure::Auto => Self::Text(learn.to_string()),
            LearnExposure::On => Self::Flag(true),
            LearnExposure::Off => Self::Flag(false),
        }
    }
}
