//! Renders Gaussians without sorting them: from a scene, cameras and tiles to pixels, and from dL/dY to gradients.
//!
//! To render, you only need this crate, and [`organza_core`] for scenes, cameras and tiles. The compiled kernels are
//! part of it. [`organza`](https://crates.io/crates/organza) exports all of it, and trains. [`Renderer`] has an example.

mod gradient;
mod loss;
mod pass;
mod queries;
mod scene;
mod stages;
#[cfg(test)]
mod tests;

pub use gradient::{BinnedGradient, POSE, SceneGradient, TensorGradient};
pub use loss::compare::BatchLoss;
pub use loss::image::{
    LossInputs, LossOutput, LossTarget, Photographs, TileImages, TileLoss, image_loss,
};
pub use loss::own::{LossBatch, LossGradient, OwnLoss};
pub use pass::loss_gradient::QueuedLoss;
pub use pass::renderer::Renderer;
pub use pass::tape::Tape;
pub use queries::contribution::{Contributions, PixelColor};
pub use queries::eye::{EyeCache, EyeOptions, FieldWork};
pub use queries::frame::{Frame, FrameShape};
#[doc(hidden)]
pub use queries::pixel::Stages;
pub use queries::pixel::{Contribution, Inspection, Trace};
pub use queries::surface::Surface;
pub use scene::device_scene::{DeviceScene, Roulette};
pub use scene::occupancy::OCCUPANCY;
pub use scene::options::UploadOptions;
pub use scene::packed::{pack, replace_gaussians, unpack, upload};
pub use stages::counts::Capacity;
pub use stages::transmittance::Ray;

use muslin_device::{Device, DeviceOptions, Modules};
use organza_core::Result;

/// The compiled GPU kernels, which [`open_device`] passes to the device.
pub static MODULES: Modules = muslin_device::modules!();

/// Opens the device that `options` describe, with the kernels of this crate.
///
/// Without `XDG_RUNTIME_DIR`, as over ssh or in a container, Mesa's Vulkan layer `device_select` may write `error:
/// XDG_RUNTIME_DIR is invalid or not set` to stderr. It does no harm. A process that starts with `NODEVICE_SELECT=1`
/// in its environment does not load the layer. The program `organza` sets that for itself.
///
/// # Errors
/// [`DeviceError::NoGpu`](organza_core::error::DeviceError::NoGpu) if a GPU was demanded and none can be used.
pub fn open_device(options: &DeviceOptions) -> Result<Device> {
    Ok(Device::open(options, &MODULES)?)
}
