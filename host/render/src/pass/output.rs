//! Reads the tiles of a part from the device, and puts them where they belong on the host.

use crate::stages::channels::ChannelSums;
use crate::stages::composite::{Composite, TileContext, pixels};
use crate::stages::counts::Capacity;
use crate::stages::cut::PartTiles;
use muslin_device::{Buffer, Device, memory};
use organza_core::image::Image;
use organza_core::{Channel, RenderReport, RenderedTiles, Result};

/// Where the tiles of a batch go.
pub enum Output<'a> {
    /// As floats, with channels beside color.
    Tiles { tiles: &'a mut RenderedTiles, channels: &'a [Channel] },
    /// Into the image of their camera, in 8 bits.
    Image { image: &'a mut Image, report: &'a mut RenderReport },
}

impl Output<'_> {
    /// The buffers of a part to read for [`Self::take`], and the sums of its channels, which are among them.
    pub fn buffers(
        &self,
        contexts: &[TileContext<'_>],
        composite: &Composite,
    ) -> Result<(Vec<Buffer<u32>>, Option<ChannelSums>)> {
        let degenerate = contexts.iter().map(|context| context.bins.degenerate.view());
        let mut buffers: Vec<_> = degenerate.collect();
        let Self::Tiles { channels, .. } = self else {
            let device = contexts[0].scene.device();
            buffers.push(pixels(device, contexts[0].bins.side, &composite.image)?);
            return Ok((buffers, None));
        };
        buffers.push(composite.image.view());
        let sums = ChannelSums::new(contexts, composite, channels)?;
        buffers.extend(sums.buffers());
        Ok((buffers, Some(sums)))
    }

    /// Takes the words of [`Self::buffers`] and the sums of its channels, of a part that shows `scenes` scenes and needed this capacity.
    pub fn take(
        &mut self,
        device: &Device,
        part_tiles: &PartTiles,
        scenes: usize,
        sums: Option<ChannelSums>,
        mut words: Vec<Vec<u32>>,
        needed: Capacity,
    ) -> Result<()> {
        let degenerate = words.drain(..scenes).map(|counts| u64::from(counts[0])).sum();
        let [pairs, intersections, samples] =
            [needed.pairs, needed.intersections, needed.samples].map(u64::from);
        let of_part = RenderReport { parts: 1, pairs, intersections, samples, degenerate };
        match self {
            Self::Image { image, report } => {
                let tiles: Vec<_> =
                    part_tiles.tiles.iter().map(|part_tile| part_tile.tile).collect();
                device.run_in_pool(|| image.paste_words(part_tiles.side, &tiles, &words[0]));
                report.add(&of_part);
            }
            Self::Tiles { tiles, channels } => {
                let count = tiles.count;
                place(part_tiles, count, bytemuck::cast_vec(words.remove(0)), &mut tiles.data)?;
                let found = sums.map(|sums| sums.resolve(&words, part_tiles.side, channels));
                for (channel, values) in channels.iter().zip(found.into_iter().flatten()) {
                    let all = tiles.channels.get_mut(channel);
                    let all = all.expect("`RenderedTiles::new` has made it");
                    place(part_tiles, count, values, all)?;
                }
                tiles.report.add(&of_part);
            }
        }
        Ok(())
    }
}

/// Puts the values of a part's tiles into their places among the values of `count` tiles.
fn place(
    part_tiles: &PartTiles,
    count: usize,
    values: Vec<f32>,
    all: &mut Vec<f32>,
) -> muslin_device::Result<()> {
    let is_in_order = part_tiles.tiles.iter().enumerate().all(|(place, tile)| tile.place == place);
    if part_tiles.tiles.len() == count && is_in_order {
        // new memory costs more than the copy
        *all = values;
        return Ok(());
    }
    let len = values.len() / part_tiles.tiles.len();
    if all.is_empty() {
        *all = memory::zeros(count * len, "the rendered batch")?;
    }
    for (values, tile) in values.chunks_exact(len).zip(&part_tiles.tiles) {
        all[tile.place * len..][..len].copy_from_slice(values);
    }
    Ok(())
}
