//! From a scene, cameras and tiles to a rendered batch, and back to gradients: one file per stage.

mod backward;
mod bin;
mod block;
mod capacity;
mod channels;
mod color;
mod composite;
mod dense_half;
mod field;
mod field_backward;
mod gradient;
mod halves;
mod hash_grid;
mod hash_grid_half;
mod inspect;
mod leakage;
mod loss;
mod mask;
mod network;
mod options;
mod own_loss;
mod packed;
mod pair;
mod part;
mod part_counts;
mod plan;
mod project;
mod recording;
mod renderer;
mod results;
mod scan;
mod scene;
#[cfg(test)]
mod tests;
mod transmittance;
mod upload;

pub use backward::LossTarget;
pub use channels::Channel;
pub(crate) use dense_half::half_vectors;
pub use gradient::{SceneGradient, TensorGradient};
pub(crate) use hash_grid_half::pack_halves;
#[doc(hidden)]
pub use inspect::Stages;
pub use inspect::{Contribution, Inspection};
pub use leakage::Leakage;
pub use loss::{Loss, LossInputs, LossOutput, TileLoss};
pub use options::UploadOptions;
pub(crate) use own_loss::OwnLoss;
pub use own_loss::{DeviceLossBatch, DeviceLossGradient, LossBatch, LossGradient};
pub(crate) use packed::{pack, unpack, upload};
pub use recording::Recording;
pub use renderer::Renderer;
pub use results::{RenderReport, RenderedTiles};
pub use scene::DeviceScene;
