//! Training: from photographs with poses to a scene, and how close the scene is to them.
//!
//! A [`Trainer`] takes steps. A [`Session`] is a run in a folder: it logs, saves and evaluates, and reports what happens as
//! [`Event`]s. It draws nothing: its caller does.
//!
//! Use it through the crate [`organza`](https://crates.io/crates/organza).

mod binding;
pub mod built_in;
mod checkpoint;
mod coarse;
pub mod config;
mod data_place;
mod densification;
pub mod evaluate;
mod folder;
mod folder_lock;
mod held_out;
mod import;
pub mod metrics;
mod optimizer;
mod per_photograph;
mod photographs;
mod points;
mod pose;
mod ranks;
mod requirements;
mod sampler;
mod schedule;
mod session;
mod space;
mod start;
mod trainer;

pub use binding::{Binding, CHANGEABLE, Change, changed_settings_of, settings_of};
pub use checkpoint::{Checkpoint, Progress};
pub use config::{ConfigBuilder, Preset, TrainConfig};
pub use data_place::CAPTURED;
pub use densification::DensificationStats;
pub use evaluate::{Evaluation, evaluate};
pub use folder::{
    BEST, CAMERAS, CHECKPOINT, CONFIG, CROPPED, EVALUATIONS, FIT, METRICS, PICTURES, REPORT,
    RunFolder, is_run_file,
};
pub use folder_lock::FolderLock;
pub use import::{Import, Imported, import};
pub use per_photograph::PerPhotograph;
pub use ranks::follow;
pub use session::{Event, Outcome, Session, Watch};
pub use trainer::{StepReport, Trainer};

/// The commit that organza was built from, followed by `-modified` if its sources had changed since. It is known for
/// packages that cargo made, and for release builds in a git repository. Otherwise, the environment variable
/// `ORGANZA_COMMIT` sets it.
pub const COMMIT: Option<&str> = option_env!("ORGANZA_COMMIT");
