//! What photographs' exposures are to training.

use serde::{Deserialize, Serialize};

/// The exposure of each photograph.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
#[non_exhaustive]
pub struct ExposureConfig {
    /// What is learned of it.
    pub method: ExposureMethod,
}

/// What is learned of a photograph's exposure.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ExposureMethod {
    /// Nothing: all photographs show the scene's colors.
    #[default]
    None,
    /// A gain and an offset for each channel.
    Affine,
}
