//! Eq. 12, 13 and 16: splats, sums and pixels.

use organza::parity::composite::Composite;
use organza::parity::resolve::Resolve;
use organza::parity::splat::Splat;
use organza_check::Rounding;

use super::hold::{hold, hold_to};

#[test]
fn splats_are_gathered() {
    hold::<Splat>(|set, _, index| {
        let (pair, part) = (index / 12, index % 12);
        let slot = *set.pair.get(pair)? as usize;
        let opacity = f64::from(set.opacity[slot % set.gaussians as usize]);
        Some(match part {
            0 | 1 | 3 => f64::from(set.projection[2 * slot][part]),
            2 => f64::from(set.transmittance[pair]) / (1.0 + (-opacity).exp()),
            4..8 => f64::from(set.projection[2 * slot + 1][part - 4]),
            8..11 => f64::from(set.color[3 * pair + part - 8]),
            _ => 0.0,
        })
    });
}

#[test]
fn sums_are_those_of_the_members() {
    let cutoff = 2.0 * 255f64.ln();
    // thousands of members add up their roundings
    hold_to::<Composite>(Rounding::Regrouped, |set, _, index| {
        let (at, channel) = (index / 4, index % 4);
        let initial = f64::from(set.sum.get(at)?[channel]);
        let side = set.side as usize;
        let (tile, row, column) = (at / side / side, at / side % side, at % side);
        let [left, top] = set.tiles[tile].origin.map(f64::from);
        let (x, y) = (left + column as f64 + 0.5, top + row as f64 + 0.5);
        let begin = set.tile_first[tile] as usize + set.skip as usize;
        let end = (set.tile_first[tile + 1] as usize).min(begin + 16_384);
        let members = set.member.get(begin..end).unwrap_or(&[]);
        let terms = members.iter().map(|&member| {
            let [placed, conic, color] = set.splat[member as usize].map(|v| v.as_dvec4());
            let (dx, dy) = (x - placed.x, y - placed.y);
            let q = conic.x * dx * dx + 2.0 * conic.y * dx * dy + conic.z * dy * dy;
            let falloff = if q <= cutoff { (-q.max(0.0) / 2.0).exp() } else { 0.0 };
            placed.z * falloff * if channel == 3 { 1.0 } else { color[channel] }
        });
        Some(initial + terms.sum::<f64>())
    });
}

#[test]
fn pixels_are_normalized_or_over_the_background() {
    hold::<Resolve>(|set, _, index| {
        let area = (set.side * set.side) as usize;
        // Y [K, 3, S, S], each tile at its own place of the batch
        let (place, channel, at) = (index / (3 * area), index / area % 3, index % area);
        let tile = set.tiles.iter().position(|tile| tile.output as usize == place)?;
        let sum = set.sum[tile * area + at].as_dvec4();
        let background = f64::from(set.background[channel]);
        Some(match sum.w > 1.0 {
            true => sum[channel] / sum.w,
            false => sum[channel] + (1.0 - sum.w) * background,
        })
    });
}
