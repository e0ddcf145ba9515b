//! The results of the parts of a batch.

use super::plan::PartTiles;
use crate::forward::part::RenderedPart;
use organza_core::{Channel, RenderReport, RenderedTiles};

/// Puts the tiles of a part in their places; `channels` are those of the part.
pub fn place(
    tiles: &mut RenderedTiles,
    plan: &PartTiles,
    part: &RenderedPart,
    channels: &[Channel],
) {
    let area = (tiles.side * tiles.side) as usize;
    let place = |values: &[f32], len: usize, batch: &mut [f32]| {
        for (values, tile) in values.chunks_exact(len).zip(&plan.tiles) {
            batch[tile.place * len..][..len].copy_from_slice(values);
        }
    };
    place(&part.pixels, 3 * area, &mut tiles.data);
    for (channel, values) in channels.iter().zip(&part.channels) {
        let all = tiles.channels.get_mut(channel).expect("made by `zeros`");
        place(values, channel.planes() * area, all);
    }
    tiles.report.add(&part.report);
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
