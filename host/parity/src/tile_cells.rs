//! The case of `tile_cells`.

use muslin_check::prelude::*;
use organza_shaders::composite::CompositeInputs;
use organza_shaders::tile_cells::{TileCellsInputs, TileCellsParams};

use super::composite::{Composite, SIDES, sets, tiles};

case!(pub TileCells(TileCellsInputs));

impl TileCells {
    fn new(Composite(forward): Composite) -> Self {
        let side = forward.params.side;
        let CompositeInputs { tile, tile_first, member, splat, .. } = forward;
        let tiles = tile_first.len() as u32 - 1;
        let members = member.len();
        Self(TileCellsInputs {
            params: TileCellsParams { members: members as u32, tiles, side },
            tile,
            tile_first,
            member,
            splat,
            cells: unwritten(members),
        })
    }
}

impl Parity for TileCells {
    const KERNEL: &'static str = "tile_cells";
    const TOLERANCE: f64 = 0.0;
    const WHY: &'static str = "bits; of what is compared, each has one rounding";

    fn sets() -> Vec<(String, Self)> {
        let sides = SIDES.into_iter().chain([64, 65, 200]);
        let mut sets = sets(sides, 33, |side, fill| Self::new(Composite::filled(side, fill, 1)));
        sets.push(("no members".into(), Self::new(Composite::new(8, &[0], Fill::Random, 3))));
        sets
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        runner.run(&self.kernel(), self.params.members, 1)
    }

    /// The cells that have pixel centers within a splat's extent.
    fn exact(&self, _: &str, _: usize) -> Vec<Option<f64>> {
        // pixels: 4 cells of whole vectors of 16 across, 8 down
        let size = [16 * self.params.side.div_ceil(64), self.params.side.div_ceil(8)];
        let tiles = tiles();
        let splats = self.splat.as_chunks::<3>().0;
        let cells = |(place, &member): (usize, &u32)| {
            let tile = self.tile_first.partition_point(|&first| first as usize <= place) - 1;
            let [placed, conic, _] = splats[member as usize].map(|v| v.as_dvec4());
            let center = [placed.x, placed.y];
            let extent = [placed.w, conic.w];
            let mut bits = 0_u32;
            for cell in 0..32 {
                let beyond = [0, 1].map(|axis| {
                    let number = [cell % 4, cell / 4][axis];
                    let low = f64::from(tiles[tile].origin[axis]);
                    let first = low + f64::from(number * size[axis]) + 0.5;
                    let last = first + f64::from(size[axis] - 1);
                    (first - center[axis]).max(center[axis] - last).max(0.0) - extent[axis]
                });
                // where they are about the same, rounding decides
                let is_close = |axis: usize| {
                    beyond[axis].abs() < 1e-6 * (4000.0 + center[axis].abs() + extent[axis])
                };
                if is_close(0) || is_close(1) {
                    return None;
                }
                bits |= u32::from(beyond.into_iter().all(|beyond| beyond < 0.0)) << cell;
            }
            Some(f64::from(bits))
        };
        self.member.iter().enumerate().map(cells).collect()
    }
}
