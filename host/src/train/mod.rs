//! Training: from photographs with poses to a scene.

pub mod built_in;
mod checkpoint;
pub mod config;
mod growth;
pub mod metrics;
mod optimizer;
pub mod report;
mod sampler;
mod session;
mod start;
mod trainer;

pub use checkpoint::{CHECKPOINT, Checkpoint, Progress};
pub use config::TrainConfig;
pub use session::{CONFIG, Event, METRICS, Outcome, REPORT, Session};
pub use trainer::{GradientHook, StepGradient, StepReport, Trainer};
