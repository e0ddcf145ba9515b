//! What commands take: a scene or a run's folder, cameras or a data set.  One place for each, used by all.

mod cameras;
mod data;
mod kind;
mod scene;

pub use cameras::Cameras;
pub use data::{DataArgs, DataSet, Split};
pub use kind::{Expected, Format, Kind, format, told_apart};
pub use scene::SceneSource;
