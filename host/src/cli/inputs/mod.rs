//! Inputs of commands: a scene or a run's folder, cameras or a data set. All commands share one place for each.

mod cameras;
mod data;
mod kind;
mod scene;

pub use cameras::Cameras;
pub use data::{DataArgs, DataSet, Split};
pub use kind::{Expected, FileKind, Format, format, told_apart};
pub use scene::SceneSource;
