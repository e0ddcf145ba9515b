//! Cuts a batch into parts that fit the device.

use organza_shaders::limits::{MAX_CAMERAS, MAX_TILES};
use organza_shaders::project::WINDOW;
use organza_shaders::tile::Tile as KernelTile;

use crate::scene::device_scene::DeviceScene;
use muslin_device::{Error, Result};
use organza_core::tile::{Tile, TileBatch};

/// The memory of one part's tables, unless told otherwise. Parts of this size keep every device busy.
pub const PART_BYTES: u64 = 512 << 20;

/// One part of a batch: tiles ordered by camera.
#[derive(Clone, Debug)]
pub struct PartTiles {
    pub side: u32,
    pub tiles: Vec<PlannedTile>,
}

/// A tile and its place in the batch.
#[derive(Clone, Copy, Debug)]
pub struct PlannedTile {
    pub tile: Tile,
    pub place: usize,
}

impl PartTiles {
    /// The parts of a batch, last first.
    pub fn split(scene: &DeviceScene, batch: &TileBatch, part_bytes: u64) -> Result<Vec<Self>> {
        let limits = Limits::new(scene, batch.side, part_bytes)?;
        let mut parts = limits.join(&limits.view_batches(batch));
        parts.reverse();
        Ok(parts)
    }

    /// The view batches of a batch: its tiles by camera, and those of a camera cut where they are too many for a part.
    pub fn view_batches(
        scene: &DeviceScene,
        batch: &TileBatch,
        part_bytes: u64,
    ) -> Result<(Vec<Self>, Limits)> {
        let limits = Limits::new(scene, batch.side, part_bytes)?;
        Ok((limits.view_batches(batch), limits))
    }

    /// Two parts of half the size, last first.
    pub fn halves(mut self) -> [Self; 2] {
        let second = self.tiles.split_off(self.tiles.len() / 2);
        [Self { side: self.side, tiles: second }, self]
    }

    /// The cameras of the part, ascending: their places are the kernels' camera slots.
    pub fn cameras(&self) -> Vec<usize> {
        let mut cameras: Vec<_> = self.tiles.iter().map(|tile| tile.tile.camera).collect();
        cameras.dedup();
        cameras
    }

    /// The smallest part of each camera's image that holds its tiles.
    pub fn windows(&self) -> Vec<[f32; WINDOW]> {
        let of_camera = |tiles: &[PlannedTile]| {
            let origins = |axis: usize| tiles.iter().map(move |tile| tile.tile.origin[axis]);
            let low = |axis| origins(axis).min().unwrap_or(0) as f32;
            let high = |axis| origins(axis).max().unwrap_or(0) as f32 + self.side as f32;
            [low(0), low(1), high(0), high(1)]
        };
        self.tiles.chunk_by(|a, b| a.tile.camera == b.tile.camera).map(of_camera).collect()
    }

    /// The tiles as kernels see them, and where each camera's begin.
    pub fn pack(&self) -> (Vec<i32>, Vec<u32>) {
        let cameras = self.cameras();
        let mut packed = Vec::with_capacity(self.tiles.len() * KernelTile::INTEGERS);
        let mut first_tile = vec![0; cameras.len() + 1];
        let mut slot = 0;
        for (index, planned) in self.tiles.iter().enumerate() {
            if cameras[slot] != planned.tile.camera {
                slot += 1;
                first_tile[slot] = index as u32;
            }
            let tile = KernelTile {
                camera: slot as u32,
                origin: planned.tile.origin,
                output: index as u32,
            };
            packed.extend(tile.pack());
        }
        first_tile[cameras.len()] = self.tiles.len() as u32;
        (packed, first_tile)
    }
}

/// The part of a batch's values `[K, len]` that belongs to a part's tiles, in their order.
pub(crate) fn values_of_tiles(values: &[f32], tiles: &[PlannedTile], len: usize) -> Vec<f32> {
    tiles.iter().flat_map(|tile| &values[tile.place * len..][..len]).copied().collect()
}

/// Words of a tile's mask, a bit for each Gaussian.
pub fn words(gaussians: u32) -> u32 {
    gaussians.div_ceil(32)
}

/// The most that a part has.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    tiles: usize,
    cameras: usize,
}

impl Limits {
    fn new(scene: &DeviceScene, side: u32, part_bytes: u64) -> Result<Self> {
        let buffer = scene.device().max_buffer_bytes();
        let gaussians = u64::from(scene.gaussians);
        // projection: two vectors for each Gaussian and camera; pairs are numbered in 31 bits
        let camera_bytes = gaussians * 32;
        let most_cameras =
            (buffer / camera_bytes).min((1 << 31) / gaussians).min(u64::from(MAX_CAMERAS));
        let cameras = (part_bytes / camera_bytes).max(1).min(most_cameras);
        // sums: a vector for each pixel; masks: a word for every 32 Gaussians, at most 2^26 of them; memberships: 31 bits
        let tile_bytes = u64::from(side * side) * 16;
        let mask_words = u64::from(words(scene.gaussians));
        let per_part = part_bytes / (tile_bytes + mask_words * 12);
        let bound = (buffer / tile_bytes)
            .min((1 << 26) / mask_words)
            .min((1 << 31) / gaussians)
            .min(u64::from(MAX_TILES));
        if cameras == 0 || bound == 0 {
            return Err(Error::OutOfMemory {
                needed: camera_bytes.max(tile_bytes),
                available: Some(buffer),
                what: format!("a buffer for one tile of side {side} and {gaussians} Gaussians"),
            });
        }
        Ok(Self { tiles: per_part.max(1).min(bound) as usize, cameras: cameras as usize })
    }

    /// The tiles of a batch by camera, as parts of one camera each.
    fn view_batches(&self, batch: &TileBatch) -> Vec<PartTiles> {
        let tiles = batch.tiles.iter().enumerate();
        let mut tiles: Vec<_> = tiles.map(|(place, &tile)| PlannedTile { tile, place }).collect();
        tiles.sort_by_key(|tile| tile.tile.camera);
        let of_cameras = tiles.chunk_by(|a, b| a.tile.camera == b.tile.camera);
        let views = of_cameras.flat_map(|tiles| tiles.chunks(self.tiles));
        views.map(|tiles| PartTiles { side: batch.side, tiles: tiles.to_vec() }).collect()
    }

    /// Joins parts of one camera each, as many as fit into each part, in their order.
    pub fn join(&self, views: &[PartTiles]) -> Vec<PartTiles> {
        let mut parts: Vec<PartTiles> = Vec::new();
        let mut cameras = 0;
        for view in views {
            match parts.last_mut() {
                Some(part)
                    if part.tiles.len() + view.tiles.len() <= self.tiles
                        && cameras < self.cameras =>
                {
                    part.tiles.extend(&view.tiles);
                    cameras += 1;
                }
                _ => {
                    parts.push(view.clone());
                    cameras = 1;
                }
            }
        }
        parts
    }
}
