//! How a scene lies on a device.

/// How a scene lies on a device; the default is as it is, which alone has gradients.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
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
