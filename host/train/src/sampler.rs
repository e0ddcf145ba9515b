//! Draws the tiles that a step trains on.

use rand::seq::SliceRandom;
use rand::{Rng, RngExt};

use super::config::{LossConfig, RunConfig};
use muslin_device::memory;
use organza_core::camera::Camera;
use organza_core::error::Result;
use organza_core::random;
use organza_core::tile::{Tile, TileBatch};
use organza_data::{Frame, Photograph, mean};
use organza_render::LossTarget;

const SHUFFLE: u64 = 1;

/// Draws tiles. In each epoch, a randomly shifted grid covers every image. The cells of each grid form groups of
/// neighbors, and the groups of all images are shuffled. So every pixel comes once per epoch, and the tiles of a step
/// only depend on the seed and the step.
#[derive(Debug)]
pub struct Sampler {
    side: u32,
    seed: u64,
    /// Number of cells in a group.
    group: usize,
    /// Number of groups in a step.
    groups_per_step: usize,
    /// Width and height of each image.
    sizes: Vec<[u32; 2]>,
    /// Number of groups in an epoch.
    groups: usize,
    /// The epoch used last, and its groups.
    epoch: Option<(u64, Vec<Vec<Tile>>)>,
}

/// Number of cells that cover `length` pixels for every shift of the grid. One cell that covers all pixels is enough.
fn cells(length: u32, side: u32) -> u32 {
    if side >= length { 1 } else { (length + side - 1).div_ceil(side) }
}

impl Sampler {
    /// A sampler for images of these sizes. A tile's camera is the index of its image here.
    #[must_use]
    pub fn new(sizes: Vec<[u32; 2]>, run: &RunConfig) -> Self {
        let side = run.tile_size;
        let group = run.tiles_per_view as usize;
        let cells =
            |&[width, height]: &[u32; 2]| (cells(width, side) * cells(height, side)) as usize;
        let groups = sizes.iter().map(|size| cells(size).div_ceil(group)).sum();
        let groups_per_step = (run.tiles_per_step as usize / group).max(1);
        Self { side, seed: run.seed, group, groups_per_step, sizes, groups, epoch: None }
    }

    /// A sampler for the photographs of these cameras.
    ///
    /// # Errors
    /// [`DeviceError::OutOfMemory`](organza_core::error::DeviceError::OutOfMemory).
    pub fn from_cameras(cameras: &[Camera], run: &RunConfig) -> Result<Self> {
        let sizes = cameras.iter().map(|camera| [camera.width, camera.height]).collect();
        let sampler = Self::new(sizes, run);
        sampler.check_memory()?;
        Ok(sampler)
    }

    /// Fails if the tiles of an epoch do not fit into memory. With tiles of one pixel, there are as many as pixels.
    ///
    /// # Errors
    /// [`DeviceError::OutOfMemory`](organza_core::error::DeviceError::OutOfMemory).
    fn check_memory(&self) -> Result<()> {
        let cells = |&[width, height]: &[u32; 2]| {
            u64::from(cells(width, self.side)) * u64::from(cells(height, self.side))
        };
        let tiles: u64 = self.sizes.iter().map(cells).sum();
        let bytes = tiles * size_of::<Tile>() as u64 + self.groups as u64 * 32;
        let what = "the tiles of all photographs (a larger `run.tile_size` makes fewer)";
        Ok(memory::check(bytes, what)?)
    }

    /// The tiles of a step.
    pub fn batch(&mut self, step: u32) -> TileBatch {
        let first = u64::from(step) * self.groups_per_step as u64;
        let places = first..first + self.groups_per_step as u64;
        TileBatch { side: self.side, tiles: places.flat_map(|at| self.group(at)).collect() }
    }

    /// The group at a position in the sequence of all epochs.
    fn group(&mut self, at: u64) -> Vec<Tile> {
        let epoch = at / self.groups as u64;
        if self.epoch.as_ref().is_none_or(|(known, _)| *known != epoch) {
            let mut random = random(self.seed, SHUFFLE, epoch);
            let mut groups = Vec::with_capacity(self.groups);
            for camera in 0..self.sizes.len() {
                let grid = self.grid(camera, &mut random);
                groups.extend(grid.chunks(self.group).map(<[Tile]>::to_vec));
            }
            groups.shuffle(&mut random);
            self.epoch = Some((epoch, groups));
        }
        let (_, groups) = self.epoch.as_ref().expect("set above");
        groups[(at % self.groups as u64) as usize].clone()
    }

    /// The cells of an image's grid, shifted at random, row by row.
    fn grid(&self, camera: usize, random: &mut impl Rng) -> Vec<Tile> {
        let side = self.side as i32;
        let [(columns, x), (rows, y)] = self.sizes[camera].map(|length| {
            let shift = random.random_range(0..side);
            let cells = cells(length, self.side);
            (cells, if cells > 1 { -shift } else { 0 })
        });
        let cell = |row: u32, column: u32| [x + column as i32 * side, y + row as i32 * side];
        (0..rows)
            .flat_map(|row| (0..columns).map(move |column| (row, column)))
            .map(|(row, column)| Tile { camera, origin: cell(row, column) })
            .collect()
    }
}

/// The photographs that a batch is compared with.
#[derive(Clone, Debug, PartialEq)]
pub struct Target {
    /// Colors of the photographs, `[K, 3, S, S]`; 0 where there is no pixel.
    pub image: Vec<f32>,
    /// Validity, `[K, S, S]`: 1 where a photograph has a pixel, 0 elsewhere.
    pub valid: Vec<f32>,
    /// Number of valid pixels.
    pub valid_pixels: f64,
}

impl Target {
    /// The photographs behind a batch's tiles. A square of `factor` x `factor` pixels becomes one pixel.
    ///
    /// # Errors
    /// [`DeviceError::OutOfMemory`](organza_core::error::DeviceError::OutOfMemory).
    pub fn new(batch: &TileBatch, factor: u32, frames: &[&Frame]) -> Result<Self> {
        let side = batch.side as usize;
        let area = side * side;
        let mut image = memory::zeros(batch.tiles.len() * 3 * area, "the tiles of a step")?;
        let mut valid = memory::zeros(batch.tiles.len() * area, "the mask of a step")?;
        for ((tile, image), valid) in
            batch.tiles.iter().zip(image.chunks_mut(3 * area)).zip(valid.chunks_mut(area))
        {
            fill(tile, &frames[tile.camera].image, factor, side, image, valid);
        }
        let valid_pixels = valid.iter().map(|&valid| f64::from(valid)).sum();
        Ok(Self { image, valid, valid_pixels })
    }

    /// The target for rendered tiles. `exposure` is that of [`LossTarget`].
    pub fn loss_target<'a>(
        &'a self,
        loss: &LossConfig,
        exposure: Option<&'a [f32]>,
    ) -> LossTarget<'a> {
        let Self { image, valid, valid_pixels } = self;
        let valid_pixels = *valid_pixels;
        let ssim_weight = loss.ssim_weight;
        let distortion_weight = loss.distortion_weight;
        LossTarget { image, valid, valid_pixels, ssim_weight, distortion_weight, exposure }
    }
}

fn fill(
    tile: &Tile,
    photograph: &Photograph,
    factor: u32,
    side: usize,
    image: &mut [f32],
    valid: &mut [f32],
) {
    let area = side * side;
    let [width, height] =
        [photograph.width(), photograph.height()].map(|length| (length / factor) as i32);
    for row in 0..side {
        for column in 0..side {
            let x = tile.origin[0] + column as i32;
            let y = tile.origin[1] + row as i32;
            let is_inside = (0..width).contains(&x) && (0..height).contains(&y);
            let texel = |x, y| photograph.is_valid(x, y).then(|| photograph.color(x, y));
            let square = || mean([x, y].map(|at| at as u32 * factor), factor, texel);
            let color = if is_inside { square() } else { None };
            if let Some(color) = color {
                let at = row * side + column;
                valid[at] = 1.0;
                for (channel, value) in color.into_iter().enumerate() {
                    image[channel * area + at] = value;
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use std::collections::HashMap;

    use super::*;

    fn sampler(tiles_per_step: u32, tiles_per_view: u32) -> Sampler {
        let run = RunConfig {
            tile_size: 4,
            tiles_per_step,
            tiles_per_view,
            seed: 11,
            ..Default::default()
        };
        Sampler::new(vec![[7, 5], [16, 9], [3, 3]], &run)
    }

    /// The number of times that each pixel comes in `steps` steps.
    fn visits(sampler: &mut Sampler, steps: u32) -> HashMap<(usize, i32, i32), u32> {
        let mut visits = HashMap::new();
        for step in 0..steps {
            for tile in sampler.batch(step).tiles {
                let [width, height] = sampler.sizes[tile.camera].map(|length| length as i32);
                for (row, column) in (0..4).flat_map(|row| (0..4).map(move |column| (row, column)))
                {
                    let x = tile.origin[0] + column;
                    let y = tile.origin[1] + row;
                    if (0..width).contains(&x) && (0..height).contains(&y) {
                        *visits.entry((tile.camera, x, y)).or_default() += 1;
                    }
                }
            }
        }
        visits
    }

    #[test]
    fn every_pixel_comes_once_an_epoch() {
        let pixels = 7 * 5 + 16 * 9 + 3 * 3;
        let mut tiles = sampler(11, 1);
        assert_eq!(tiles.groups, 3 * 2 + 5 * 3 + 1);
        // five epochs of 22 tiles, eleven tiles a step
        let seen = visits(&mut tiles, 10);
        assert!(seen.len() == pixels && seen.values().all(|&times| times == 5), "{seen:?}");
        // whole images, and groups of four: two, four and one of them
        for (tiles_per_view, steps) in [(100, 6), (4, 14)] {
            let seen = visits(&mut sampler(4, tiles_per_view), steps);
            assert!(seen.len() == pixels && seen.values().all(|&times| times == 2), "{seen:?}");
        }
    }

    #[test]
    fn a_smaller_target_has_means_of_squares() {
        // 5 x 4 pixels: the last column belongs to no square; one pixel is not valid
        let pixels: Vec<_> = (0..20_u8).map(|at| [at, 2 * at, 100 + at]).collect();
        let valid = (0..20).map(|at| at != 7).collect();
        let image = Photograph::new([5, 4], pixels, Some(valid)).expect("a photograph");
        let camera = organza_core::demo::turntable(1, 8).remove(0);
        let frame = Frame { name: String::new(), camera, image };
        let tiles = vec![Tile { camera: 0, origin: [-1, 0] }];
        let target = Target::new(&TileBatch { side: 3, tiles }, 2, &[&frame]).expect("a target");
        // pixels of the image are 0 1 / 2 3; those of square 1 are 2, 3, 7 and 8
        assert_eq!(target.valid, [0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0]);
        assert_eq!(target.valid_pixels, 3.0);
        let red = [(1, [0, 1, 5, 6]), (4, [10, 11, 15, 16]), (5, [12, 13, 17, 18])];
        for (at, square) in red {
            let mean = square.into_iter().sum::<i32>() as f32 / 4.0 / 255.0;
            for (channel, expected) in [mean, 2.0 * mean, mean + 100.0 / 255.0].iter().enumerate() {
                assert!((target.image[9 * channel + at] - expected).abs() < 1e-6, "{at}");
            }
        }
    }

    #[test]
    fn a_step_is_drawn_alike_whatever_came_before() {
        let mut all = sampler(5, 1);
        let batches: Vec<_> = (0..20).map(|step| all.batch(step)).collect();
        let mut late = sampler(5, 1);
        for step in [19, 3, 12] {
            assert_eq!(late.batch(step), batches[step as usize]);
        }
        assert_ne!(batches[0], batches[5]);
    }
}
