//! The case of `tile_cells`.

use glam::Vec4;
use organza_shaders::tile::Tile;
use organza_shaders::tile_cells::{TileCellsKernel, TileCellsParams};

use super::bench::Bench;
use super::case::Parity;
use super::composite::{Composite, SIDES};
use super::inputs::Fill;
use super::measure::Output;
use super::tile::pack;
use organza_device::Result;

/// Inputs of `tile_cells`.
#[derive(Clone, Debug)]
pub struct TileCells {
    /// S
    pub side: u32,
    /// The tiles.
    pub tiles: Vec<Tile>,
    /// `[tiles + 1]`
    pub tile_first: Vec<u32>,
    /// Indices of splats.
    pub member: Vec<u32>,
    /// `[splats, 3]`
    pub splat: Vec<[Vec4; 3]>,
}

impl TileCells {
    fn new(side: u32, members: &[u32], fill: Fill, seed: u64) -> Self {
        let Composite { tiles, tile_first, member, splat, .. } =
            Composite::new(side, members, fill, seed);
        Self { side, tiles, tile_first, member, splat }
    }
}

impl Parity for TileCells {
    const KERNEL: &'static str = "tile_cells";
    const TOLERANCE: f64 = 0.0;
    const WHY: &'static str = "bits; of what is compared, each has one rounding";

    fn sets() -> Vec<(String, Self)> {
        let random =
            |side| (format!("random, side {side}"), Self::new(side, &[40, 0, 90], Fill::Random, 1));
        let mut sets: Vec<_> = SIDES.into_iter().chain([64, 65, 200]).map(random).collect();
        for fill in Fill::ADVERSARIAL {
            let set = Self::new(33, &[1, 60, 60], fill, 2);
            sets.push((format!("{}, side 33", fill.name()), set));
        }
        sets.push(("no members".into(), Self::new(8, &[0], Fill::Random, 3)));
        sets
    }

    fn run(&self, bench: &Bench<'_>) -> Result<Vec<Output>> {
        let members = self.member.len() as u32;
        let cells = bench.output(self.member.len())?;
        let kernel = TileCellsKernel {
            params: TileCellsParams { members, tiles: self.tiles.len() as u32, side: self.side },
            tile: &bench.upload(&pack(&self.tiles))?,
            tile_first: &bench.upload(&self.tile_first)?,
            member: &bench.upload(&self.member)?,
            splat: &bench.upload(self.splat.as_flattened())?,
            cells: &cells,
        };
        bench.items(&kernel, members, 1)?;
        Ok(vec![Output::exact("cells", bench.read(&cells)?)])
    }
}
