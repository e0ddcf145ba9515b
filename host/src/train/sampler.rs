//! Which tiles a step trains on.

use rand::seq::SliceRandom;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

use super::config::Sampling;
use crate::data::Frame;
use crate::tile::{Tile, TileBatch};

/// Independent random numbers for each purpose and time: whoever resumes draws the same.
#[must_use]
pub fn random(seed: u64, purpose: u64, time: u64) -> Pcg64 {
    // splitmix64's increment and an odd constant keep neighbors apart; the generator's own seeding mixes them
    let mixed = seed
        .wrapping_add(purpose.wrapping_mul(0x9e37_79b9_7f4a_7c15))
        .wrapping_add(time.wrapping_mul(0xd134_2543_de82_ef95));
    Pcg64::seed_from_u64(mixed)
}

const SHUFFLE: u64 = 1;

/// Draws tiles.  Each epoch lays a grid over every image, shifted at random, and shuffles the cells of all: every
/// pixel comes once an epoch, and a step's tiles are a function of the seed and the step alone.
#[derive(Debug)]
pub struct Sampler {
    side: u32,
    per_step: usize,
    seed: u64,
    sampling: Sampling,
    /// Width and height of each image.
    sizes: Vec<[u32; 2]>,
    /// Cells of an epoch's grids.
    cells: usize,
    /// The epoch that was used last, and its tiles.
    epoch: Option<(u64, Vec<Tile>)>,
}

/// Cells that cover `length` pixels wherever the grid begins.
fn cells(length: u32, side: u32) -> u32 {
    (length + side - 1).div_ceil(side)
}

impl Sampler {
    /// For images of these sizes; a tile's camera is its image's index here.
    #[must_use]
    pub fn new(
        sizes: Vec<[u32; 2]>,
        side: u32,
        per_step: u32,
        seed: u64,
        sampling: Sampling,
    ) -> Self {
        let per_image =
            |&[width, height]: &[u32; 2]| (cells(width, side) * cells(height, side)) as usize;
        let cells = sizes.iter().map(per_image).sum();
        Self { side, per_step: per_step as usize, seed, sampling, sizes, cells, epoch: None }
    }

    /// The tiles of a step.
    pub fn batch(&mut self, step: u32) -> TileBatch {
        let tiles = match self.sampling {
            Sampling::Tiles => {
                let first = u64::from(step) * self.per_step as u64;
                (first..first + self.per_step as u64).map(|at| self.tile(at)).collect()
            }
            Sampling::Images => self.image(step),
        };
        TileBatch { side: self.side, tiles }
    }

    /// The tile at a place of the sequence of all epochs.
    fn tile(&mut self, at: u64) -> Tile {
        let epoch = at / self.cells as u64;
        if self.epoch.as_ref().is_none_or(|(known, _)| *known != epoch) {
            let mut random = random(self.seed, SHUFFLE, epoch);
            let mut tiles = Vec::with_capacity(self.cells);
            for camera in 0..self.sizes.len() {
                tiles.extend(self.grid(camera, &mut random));
            }
            tiles.shuffle(&mut random);
            self.epoch = Some((epoch, tiles));
        }
        let (_, tiles) = self.epoch.as_ref().expect("set above");
        tiles[(at % self.cells as u64) as usize]
    }

    /// The cells of an image's grid, shifted at random.
    fn grid(&self, camera: usize, random: &mut Pcg64) -> Vec<Tile> {
        let [columns, rows] = self.sizes[camera].map(|length| cells(length, self.side));
        let side = self.side as i32;
        let [x, y] = [0, 0].map(|_: i32| -random.random_range(0..side));
        let cell = |row: u32, column: u32| [x + column as i32 * side, y + row as i32 * side];
        (0..rows)
            .flat_map(|row| (0..columns).map(move |column| (row, column)))
            .map(|(row, column)| Tile { camera, origin: cell(row, column) })
            .collect()
    }

    /// All tiles of an image; each image comes once an epoch.
    fn image(&self, step: u32) -> Vec<Tile> {
        let count = self.sizes.len() as u32;
        let mut random = random(self.seed, SHUFFLE, u64::from(step / count));
        let mut order: Vec<_> = (0..self.sizes.len()).collect();
        order.shuffle(&mut random);
        self.grid(order[(step % count) as usize], &mut random)
    }
}

/// What a batch is compared with.
#[derive(Clone, Debug, PartialEq)]
pub struct Target {
    /// `[K, 3, S, S]`: the photographs; 0 where there is no pixel.
    pub image: Vec<f32>,
    /// `[K, S, S]`: 1 where a photograph has a pixel, 0 elsewhere.
    pub valid: Vec<f32>,
    /// How many are 1.
    pub valid_pixels: f64,
}

impl Target {
    /// The photographs behind a batch's tiles.
    #[must_use]
    pub fn of(batch: &TileBatch, frames: &[&Frame]) -> Self {
        let side = batch.side as usize;
        let area = side * side;
        let mut image = vec![0.0; batch.tiles.len() * 3 * area];
        let mut valid = vec![0.0; batch.tiles.len() * area];
        for ((tile, image), valid) in
            batch.tiles.iter().zip(image.chunks_mut(3 * area)).zip(valid.chunks_mut(area))
        {
            fill(tile, &frames[tile.camera].image, side, image, valid);
        }
        let valid_pixels = valid.iter().map(|&valid| f64::from(valid)).sum();
        Self { image, valid, valid_pixels }
    }
}

fn fill(
    tile: &Tile,
    photograph: &crate::data::Photograph,
    side: usize,
    image: &mut [f32],
    valid: &mut [f32],
) {
    let area = side * side;
    let [width, height] = [photograph.width() as i32, photograph.height() as i32];
    for row in 0..side {
        for column in 0..side {
            let (x, y) = (tile.origin[0] + column as i32, tile.origin[1] + row as i32);
            let is_inside = (0..width).contains(&x) && (0..height).contains(&y);
            if is_inside && photograph.is_valid(x as u32, y as u32) {
                let at = row * side + column;
                valid[at] = 1.0;
                for (channel, value) in photograph.color(x as u32, y as u32).into_iter().enumerate()
                {
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

    fn sampler(sampling: Sampling) -> Sampler {
        Sampler::new(vec![[7, 5], [16, 9], [3, 3]], 4, 5, 11, sampling)
    }

    /// How often each pixel comes in a number of steps.
    fn visits(sampler: &mut Sampler, steps: u32) -> HashMap<(usize, i32, i32), u32> {
        let mut visits = HashMap::new();
        for step in 0..steps {
            for tile in sampler.batch(step).tiles {
                let [width, height] = sampler.sizes[tile.camera].map(|length| length as i32);
                for (row, column) in (0..4).flat_map(|row| (0..4).map(move |column| (row, column)))
                {
                    let (x, y) = (tile.origin[0] + column, tile.origin[1] + row);
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
        let mut tiles = sampler(Sampling::Tiles);
        assert_eq!(tiles.cells, 3 * 2 + 5 * 3 + 2 * 2);
        // five epochs of 25 tiles, five tiles a step
        let seen = visits(&mut tiles, 25);
        assert!(seen.len() == pixels && seen.values().all(|&times| times == 5), "{seen:?}");
        let seen = visits(&mut sampler(Sampling::Images), 6);
        assert!(seen.len() == pixels && seen.values().all(|&times| times == 2), "{seen:?}");
    }

    #[test]
    fn a_step_is_drawn_alike_whatever_came_before() {
        let mut all = sampler(Sampling::Tiles);
        let batches: Vec<_> = (0..20).map(|step| all.batch(step)).collect();
        let mut late = sampler(Sampling::Tiles);
        for step in [19, 3, 12] {
            assert_eq!(late.batch(step), batches[step as usize]);
        }
        assert_ne!(batches[0], batches[5]);
    }
}
