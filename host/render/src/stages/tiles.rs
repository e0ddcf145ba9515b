//! Which Gaussians each tile needs, in ascending order.

use glam::Vec4;
use organza_shaders::count::{GRADIENTS, INTERSECTIONS, PAIRS, SAMPLES};
use organza_shaders::tile::{
    TileFillKernel, TileFillParams, TileMaskKernel, TileMaskParams, TileRangeKernel,
    TileRangeParams,
};

use super::counts::PartCounts;
use super::cut::{PartTiles, words};
use super::pairs::{Pairs, camera_ends, fill_pairs, pair_mask};
use super::project::Projection;
use super::scan::{Mask, total};
use crate::scene::device_scene::DeviceScene;
use muslin_device::{Buffer, Count, Device, Result};

/// Which pairs each tile sums up.
#[derive(Debug)]
pub struct TileBins {
    pub pairs: Pairs,
    /// Side of a tile, in pixels.
    pub side: u32,
    /// The part's cameras, as indices into the batch's list.
    pub cameras: Vec<u32>,
    pub tiles: u32,
    pub tile: Buffer<i32>,
    /// Where each camera's tiles begin.
    pub first_tile: Buffer<u32>,
    /// `[tiles, words]`: the Gaussians that reach each tile.
    pub tile_mask: Mask,
    /// `[cameras, words]`: the Gaussians that each camera's tiles need.
    pub pair_mask: Mask,
    /// Where each tile's intersections begin.
    pub tile_first: Buffer<u32>,
    /// Indices of pairs.
    pub intersection: Buffer<u32>,
    /// Intersections of all tiles.
    pub intersections: Count,
    /// Intersections of the fullest tile, or more.
    pub largest: u32,
    /// The counts on the device, if the host has not waited for them.
    pub part_counts: Option<PartCounts>,
    /// Gaussians that could not be projected.
    pub degenerate: Buffer<u32>,
}

/// Which Gaussians reach which tiles (Eq. 15): `[tiles, words]`.
fn tile_mask(
    device: &Device,
    params: TileMaskParams,
    tile: &Buffer<i32>,
    tiles: u32,
    projection: &Buffer<Vec4>,
) -> Result<Mask> {
    let len = (tiles * params.words) as usize;
    let mask = device.unwritten("tile masks", len)?;
    let count = device.unwritten("intersection counts", len)?;
    let kernel = TileMaskKernel { params, tile, projection, mask: &mask, count: &count };
    device.run_all(&kernel)?;
    Mask::new(device, mask, &count)
}

/// How many items the tiles of a part need.
struct Items {
    pairs: Count,
    intersections: Count,
    /// Intersections of the fullest tile, or more.
    largest: u32,
}

impl Items {
    /// Waits for the device.
    fn read(device: &Device, pair_mask: &Mask, tile_first: &Buffer<u32>) -> Result<Self> {
        let first = device.read(tile_first)?;
        let of_tiles = first.windows(2).map(|range| range[1] - range[0]);
        Ok(Self {
            pairs: total(device, &pair_mask.first)?,
            intersections: Count::known(first[first.len() - 1]),
            largest: of_tiles.max().unwrap_or(0),
        })
    }

    /// Leaves the numbers on the device. If one exceeds its capacity, all tables of the part are empty.
    fn on_device(
        counts: &PartCounts,
        device: &Device,
        pair_mask: &Mask,
        tile_mask: &Mask,
        tile_first: &Buffer<u32>,
    ) -> Result<Self> {
        counts.record_total(device, PAIRS, &pair_mask.first)?;
        counts.record_total(device, INTERSECTIONS, &tile_mask.first)?;
        counts.clear_on_overflow(device, &[pair_mask, tile_mask], &[tile_first])?;
        let intersections = counts.count(INTERSECTIONS);
        let largest = intersections.upper_bound();
        Ok(Self { pairs: counts.count(PAIRS), intersections, largest })
    }
}

impl TileBins {
    /// With `part_counts`, nothing waits; if their capacity is too small, the bins are empty. Without, waits for the counts and
    /// has room for everything.
    pub fn new(
        scene: &DeviceScene,
        part_tiles: &PartTiles,
        projection: Projection,
        part_counts: Option<PartCounts>,
    ) -> Result<Self> {
        let device = scene.device();
        let Projection { camera, values: projection, degenerate } = projection;
        let (packed, first_tile) = part_tiles.pack();
        let tile = device.upload("tiles", &packed)?;
        let first_tile = device.upload("first tiles", &first_tile)?;
        let tiles = part_tiles.tiles.len() as u32;
        let cameras: Vec<_> = part_tiles.cameras().into_iter().map(|index| index as u32).collect();
        let gaussians = scene.gaussians;
        let words = words(gaussians);

        let params = TileMaskParams { gaussians, words, side: part_tiles.side };
        let tile_mask = tile_mask(device, params, &tile, tiles, &projection)?;
        let pair_mask = pair_mask(device, words, cameras.len() as u32, &first_tile, &tile_mask)?;
        let tile_first = device.unwritten("tile intersections", tiles as usize + 1)?;
        device.run_all(&TileRangeKernel {
            params: TileRangeParams { tiles, words },
            first_intersection: &tile_mask.first,
            tile_first: &tile_first,
        })?;
        let Items { pairs, intersections, largest } = match &part_counts {
            None => Items::read(device, &pair_mask, &tile_first)?,
            Some(counts) => Items::on_device(counts, device, &pair_mask, &tile_mask, &tile_first)?,
        };

        let pair = fill_pairs(scene, &pair_mask, &pairs)?;
        let intersection =
            device.unwritten("intersections", intersections.upper_bound() as usize)?;
        device.run_all(&TileFillKernel {
            params: TileFillParams { words },
            tile: &tile,
            tile_mask: &tile_mask.bits,
            first_intersection: &tile_mask.first,
            pair_mask: &pair_mask.bits,
            first_pair: &pair_mask.first,
            intersection: &intersection,
        })?;
        let camera_ends = match device.backend() {
            "cpu" => camera_ends(device, &pair_mask, cameras.len() as u32, words)?,
            _ => Vec::new(),
        };
        Ok(Self {
            pairs: Pairs { count: pairs, pair, camera, projection, camera_ends },
            side: part_tiles.side,
            cameras,
            tiles,
            tile,
            first_tile,
            tile_mask,
            pair_mask,
            tile_first,
            intersection,
            intersections,
            // a tile has each Gaussian at most once
            largest: largest.min(gaussians),
            part_counts,
            degenerate,
        })
    }

    /// The number of samples, the last value of `first_sample [pairs + 1]`. `field` is the index of the scene whose field has them, in the
    /// [counts](PartCounts::after): 0 is this scene.
    pub fn count_samples(
        &self,
        device: &Device,
        field: usize,
        first_sample: &Buffer<u32>,
    ) -> Result<Count> {
        let Some(counts) = &self.part_counts else { return total(device, first_sample) };
        let counts = counts.after(field);
        counts.record_total(device, SAMPLES, first_sample)?;
        let ranges = [&self.tile_first, first_sample];
        counts.clear_on_overflow(device, &[&self.pair_mask, &self.tile_mask], &ranges)?;
        Ok(counts.count(SAMPLES))
    }

    /// Records the number of samples that get a gradient, which are some of all samples.
    pub fn count_gradients(&self, device: &Device, first_sample: &Buffer<u32>) -> Result<Count> {
        let Some(counts) = &self.part_counts else { return total(device, first_sample) };
        counts.record_total(device, GRADIENTS, first_sample)?;
        device.publish_counts();
        Ok(counts.count(GRADIENTS))
    }
}
