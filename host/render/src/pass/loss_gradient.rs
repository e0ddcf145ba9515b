//! The loss of a batch and its gradient: tiles are compared with photographs.

use std::collections::BTreeMap;

use super::batch::{Parts, Pass};
use super::capacity::BatchKind;
use super::output::Output;
use super::renderer::Renderer;
use crate::gradient::SceneGradient;
use crate::loss::compare::{BatchLoss, Comparison, LossSource, check_len, tile_losses};
use crate::loss::exposure::expose_tile;
use crate::loss::image::{LossTarget, TileImages, TileLoss};
use crate::loss::own::{LossBatch, OwnLoss};
use crate::scene::device_scene::DeviceScene;
use crate::stages::counts::Capacity;
use muslin_device::{Buffer, memory};
use organza_core::ranks::Ranks;
use organza_core::{Camera, RenderedTiles, Result, TileBatch};

impl Renderer {
    /// Adds the gradients of a batch's loss to `gradient`. Returns the loss, and the measurements of each tile.
    ///
    /// With `ranks`, each has the same batch, scene and loss, and renders some views of the batch. All get the same result
    /// and the same gradient.
    ///
    /// `own` is a caller's loss instead of the image's. Tiles are measured and have exposures all the same.
    /// A loss on the host sees the whole batch, so that all tiles are read first.
    ///
    /// On a GPU, a batch of one part waits once, for the losses. The first batch of a kind also waits for its counts, and a loss of the
    /// caller's waits for the tiles. All values of `gradient` must be zero, except for the statistics.
    ///
    /// # Errors
    /// The same errors as [`Renderer::render`]; [`Error::Rank`](organza_core::Error::Rank); the errors of the caller's loss, and
    /// [`Error::Argument`](organza_core::Error::Argument) where its gradient has another number of values. The gradient is
    /// then as it was before.
    #[allow(clippy::too_many_arguments)]
    pub fn add_loss_gradient(
        &self,
        scene: &DeviceScene,
        cameras: &[Camera],
        batch: &TileBatch,
        target: &LossTarget<'_>,
        own: Option<&mut OwnLoss<'_>>,
        gradient: &SceneGradient,
        ranks: Option<&dyn Ranks>,
    ) -> Result<BatchLoss> {
        let device = self.device();
        let ranks = ranks.filter(|ranks| ranks.size() > 1);
        let pass = Pass { ranks, ..self.pass(scene, cameras) };
        let mut parts = pass.cut(batch)?;
        gradient.snapshot(device);
        let mut own_loss = None;
        if let Some(own) = own {
            let rendered = &pass.whole_batch(&mut parts, batch, target)?;
            let [image, valid] = target.photographs.on_host()?;
            let target = TileImages { image: &image, valid: &valid, side: batch.side };
            let found = own(&LossBatch { batch, rendered, target })?;
            check_len(found.grad_tiles.len(), rendered.data.len())?;
            own_loss = Some(found);
        }
        let d_tiles = own_loss.as_ref().map(|found| &found.grad_tiles[..]);
        let mut source = LossSource::Compared(Comparison::new(target, d_tiles));
        pass.backward(&mut parts, &mut source, gradient)?;
        let LossSource::Compared(mut found) = source else { unreachable!("made above") };
        if let Some(ranks) = ranks {
            found.gather(ranks).inspect_err(|_| gradient.rollback(device))?;
        }
        Ok(found.finish(own_loss.as_ref().map(|found| found.loss)))
    }

    /// Queues what [`Renderer::add_loss_gradient`] does with the image's loss, and waits for nothing: a GPU then works on several
    /// batches, one after the other, while the host prepares the next one. `None`, with nothing queued, where the host must wait:
    /// on a CPU, for a batch of several parts, and for the first batch of a kind, which shows how much room
    /// such batches need.
    ///
    /// A batch fails if it has too little room or if its loss is not finite. Neither it nor any later queued batch then adds to the
    /// gradient, and [`SceneGradient::unless_failed`] counts nothing, until [`SceneGradient::clear_failure`].
    ///
    /// # Errors
    /// The same errors as [`Renderer::render`]. The gradient is then as it was before.
    pub fn queue_loss_gradient(
        &self,
        scene: &DeviceScene,
        cameras: &[Camera],
        batch: &TileBatch,
        target: &LossTarget<'_>,
        gradient: &SceneGradient,
    ) -> Result<Option<QueuedLoss>> {
        if !self.device().has_indirect_counts() {
            return Ok(None);
        }
        let pass = Pass { queue_counts: Some(&gradient.counts), ..self.pass(scene, cameras) };
        let mut parts = pass.cut(batch)?;
        let mut loss = LossSource::Compared(Comparison::new(target, None));
        let Some((kind, size)) = pass.queue(&mut parts, &mut loss, gradient)? else {
            return Ok(None);
        };
        let mut buffers = loss.buffers();
        buffers.push(gradient.counts.view());
        let places = parts.list[0].part_tiles.places();
        Ok(Some(QueuedLoss { kind, size, places, ssim_weight: target.ssim_weight, buffers }))
    }
}

/// The loss of a batch that a GPU works on.
#[derive(Debug)]
pub struct QueuedLoss {
    kind: BatchKind,
    size: [u32; 2],
    /// Each tile's place in the batch.
    places: Vec<usize>,
    ssim_weight: f32,
    buffers: Vec<Buffer<u32>>,
}

impl QueuedLoss {
    /// The buffers whose values [`QueuedLoss::finish`] needs. The next batch overwrites some of them.
    pub fn buffers(&self) -> &[Buffer<u32>] {
        &self.buffers
    }

    /// The loss, from the values of [`QueuedLoss::buffers`]. `None` if this batch or one before it has failed.
    pub fn finish(self, renderer: &Renderer, values: &[Vec<u32>]) -> Option<BatchLoss> {
        let [rows, counts] = values else { unreachable!("as many as buffers") };
        let needed = Capacity::needed(counts)?;
        renderer.predictor().observe(self.kind, self.size, needed);
        let tiles: BTreeMap<_, _> = tile_losses(&self.places, rows).collect();
        let tiles: Vec<_> = tiles.into_values().collect();
        let loss = TileLoss::total(&tiles).value(self.ssim_weight);
        Some(BatchLoss { loss, tiles })
    }
}

impl Pass<'_> {
    /// The tiles of all ranks, as their photographs' cameras would have exposed them. Parts are kept.
    fn whole_batch(
        &self,
        parts: &mut Parts,
        batch: &TileBatch,
        target: &LossTarget<'_>,
    ) -> Result<RenderedTiles> {
        let mut rendered = RenderedTiles::new(batch, &[])?;
        let output = &mut Output::Tiles { tiles: &mut rendered, channels: &[] };
        self.forward(parts, true, output, &mut |_| {})?;
        let len = 3 * (batch.side * batch.side) as usize;
        if rendered.data.is_empty() {
            rendered.data = memory::zeros(batch.tiles.len() * len, "the rendered batch")?;
        }
        if let Some(ranks) = self.ranks {
            // each rank's tiles are zeros elsewhere
            for bytes in ranks.gather(bytemuck::cast_slice(&rendered.data).to_vec())? {
                let tiles: Vec<f32> = bytemuck::pod_collect_to_vec(&bytes);
                let values = rendered.data.iter_mut().zip(tiles);
                values.filter(|(_, other)| *other != 0.0).for_each(|(own, other)| *own = other);
            }
        }
        if let Some(exposure) = target.exposure {
            let exposure = self.renderer.device().read(exposure)?;
            let tiles = batch.tiles.iter().zip(rendered.data.chunks_exact_mut(len));
            tiles.for_each(|(tile, values)| expose_tile(tile, values, &exposure));
        }
        Ok(rendered)
    }
}
