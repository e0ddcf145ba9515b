//! How a scene lies on a device.

/// How a scene lies on a device; the default is as it is, which alone has gradients.
///
/// ```
/// use organza::{DeviceOptions, DeviceScene, Renderer, UploadOptions, demo};
///
/// let renderer = Renderer::new(organza::open_device(&DeviceOptions::cpu(None))?);
/// let scene = demo::scene();
/// let halves = renderer.upload_with(&scene, UploadOptions::default().half_grids(true))?;
/// assert!(halves.bytes() < DeviceScene::bytes_of(&scene));
/// # Ok::<(), organza::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct UploadOptions {
    /// Both hash grids in half precision: half their memory.  Each feature is off by up to 2^-11 of the largest entry
    /// around it.  Refused if a value is above 65,504.
    pub half_grids: bool,
    /// The hidden layers of both networks computed in half precision
    /// ([`dense_half`](organza_shaders::dense_half)): for GPUs, slower on the CPU.  A layer's output is off by up to 0.9%
    /// of the sum of its terms' sizes, and an input beyond 1,024 counts as that.  Refused if a layer's weights add up to
    /// more than halves hold, and on a GPU that does not compute with halves.
    pub half_networks: bool,
}

impl UploadOptions {
    /// Sets [`half_grids`](Self::half_grids).
    #[must_use]
    pub fn half_grids(mut self, half_grids: bool) -> Self {
        self.half_grids = half_grids;
        self
    }

    /// Sets [`half_networks`](Self::half_networks).
    #[must_use]
    pub fn half_networks(mut self, half_networks: bool) -> Self {
        self.half_networks = half_networks;
        self
    }
}
