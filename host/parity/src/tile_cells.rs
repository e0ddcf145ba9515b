//! The case of `tile_cells`.

use muslin_check::prelude::*;
use organza_shaders::composite::CompositeInputs;
use organza_shaders::tile_cells::{TileCellsInputs, TileCellsParams};

use super::composite::{Composite, SIDES, tiles};

case!(pub TileCells(TileCellsInputs));

impl TileCells {
    fn new(Composite(forward): Composite) -> Self {
        let side = forward.params.side;
        let CompositeInputs { tile, tile_first, intersection, splat, .. } = forward;
        let tiles = tile_first.len() as u32 - 1;
        let intersections = intersection.len();
        Self(TileCellsInputs {
            params: TileCellsParams { intersections: intersections as u32, tiles, side },
            tile,
            tile_first,
            intersection,
            splat,
            cells: unwritten(intersections),
        })
    }
}

impl Parity for TileCells {
    fn sets() -> Vec<(String, Self)> {
        let sides = SIDES.into_iter().chain([64, 65, 200]);
        let mut sets =
            inputs::sets_of(sides, 33, |side, fill, _| Self::new(Composite::filled(side, fill, 1)));
        sets.push(("no intersections".into(), Self::new(Composite::new(8, &[0], Fill::Random, 3))));
        sets
    }

    /// The cells that have pixel centers within a splat's extent.
    fn exact(&self, _: &str, _: usize) -> Vec<Option<Rounded>> {
        // pixels: 4 cells of whole vectors of 16 across, 8 down
        let size = [16 * self.params.side.div_ceil(64), self.params.side.div_ceil(8)];
        let tiles = tiles();
        let splats = self.splat.as_chunks::<3>().0;
        let cells = |(place, &intersection): (usize, &u32)| {
            let tile = self.tile_first.partition_point(|&first| first as usize <= place) - 1;
            let [placed, conic, _] = splats[intersection as usize];
            let centers = [placed.x, placed.y].map(Rounded::from);
            let extents = [placed.w, conic.w].map(Rounded::from);
            let reached = |axis: usize, number: u32| {
                let first =
                    f64::from(tiles[tile].origin[axis]) + f64::from(number * size[axis]) + 0.5;
                let last = first + f64::from(size[axis] - 1);
                let [before, behind] =
                    [Rounded::from(first) - centers[axis], centers[axis] - last.into()];
                (extents[axis] - before.max(behind).max(0.0.into())).is_above(0.0)
            };
            let mut bits = 0_u32;
            for cell in 0..32 {
                let [across, down] = [reached(0, cell % 4), reached(1, cell / 4)];
                let (Some(across), Some(down)) = (across, down) else { return Rounded::UNKNOWN };
                bits |= u32::from(across && down) << cell;
            }
            bits.into()
        };
        listed(self.intersection.iter().enumerate().map(cells))
    }
}
