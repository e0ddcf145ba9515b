//! A loss that a caller computes on the host.

use super::image::TileImages;
use organza_core::{RenderedTiles, Result, TileBatch};

/// The tiles of a step, and what they should look like: the argument of a caller's loss.
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

/// The result of a caller's loss.
#[derive(Clone, Debug, PartialEq)]
pub struct LossGradient {
    /// The loss of the batch.
    pub loss: f64,
    /// dL/dY `[K, 3, S, S]`
    pub grad_tiles: Vec<f32>,
}

/// A caller's loss, as [`Renderer::add_loss_gradient`](crate::Renderer::add_loss_gradient) takes it. It sees the whole batch.
pub type OwnLoss<'h> = Box<dyn FnMut(&LossBatch<'_>) -> Result<LossGradient> + 'h>;
