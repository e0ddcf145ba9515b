//! Losses that a caller computes, on the host or on the device.

use super::image::{LossInputs, TileImages};
use muslin_device::{Buffer, Device};
use organza_core::{RenderedTiles, Result, TileBatch};

/// The tiles of a step, and what they should look like: the argument of a loss on the host.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct LossBatch<'a> {
    /// Where the tiles are; `camera` is an index into the frames that are trained on.
    pub batch: &'a TileBatch,
    /// Y `[K, 3, S, S]`, as the photographs' cameras would have exposed them.
    pub rendered: &'a RenderedTiles,
    /// The photographs behind the tiles, `[K, 3, S, S]`, and which of their pixels count.
    pub target: TileImages<'a>,
}

/// The result of a loss on the host.
#[derive(Clone, Debug, PartialEq)]
pub struct LossGradient {
    /// The loss of the batch.
    pub loss: f64,
    /// dL/dY `[K, 3, S, S]`
    pub grad_tiles: Vec<f32>,
}

/// Tiles on the device, and what they should look like: the argument of a loss on the device.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct DeviceLossBatch<'a> {
    /// The device of the buffers.
    pub device: &'a Device,
    /// S, in pixels.
    pub side: u32,
    /// Y, as the photographs' cameras would have exposed it, the photographs, and which pixels count;
    /// [`image_loss`](crate::image_loss) takes them.
    pub inputs: LossInputs<'a>,
}

/// The result of a loss on the device.
#[derive(Debug)]
pub struct DeviceLossGradient {
    /// The loss of these tiles. The losses of a batch's parts are added.
    pub loss: f64,
    /// dL/dY `[K, 3, S, S]`
    pub grad_tiles: Buffer<f32>,
}

type HostLoss<'h> = dyn FnMut(&LossBatch<'_>) -> Result<LossGradient> + 'h;
pub(crate) type DeviceLoss<'h> = dyn FnMut(&DeviceLossBatch<'_>) -> Result<DeviceLossGradient> + 'h;

/// A caller's loss, as [`Renderer::add_loss_gradient`](crate::Renderer::add_loss_gradient) takes it.
pub enum OwnLoss<'h> {
    /// A function of the tiles and the photographs on the host. It sees the whole batch.
    Host(Box<HostLoss<'h>>),
    /// A function of the buffers on the device, a sum over tiles: it sees some tiles after the others.
    Device(Box<DeviceLoss<'h>>),
}
