//! Cuts a batch into parts that fit the device.

use organza_shaders::limits::{MAX_CAMERAS, MAX_TILES};
use organza_shaders::project::WINDOW;
use organza_shaders::tile::Tile as KernelTile;

use crate::scene::device_scene::DeviceScene;
use muslin_device::{Error, Result};
use organza_core::tile::{Tile, TileBatch};

/// Bytes of one part's tables, unless a GPU's share is more. Parts of this size keep a CPU busy.
pub const PART_BYTES: u64 = 512 << 20;
/// The share of a GPU's memory for these tables. A part's other buffers take about eight times as much.
pub const PART_SHARES: u64 = 16;

/// One part of a batch: tiles ordered by camera.
#[derive(Clone, Debug)]
pub struct PartTiles {
    pub side: u32,
    pub tiles: Vec<PartTile>,
}

/// A tile and its place in the batch.
#[derive(Clone, Copy, Debug)]
pub struct PartTile {
    pub tile: Tile,
    pub place: usize,
    /// The number of its [view batch](crate::pass::batch), ascending with the camera.
    pub view: usize,
}

/// Sorts a batch's tiles by camera. A view batch has at most `max_tiles` tiles of one camera.
pub fn by_camera(batch: &TileBatch, max_tiles: usize) -> Vec<PartTile> {
    let tiles = batch.tiles.iter().enumerate();
    let mut tiles: Vec<_> = tiles.map(|(place, &tile)| PartTile { tile, place, view: 0 }).collect();
    tiles.sort_by_key(|tile| tile.tile.camera);
    let by_camera = tiles.chunk_by_mut(|a, b| a.tile.camera == b.tile.camera);
    for (view, tiles) in by_camera.flat_map(|tiles| tiles.chunks_mut(max_tiles)).enumerate() {
        tiles.iter_mut().for_each(|tile| tile.view = view);
    }
    tiles
}

/// Cuts tiles, sorted by camera, into parts of as many tiles as fit.
pub fn cut(
    scene: &DeviceScene,
    side: u32,
    tiles: &[PartTile],
    part_bytes: u64,
) -> Result<Vec<PartTiles>> {
    let limits = Limits::new(scene, side, part_bytes)?;
    let views = tiles.chunk_by(|a, b| a.view == b.view);
    let mut parts: Vec<PartTiles> = Vec::new();
    let mut cameras = 0;
    for view in views.flat_map(|tiles| tiles.chunks(limits.tiles)) {
        match parts.last_mut() {
            Some(part)
                if part.tiles.len() + view.len() <= limits.tiles
                    && part.tiles[part.tiles.len() - 1].tile.camera != view[0].tile.camera
                    && cameras < limits.cameras =>
            {
                part.tiles.extend(view);
                cameras += 1;
            }
            _ => {
                parts.push(PartTiles { side, tiles: view.to_vec() });
                cameras = 1;
            }
        }
    }
    Ok(parts)
}

impl PartTiles {
    /// The tiles' places in the batch.
    pub fn places(&self) -> Vec<usize> {
        self.tiles.iter().map(|tile| tile.place).collect()
    }

    /// Pixels of a tile.
    pub fn area(&self) -> usize {
        (self.side * self.side) as usize
    }

    /// The cameras of the part, ascending. Kernels number them in this order.
    pub fn cameras(&self) -> Vec<usize> {
        let mut cameras: Vec<_> = self.tiles.iter().map(|tile| tile.tile.camera).collect();
        cameras.dedup();
        cameras
    }

    /// The smallest rectangle of each camera's image that contains its tiles.
    pub fn windows(&self) -> Vec<[f32; WINDOW]> {
        let window = |tiles: &[PartTile]| {
            let origins = |axis: usize| tiles.iter().map(move |tile| tile.tile.origin[axis]);
            let low = |axis| origins(axis).min().unwrap_or(0) as f32;
            let high = |axis| origins(axis).max().unwrap_or(0) as f32 + self.side as f32;
            [low(0), low(1), high(0), high(1)]
        };
        self.tiles.chunk_by(|a, b| a.tile.camera == b.tile.camera).map(window).collect()
    }

    /// The tiles as kernels read them, and the index of each camera's first tile.
    pub fn pack(&self) -> (Vec<i32>, Vec<u32>) {
        let cameras = self.cameras();
        let mut packed = Vec::with_capacity(self.tiles.len() * KernelTile::INTEGERS);
        let mut first_tile = vec![0; cameras.len() + 1];
        let mut camera = 0;
        for (index, part_tile) in self.tiles.iter().enumerate() {
            if cameras[camera] != part_tile.tile.camera {
                camera += 1;
                first_tile[camera] = index as u32;
            }
            let tile = KernelTile {
                camera: camera as u32,
                origin: part_tile.tile.origin,
                output: index as u32,
            };
            packed.extend(tile.pack());
        }
        first_tile[cameras.len()] = self.tiles.len() as u32;
        (packed, first_tile)
    }
}

/// The values of some tiles, in the order of their places, from a batch's `[K, len]`.
pub(crate) fn values_of_tiles(values: &[f32], places: &[usize], len: usize) -> Vec<f32> {
    places.iter().flat_map(|place| &values[place * len..][..len]).copied().collect()
}

/// Words of a tile's mask, a bit for each Gaussian.
pub fn words(gaussians: u32) -> u32 {
    gaussians.div_ceil(32)
}

/// Limits of a part.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    pub tiles: usize,
    cameras: usize,
}

impl Limits {
    pub fn new(scene: &DeviceScene, side: u32, part_bytes: u64) -> Result<Self> {
        let buffer = scene.device().max_buffer_bytes();
        let most = scene.all().map(|scene| scene.gaussians).max().unwrap_or(0);
        let gaussians = u64::from(most);
        // projection: two vectors for each Gaussian and camera; pairs are numbered in 31 bits
        let camera_bytes = gaussians * 32;
        let max_cameras =
            (buffer / camera_bytes).min((1 << 31) / gaussians).min(u64::from(MAX_CAMERAS));
        let cameras = (part_bytes / camera_bytes).max(1).min(max_cameras);
        // sums: a vector for each pixel; masks: a word for every 32 Gaussians, at most 2^26 of them; intersections: 31 bits
        let tile_bytes = u64::from(side * side) * 16;
        let mask_words = u64::from(words(most));
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
}
