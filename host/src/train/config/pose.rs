//! What the poses of cameras are to training.

use serde::{Deserialize, Serialize};

/// The poses of the photographs' cameras.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
#[non_exhaustive]
pub struct PosesConfig {
    /// What is learned of them.
    pub method: PoseMethod,
}

/// What is learned of a camera's pose.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum PoseMethod {
    /// Nothing: cameras are where the data set says.
    #[default]
    None,
    /// A rotation and a shift of each camera that is trained on.
    Refine,
}
