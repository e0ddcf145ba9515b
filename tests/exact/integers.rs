//! Eq. 14 and 15, and what counts, scans and lists members: integers that must be right to the bit.

use organza::parity::pair::{PairFill, PairMask};
use organza::parity::scan::{ScanAdd, ScanBlock};
use organza::parity::tile::{TileFill, TileMask, TileRange};
use organza::parity::tile_cells::TileCells;
use organza_check::Rounding;

use super::hold::{hold, hold_all};

/// Values of a workgroup of the scan.
const BLOCK: usize = 1024;

/// The bits of a row of words, from the lowest on.
fn members(words: &[u32]) -> impl Iterator<Item = usize> {
    (0..32 * words.len()).filter(|&bit| words[bit / 32] >> (bit % 32) & 1 == 1)
}

#[test]
fn masks_are_the_gaussians_within_reach() {
    hold::<TileMask>(|set, output, index| {
        let words = set.gaussians.div_ceil(32) as usize;
        let tile = (words > 0).then(|| set.tiles.get(index / words)).flatten()?;
        let is_member = |gaussian: usize| {
            if gaussian >= set.gaussians as usize {
                return false;
            }
            let slot = (tile.camera * set.gaussians) as usize + gaussian;
            let p = set.projection[2 * slot].as_dvec4();
            // dist(x, B_t), to the closed box
            let outside = |x: f64, low: i32| {
                let low = f64::from(low);
                (low - x).max(x - low - f64::from(set.side)).max(0.0)
            };
            let distance = outside(p.x, tile.origin[0]).hypot(outside(p.y, tile.origin[1]));
            p.z >= 0.0 && distance <= p.z * 1.001 + 0.01
        };
        // squares of more are no f32: such a Gaussian may be a member of any tile
        let is_told = |gaussian: usize| {
            let slot =
                (tile.camera * set.gaussians) as usize + gaussian.min(set.gaussians as usize - 1);
            set.projection[2 * slot].truncate().abs().max_element() < 1e18
        };
        let bits = 32 * (index % words)..32 * (index % words) + 32;
        if !bits.clone().all(is_told) {
            return None;
        }
        let mask =
            bits.enumerate().fold(0_u32, |mask, (bit, g)| mask | u32::from(is_member(g)) << bit);
        Some(f64::from(if output == "mask" { mask } else { mask.count_ones() }))
    });
}

#[test]
fn members_are_ascending_places_among_the_pairs() {
    hold_all(Rounding::AsWritten, |set: &TileFill, _, _| {
        // a pair's number is its place among those of its camera, behind those of the cameras before
        let row = |table: &[u32], row: usize| {
            members(&table[row * set.words as usize..][..set.words as usize]).collect::<Vec<_>>()
        };
        let pairs = [row(&set.pair_mask, 0), row(&set.pair_mask, 1)];
        let place = |camera: usize, gaussian: &usize| {
            let place = pairs[camera].binary_search(gaussian).expect("members are pairs");
            Some((place + pairs[..camera].iter().map(Vec::len).sum::<usize>()) as f64)
        };
        let tiles = set.tiles.iter().enumerate();
        tiles
            .flat_map(|(t, tile)| {
                let members = row(&set.tile_mask, t);
                members.iter().map(|g| place(tile.camera as usize, g)).collect::<Vec<_>>()
            })
            .collect()
    });
}

#[test]
fn cells_are_those_of_the_members_extents() {
    hold::<TileCells>(|set, _, index| {
        let place = u32::try_from(index).expect("few members");
        let splat = &set.splat[*set.member.get(index)? as usize];
        let tile = set.tile_first.partition_point(|&first| first <= place) - 1;
        let [x, y] = set.tiles[tile].origin.map(f64::from);
        let (placed, conic) = (splat[0].as_dvec4(), splat[1].as_dvec4());
        // pixels: 4 cells of whole vectors of 16 across, 8 down
        let (width, height) = (16 * set.side.div_ceil(64), set.side.div_ceil(8));
        let distance = |center: f64, low: f64, cell: u32, size: u32| {
            let first = low + f64::from(cell * size) + 0.5;
            let last = first + f64::from(size - 1);
            (first - center).max(center - last).max(0.0)
        };
        let mut bits = 0_u32;
        for cell in 0..32 {
            let across = distance(placed.x, x, cell % 4, width) - placed.w;
            let down = distance(placed.y, y, cell / 4, height) - conic.w;
            // what is rounded decides where they are about the same
            let size = |center: f64, extent: f64| 1e-6 * (4000.0 + center.abs() + extent);
            if across.abs() < size(placed.x, placed.w) || down.abs() < size(placed.y, conic.w) {
                return None;
            }
            bits |= u32::from(across < 0.0 && down < 0.0) << cell;
        }
        Some(f64::from(bits))
    });
}

#[test]
fn tiles_begin_where_their_first_words_do() {
    hold::<TileRange>(|set, _, tile| {
        let is_tile = tile <= set.tiles as usize;
        is_tile.then(|| f64::from(set.first_member[tile * set.words as usize]))
    });
}

#[test]
fn pairs_are_the_union_of_a_cameras_tiles() {
    hold::<PairMask>(|set, output, index| {
        let words = set.words as usize;
        let camera = index.checked_div(words)?;
        let end = *set.first_tile.get(camera + 1)? as usize;
        let tiles = set.first_tile[camera] as usize..end;
        let mask = tiles.fold(0, |mask, t| mask | set.tile_mask[t * words + index % words]);
        Some(f64::from(if output == "mask" { mask } else { mask.count_ones() }))
    });
}

#[test]
fn pairs_are_listed_by_camera_and_gaussian() {
    hold_all(Rounding::AsWritten, |set: &PairFill, _, _| {
        // the words of both cameras follow each other, and so do their pairs
        members(&set.mask).map(|pair| Some(pair as f64)).collect()
    });
}

#[test]
fn blocks_are_scanned_from_zero() {
    hold::<ScanBlock>(|set, output, index| {
        let count = set.values.len();
        let sum = |range: std::ops::Range<usize>| {
            let values = &set.values[range.start.min(count)..range.end.min(count)];
            values.iter().map(|&value| f64::from(value)).sum()
        };
        match output {
            "prefix" => (index <= count).then(|| sum(index / BLOCK * BLOCK..index)),
            _ => (index <= count / BLOCK).then(|| sum(index * BLOCK..(index + 1) * BLOCK)),
        }
    });
}

#[test]
fn blocks_are_added_up() {
    hold::<ScanAdd>(|set, _, index| {
        let before = *set.block_prefix.get(index / BLOCK)?;
        Some(f64::from(set.prefix.get(index)? + before))
    });
}
