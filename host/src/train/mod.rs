//! Training: from photographs with poses to a scene.

mod binding;
pub mod built_in;
mod checkpoint;
pub mod config;
mod folder;
mod growth;
mod hooks;
pub mod metrics;
mod needs;
mod optimizer;
mod plan;
mod ranks;
pub mod report;
mod resume;
mod sampler;
mod session;
mod space;
mod start;
mod sweep;
mod tensorboard;
mod trainer;

pub use binding::{Binding, CHANGEABLE, Change, changed_settings_of, settings_of};
pub use checkpoint::{BEST, CHECKPOINT, Checkpoint, Progress};
pub use config::{ConfigBuilder, Preset, TrainConfig};
pub use folder::RunFolder;
pub use folder::{CONFIG, EVALUATIONS, METRICS, REPORT};
pub use growth::Grown;
pub use hooks::{GradientHook, StepGradient, StepHooks};
pub use ranks::follow;
pub use report::PICTURES;
pub(crate) use report::{ERROR_FACTOR, error_levels};
pub use session::{Event, Outcome, Session};
pub(crate) use space::{Target, depth as in_image, median};
pub(crate) use start::of_splats;
pub use trainer::{StepReport, Trainer};
