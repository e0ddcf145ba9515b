//! Draws the tiles that a step trains on.

use std::ops::Range;

use rand::seq::SliceRandom;
use rand::{Rng, RngExt};
use rayon::prelude::*;

use super::config::RunConfig;
use muslin_device::memory;
use organza_core::error::Result;
use organza_core::tile::{Tile, TileBatch};
use organza_data::random;
use organza_data::{Frame, Photograph, mean};

const SHUFFLE: u64 = 1;

/// Draws tiles. In each epoch, a randomly shifted grid covers every image. The cells that have a valid pixel form groups, blocks of
/// neighbors, and the groups of all images are shuffled. So every valid pixel comes once per epoch, and the tiles of a
/// step only depend on the photographs, the seed and the step.
#[derive(Debug)]
pub struct Sampler {
    side: u32,
    seed: u64,
    /// Number of cells in a group.
    group: usize,
    /// Number of groups in a step.
    groups_per_step: usize,
    /// Factor by which the images are smaller than the photographs.
    factor: u32,
    /// The epoch used last.
    epoch: Option<Epoch>,
}

#[derive(Debug)]
struct Epoch {
    number: u64,
    /// Position of its first group in the sequence of all epochs.
    first: u64,
    groups: Vec<Vec<Tile>>,
}

/// Number of cells that cover `length` pixels for every shift of the grid. One cell that covers all pixels is enough.
fn cells(length: u32, side: u32) -> u32 {
    if side >= length { 1 } else { (length + side - 1).div_ceil(side) }
}

impl Sampler {
    /// A sampler for photographs, `factor` times smaller. A tile's camera is the index of its photograph. `None` if no pixel is
    /// valid.
    ///
    /// # Errors
    /// [`DeviceError::OutOfMemory`](organza_core::error::DeviceError::OutOfMemory).
    pub fn new(frames: &[&Frame], factor: u32, run: &RunConfig) -> Result<Option<Self>> {
        let side = run.tile_size;
        let group = run.tiles_per_view as usize;
        let groups_per_step = (run.tiles_per_step as usize / group).max(1);
        let sampler = Self { side, seed: run.seed, group, groups_per_step, factor, epoch: None };
        sampler.check_memory(frames)?;
        let whole = |frame: &&Frame| has_pixel(&frame.image, factor, [[0, i32::MAX]; 2]);
        Ok(frames.iter().any(whole).then_some(sampler))
    }

    /// Fails if the tiles of an epoch do not fit into memory. With tiles of one pixel, there are as many as pixels.
    fn check_memory(&self, frames: &[&Frame]) -> Result<()> {
        let cells = |frame: &&Frame| {
            let [columns, rows] =
                sides(&frame.image, self.factor).map(|side| cells(side, self.side));
            u64::from(columns) * u64::from(rows)
        };
        let groups = |frame: &&Frame| cells(frame).div_ceil(self.group as u64);
        let tiles: u64 = frames.iter().map(cells).sum();
        let groups: u64 = frames.iter().map(groups).sum();
        let bytes = tiles * size_of::<Tile>() as u64 + groups * 32;
        let what = "the tiles of all photographs (a larger `run.tile_size` makes fewer)";
        Ok(memory::check(bytes, what)?)
    }

    /// The tiles of a step. `frames` are the same as for [`Self::new`].
    pub fn batch(&mut self, step: u32, frames: &[&Frame]) -> TileBatch {
        let first = u64::from(step) * self.groups_per_step as u64;
        let places = first..first + self.groups_per_step as u64;
        let tiles = places.flat_map(|at| self.group(at, frames)).collect();
        TileBatch { side: self.side, tiles }
    }

    /// The group at a position in the sequence of all epochs. An epoch's number of groups depends on the shifts of its grids.
    /// So an epoch's first position depends on all earlier epochs.
    fn group(&mut self, at: u64, frames: &[&Frame]) -> Vec<Tile> {
        let mut epoch = match self.epoch.take() {
            Some(epoch) if epoch.first <= at => epoch,
            _ => self.shuffled(0, 0, frames),
        };
        while at - epoch.first >= epoch.groups.len() as u64 {
            epoch =
                self.shuffled(epoch.number + 1, epoch.first + epoch.groups.len() as u64, frames);
        }
        let group = epoch.groups[(at - epoch.first) as usize].clone();
        self.epoch = Some(epoch);
        group
    }

    fn shuffled(&self, number: u64, first: u64, frames: &[&Frame]) -> Epoch {
        let mut random = random(self.seed, SHUFFLE, number);
        let mut groups = Vec::new();
        for (camera, frame) in frames.iter().enumerate() {
            let grid = self.grid(camera, &frame.image, &mut random);
            groups.extend(grid.chunks(self.group).map(<[Tile]>::to_vec));
        }
        groups.shuffle(&mut random);
        Epoch { number, first, groups }
    }

    /// The cells of an image's grid that have a valid pixel. The grid is shifted at random. The cells are ordered so that a group of neighbors
    /// in the list is a compact block of the image: bands of rows go to the right and to the left in turns, and a band is as high as a square
    /// of a group's cells. Single cells come row by row.
    fn grid(&self, camera: usize, image: &Photograph, random: &mut impl Rng) -> Vec<Tile> {
        let side = self.side as i32;
        let [(columns, x), (rows, y)] = sides(image, self.factor).map(|length| {
            let shift = random.random_range(0..side);
            let cells = cells(length, self.side);
            (cells, if cells > 1 { -shift } else { 0 })
        });
        let height = self.group.isqrt() as u32;
        let along = |&[column, row]: &[u32; 2]| {
            let band = row / height;
            let is_reversed = self.group > 1 && band % 2 == 1;
            (band, if is_reversed { columns - 1 - column } else { column }, row)
        };
        let is_used = |&[x, y]: &[i32; 2]| {
            has_pixel(
                image,
                self.factor,
                [[x, x.saturating_add(side)], [y, y.saturating_add(side)]],
            )
        };
        let mut cells: Vec<_> =
            (0..rows).flat_map(|row| (0..columns).map(move |column| [column, row])).collect();
        cells.sort_by_key(along);
        cells
            .into_iter()
            .map(|[column, row]| [x + column as i32 * side, y + row as i32 * side])
            .filter(is_used)
            .map(|origin| Tile { camera, origin })
            .collect()
    }
}

/// Width and height of an image that is `factor` times smaller than a photograph.
fn sides(photograph: &Photograph, factor: u32) -> [u32; 2] {
    [photograph.width() / factor, photograph.height() / factor]
}

/// Clamps ranges of columns and rows to an image that is `factor` times smaller than a photograph.
fn within(photograph: &Photograph, factor: u32, ranges: [[i32; 2]; 2]) -> [Range<u32>; 2] {
    let sides = sides(photograph, factor);
    std::array::from_fn(|axis| {
        let [from, to] = ranges[axis].map(|at| (at.max(0) as u32).min(sides[axis]));
        from..to.max(from)
    })
}

/// Whether a pixel of an image that is `factor` times smaller than a photograph is valid: all pixels of the photograph that it is the mean of must be.
fn is_valid(photograph: &Photograph, factor: u32, x: u32, y: u32) -> bool {
    let square = |at: u32| at * factor..(at + 1) * factor;
    square(y).all(|row| square(x).all(|column| photograph.is_valid(column, row)))
}

/// Whether an image, `factor` times smaller than a photograph, has a valid pixel in ranges of columns and of rows.
fn has_pixel(photograph: &Photograph, factor: u32, ranges: [[i32; 2]; 2]) -> bool {
    let [columns, mut rows] = within(photograph, factor, ranges);
    if photograph.all_valid() {
        return !columns.is_empty() && !rows.is_empty();
    }
    rows.any(|y| columns.clone().any(|x| is_valid(photograph, factor, x, y)))
}

/// How many pixels of a batch's tiles are valid.
pub fn valid_pixels(batch: &TileBatch, factor: u32, frames: &[&Frame]) -> usize {
    let side = batch.side as i32;
    let of_tile = |tile: &Tile| {
        let photograph = &frames[tile.camera].image;
        let [columns, rows] =
            within(photograph, factor, tile.origin.map(|at| [at, at.saturating_add(side)]));
        if photograph.all_valid() {
            return columns.len() * rows.len();
        }
        let of_row = |y| columns.clone().filter(|&x| is_valid(photograph, factor, x, y)).count();
        rows.map(of_row).sum()
    };
    batch.tiles.iter().map(of_tile).sum()
}

/// The photographs that a batch is compared with.
#[derive(Clone, Debug, PartialEq)]
pub struct Target {
    /// Colors of the photographs, `[K, 3, S, S]`; 0 where there is no pixel.
    pub image: Vec<f32>,
    /// Validity, `[K, S, S]`: 1 where a photograph has a pixel, 0 elsewhere.
    pub valid: Vec<f32>,
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
        let images = image.par_chunks_mut(3 * area).zip(valid.par_chunks_mut(area));
        batch.tiles.par_iter().zip(images).for_each(|(tile, (image, valid))| {
            fill(tile, &frames[tile.camera].image, factor, side, image, valid);
        });
        Ok(Self { image, valid })
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
    let ranges = tile.origin.map(|at| [at, at.saturating_add(side as i32)]);
    let [columns, rows] = within(photograph, factor, ranges);
    let texel = |x, y| photograph.is_valid(x, y).then(|| photograph.color(x, y));
    for y in rows {
        for x in columns.clone() {
            if let Some(color) = mean([x * factor, y * factor], factor, texel) {
                let [column, row] = [x as i32 - tile.origin[0], y as i32 - tile.origin[1]];
                let at = row as usize * side + column as usize;
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

    const SIZES: [[u32; 2]; 3] = [[7, 5], [16, 9], [3, 3]];

    /// Photographs of these sizes. `is_valid` is asked for each pixel: photograph, column and row.
    fn photographs(sizes: &[[u32; 2]], is_valid: fn(usize, u32, u32) -> bool) -> Vec<Frame> {
        let photograph = |(index, &[width, height]): (usize, &[u32; 2])| {
            let count = (width * height) as usize;
            let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
            let valid = pixels.map(|(x, y)| is_valid(index, x, y)).collect();
            let image = Photograph::new([width, height], vec![[0; 3]; count], Some(valid));
            let camera = organza_core::demo::turntable(1, 8).remove(0);
            Frame { name: String::new(), camera, image: image.expect("a photograph") }
        };
        sizes.iter().enumerate().map(photograph).collect()
    }

    fn sampler(
        frames: &[&Frame],
        factor: u32,
        tiles_per_step: u32,
        tiles_per_view: u32,
    ) -> Sampler {
        let run = RunConfig {
            tile_size: 4,
            tiles_per_step,
            tiles_per_view,
            seed: 11,
            ..Default::default()
        };
        Sampler::new(frames, factor, &run).expect("memory").expect("a valid pixel")
    }

    /// The number of times that each pixel of a photograph comes before the second epoch ends.
    fn visits(sampler: &mut Sampler, frames: &[&Frame]) -> HashMap<(usize, i32, i32), u32> {
        let mut visits = HashMap::new();
        for at in 0.. {
            let tiles = sampler.group(at, frames);
            if sampler.epoch.as_ref().is_some_and(|epoch| epoch.number == 2) {
                break;
            }
            for tile in tiles {
                let mut count = 0;
                let image = &frames[tile.camera].image;
                let [width, height] = sides(image, sampler.factor).map(|side| side as i32);
                for (row, column) in (0..4).flat_map(|row| (0..4).map(move |column| (row, column)))
                {
                    let x = tile.origin[0] + column;
                    let y = tile.origin[1] + row;
                    let factor = sampler.factor as i32;
                    let is_valid = |x: i32, y: i32| {
                        let square = (0..factor).flat_map(|v| (0..factor).map(move |u| (u, v)));
                        let mut square = square.map(|(u, v)| [x * factor + u, y * factor + v]);
                        square.all(|[x, y]| image.is_valid(x as u32, y as u32))
                    };
                    if (0..width).contains(&x) && (0..height).contains(&y) && is_valid(x, y) {
                        *visits.entry((tile.camera, x, y)).or_default() += 1;
                        count += 1;
                    }
                }
                assert!(count > 0, "a tile without a valid pixel: {tile:?}");
            }
        }
        visits
    }

    #[test]
    fn every_valid_pixel_comes_once_an_epoch_and_no_tile_is_without_one() {
        let all = photographs(&SIZES, |_, _, _| true);
        // the first image, a corner of the second, nothing of the third
        let part = photographs(&SIZES, |at, x, y| at == 0 || (at == 1 && x >= 9 && y < 2));
        for (frames, factor, pixels) in [
            (&all, 1, 7 * 5 + 16 * 9 + 3 * 3),
            (&all, 2, 3 * 2 + 8 * 4 + 1),
            (&part, 1, 7 * 5 + 7 * 2),
            (&part, 2, 3 * 2 + 3),
        ] {
            let frames: Vec<_> = frames.iter().collect();
            // single tiles, whole images, and groups of four
            for tiles_per_view in [1, 100, 4] {
                let seen = visits(&mut sampler(&frames, factor, 4, tiles_per_view), &frames);
                assert_eq!(seen.len(), pixels);
                assert!(seen.values().all(|&times| times == 2), "{seen:?}");
            }
        }
        let none = photographs(&SIZES, |_, x, y| (x + y) % 2 == 0);
        let none: Vec<_> = none.iter().collect();
        let of = |factor| Sampler::new(&none, factor, &RunConfig::default()).expect("memory");
        assert!(of(1).is_some() && of(2).is_none());
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
        let batch = TileBatch { side: 3, tiles };
        let target = Target::new(&batch, 2, &[&frame]).expect("a target");
        // pixels of the image are 0 1 / 2 3; pixel 1 is the mean of 2, 3, 7 and 8
        assert_eq!(target.valid, [0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0]);
        assert_eq!(valid_pixels(&batch, 2, &[&frame]), 3);
        let red = [(1, [0, 1, 5, 6]), (4, [10, 11, 15, 16]), (5, [12, 13, 17, 18])];
        for (at, square) in red {
            let mean = square.into_iter().sum::<i32>() as f32 / 4.0 / 255.0;
            for (channel, expected) in [mean, 2.0 * mean, mean + 100.0 / 255.0].iter().enumerate() {
                assert!((target.image[9 * channel + at] - expected).abs() < 1e-6, "{at}");
            }
        }
    }

    #[test]
    fn batches_do_not_depend_on_earlier_steps() {
        let frames = photographs(&SIZES, |_, _, _| true);
        let frames: Vec<_> = frames.iter().collect();
        let mut all = sampler(&frames, 1, 5, 1);
        let batches: Vec<_> = (0..20).map(|step| all.batch(step, &frames)).collect();
        let mut late = sampler(&frames, 1, 5, 1);
        for step in [19, 3, 12] {
            assert_eq!(late.batch(step, &frames), batches[step as usize]);
        }
        assert_ne!(batches[0], batches[5]);
    }
}
