//! Training: from photographs with poses to a scene.

pub mod config;
pub mod metrics;
mod optimizer;
pub mod report;
mod sampler;
