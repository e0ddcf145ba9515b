//! The format of a scene on a device.

/// The format of a scene on a device. The default is f32, the only one with gradients.
///
/// ```
/// use organza_core::demo;
/// use muslin_device::DeviceOptions;
/// use organza_render::{DeviceScene, Renderer, UploadOptions, open_device};
///
/// let renderer = Renderer::new(open_device(&DeviceOptions::cpu(None))?);
/// let scene = demo::scene();
/// let halves = renderer.upload_with(&scene, UploadOptions { half_grids: true })?;
/// assert!(halves.bytes() < DeviceScene::bytes_of(&scene));
/// # Ok::<(), organza_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct UploadOptions {
    /// Both hash grids in half precision: half their memory. The error of a feature is at most 2^-11 of the largest entry
    /// around it. A scene with a value above 65,504 is refused.
    pub half_grids: bool,
}
