//! The results of the parts of a batch.

use crate::pass::part::RenderedPart;
use crate::stages::cut::PartTiles;
use muslin_device::{Result, memory};
use organza_core::{Channel, RenderReport, RenderedTiles};

/// Puts the tiles of a part in their places; `channels` are those of the part.
///
/// # Errors
/// [`Error::OutOfMemory`](muslin_device::Error::OutOfMemory).
pub fn place(
    tiles: &mut RenderedTiles,
    plan: &PartTiles,
    part: RenderedPart,
    channels: &[Channel],
) -> Result<()> {
    let area = (tiles.side * tiles.side) as usize;
    let count = tiles.count;
    let is_in_order = plan.tiles.iter().enumerate().all(|(place, tile)| tile.place == place);
    // New memory costs more than the copy: a batch of one part takes what was read.
    let is_whole = plan.tiles.len() == count && is_in_order;
    let place = |values: Vec<f32>, planes: usize, batch: &mut Vec<f32>| {
        if is_whole {
            *batch = values;
            return Ok(());
        }
        let len = planes * area;
        if batch.is_empty() {
            *batch = memory::zeros(count * len, "the rendered batch")?;
        }
        for (values, tile) in values.chunks_exact(len).zip(&plan.tiles) {
            batch[tile.place * len..][..len].copy_from_slice(values);
        }
        Ok(())
    };
    place(part.pixels, 3, &mut tiles.data)?;
    for (channel, values) in channels.iter().zip(part.channels) {
        let all = tiles.channels.get_mut(channel).expect("`RenderedTiles::new` has made it");
        place(values, channel.planes(), all)?;
    }
    tiles.report.add(&part.report);
    Ok(())
}

/// How many numbers a report has.
pub const REPORT_NUMBERS: usize = 5;

/// A report as numbers, for other ranks.
pub fn report_to_numbers(report: RenderReport) -> [u64; REPORT_NUMBERS] {
    let RenderReport { parts, pairs, members, samples, degenerate } = report;
    [parts as u64, pairs, members, samples, degenerate]
}

/// The report that another rank has sent.
pub fn report_from_numbers(numbers: [u64; REPORT_NUMBERS]) -> RenderReport {
    let [parts, pairs, members, samples, degenerate] = numbers;
    RenderReport { parts: parts as usize, pairs, members, samples, degenerate }
}
