//! Rendering with Gaussians that are dealt to ranks, so that no rank holds them all.
//!
//! A pixel's C and S (Eq. 12) are sums over Gaussians, and nothing is sorted: each rank adds up its own, and one sum
//! over the ranks gives the image. Its bits do not depend on the number of ranks. Gaussians are cut into
//! [blocks](organza_core::scene::GAUSSIANS_PER_BLOCK) by index. Each block is added up in f32, by the rank that holds it. The sums of
//! blocks are rounded to multiples of 2^-32 and added as 64-bit integers, which is exact in any order.

use super::renderer::Renderer;
use super::results::{REPORT_NUMBERS, report_from_numbers, report_to_numbers};
use crate::pass::part::{Part, report_of_part};
use crate::scene::device_scene::DeviceScene;
use crate::scene::device_shard::DeviceShard;
use crate::stages::composite::resolve;
use crate::stages::counts::Capacity;
use crate::stages::cut::{PartTiles, PlannedTile};
use muslin_device::memory;
use organza_core::camera::Camera;
use organza_core::error::Result;
use organza_core::ranks::Ranks;
use organza_core::scene::GAUSSIANS_PER_BLOCK;
use organza_core::tile::TileBatch;
use organza_core::{RenderReport, RenderedTiles};

/// Planes of a tile's sums: C and S.
pub(crate) const PLANES: usize = 4;
/// The unit of sums is 2^-32.
const UNITS: f64 = (1_u64 << 32) as f64;
/// Weights and colors are at most 1, so a block's sums are at most its size. What is larger is no sum of theirs.
const LARGEST: f32 = 2.0 * GAUSSIANS_PER_BLOCK as f32;
/// The most samples of parts that are kept for the gradient: about 2 GiB of tables.
const KEPT_SAMPLES: u64 = 1 << 24;
/// Pixels that are resolved at once.
const RESOLVED_PIXELS: usize = 1 << 22;

impl Renderer {
    /// Renders a batch of tiles together with other ranks: each has its shard of the same scene, and the same batch,
    /// and gets all tiles. The report counts what all ranks did.
    ///
    /// The tiles differ from those of [`Renderer::render`] by rounding: by 2^-32 for each block, and because a pixel's
    /// sum begins anew with each.
    ///
    /// # Errors
    /// The same errors as [`Renderer::render`]; [`Error::Rank`](organza_core::Error::Rank) where another rank has
    /// failed. The caller [tells](Ranks::fail) the others of its own.
    pub fn render_shard(
        &self,
        shard: &DeviceShard,
        cameras: &[Camera],
        batch: &TileBatch,
        ranks: &dyn Ranks,
    ) -> Result<RenderedTiles> {
        batch.validate(cameras)?;
        Ok(self.shard_forward(shard, cameras, batch, ranks, false)?.tiles)
    }

    /// Renders a shard's blocks, and adds up the sums of all ranks; with `keep`, keeps what the gradient needs.
    pub(crate) fn shard_forward(
        &self,
        shard: &DeviceShard,
        cameras: &[Camera],
        batch: &TileBatch,
        ranks: &dyn Ranks,
        keep: bool,
    ) -> Result<ShardForward> {
        let mut all = FixedSums::new(batch)?;
        let mut report = RenderReport::default();
        let mut parts = Vec::with_capacity(shard.blocks().len());
        let mut room = if keep { KEPT_SAMPLES } else { 0 };
        for block in shard.blocks() {
            let render = |room: &mut u64| self.block_sums(block, cameras, batch, keep, room);
            let (sums, found, of_slice) = match render(&mut room) {
                Err(error) if error.is_out_of_memory() && room < KEPT_SAMPLES && keep => {
                    // parts that were kept may be what takes the memory
                    room = 0;
                    let kept = parts.iter_mut().flatten();
                    kept.for_each(|part: &mut KeptPart| part.part = None);
                    render(&mut room)?
                }
                result => result?,
            };
            all.add(&sums);
            report.add(&found);
            parts.push(of_slice);
        }
        let (sums, report) = all.finish(ranks, report)?;
        let mut tiles = RenderedTiles::new(batch, &[])?;
        tiles.data = self.resolve_sums(&shard.fields, batch, &sums)?;
        tiles.report = report;
        Ok(ShardForward { tiles, sums, parts })
    }

    /// C and S of a block, `[K, 4, S, S]`, and its parts. Parts are kept as long as there is `room` for their samples.
    fn block_sums(
        &self,
        block: &DeviceScene,
        cameras: &[Camera],
        batch: &TileBatch,
        keep: bool,
        room: &mut u64,
    ) -> Result<(Vec<f32>, RenderReport, Vec<KeptPart>)> {
        let device = self.device();
        let len = PLANES * (batch.side * batch.side) as usize;
        self.in_parts(block, batch, |plans| {
            let mut sums = memory::zeros(batch.tiles.len() * len, "the sums of a block")?;
            let mut report = RenderReport::default();
            let mut parts = Vec::new();
            let mut left = *room;
            // plans are last first
            for plan in plans.iter().rev() {
                let render = |capacity: Option<Capacity>| {
                    let part = Part::evaluate(block, cameras, plan, keep, capacity)?;
                    let buffers = vec![part.composite.sum.view(), part.bins.degenerate.view()];
                    let (values, needed) = part.read(device, buffers)?;
                    Ok(((part, values, needed), needed))
                };
                let work = || self.with_predicted_capacity(block, plan, render);
                let (part, values, needed) = device.run_in_pool(work)?;
                let found = report_of_part(values[1][0], needed);
                let values: &[f32] = bytemuck::cast_slice(&values[0]);
                for (values, tile) in values.chunks_exact(len).zip(&plan.tiles) {
                    sums[tile.place * len..][..len].copy_from_slice(values);
                }
                report.add(&found);
                let samples = [found.pairs, found.samples];
                let takes = found.pairs + found.samples;
                let is_kept = keep && takes <= left;
                left -= if is_kept { takes } else { 0 };
                let part = is_kept.then_some(part);
                parts.push(KeptPart { plan: plan.clone(), samples, part });
            }
            *room = left;
            Ok((sums, report, parts))
        })
    }

    /// Eq. 13 of all sums.
    fn resolve_sums(
        &self,
        scene: &DeviceScene,
        batch: &TileBatch,
        sums: &[f32],
    ) -> Result<Vec<f32>> {
        let device = self.device();
        let background = scene.config.background;
        let divide_above = scene.divide_above;
        let mut image = memory::reserve(sums.len() / PLANES * 3, "the rendered batch")?;
        for (plan, sums) in resolved_at_once(batch, sums) {
            let sum = device.upload("sums", sums)?;
            let tile = device.upload("tiles", &plan.pack().0)?;
            let of_part = device.run_in_pool(|| {
                resolve(device, background, divide_above, plan.side, &tile, &sum)
            })?;
            image.extend(device.read(&of_part)?);
        }
        Ok(image)
    }
}

/// A part of a batch, of one block.
#[derive(Debug)]
pub(crate) struct KeptPart {
    pub plan: PartTiles,
    /// Those of the color and of the transmittance field.
    pub samples: [u64; 2],
    /// None where it is rendered again.
    pub part: Option<Part>,
}

/// A batch that ranks have rendered.
#[derive(Debug)]
pub(crate) struct ShardForward {
    pub tiles: RenderedTiles,
    /// `[K, 4, S, S]`: C and S of all Gaussians.
    pub sums: Vec<f32>,
    /// Of each block.
    pub parts: Vec<Vec<KeptPart>>,
}

/// Parts of a batch, in its order, with their sums.
fn resolved_at_once<'a>(
    batch: &'a TileBatch,
    sums: &'a [f32],
) -> impl Iterator<Item = (PartTiles, &'a [f32])> {
    let area = (batch.side * batch.side) as usize;
    let most = (RESOLVED_PIXELS / area).max(1);
    batch.tiles.chunks(most).zip(sums.chunks(most * PLANES * area)).map(|(tiles, sums)| {
        let tiles = tiles.iter().enumerate();
        let tiles = tiles.map(|(place, &tile)| PlannedTile { tile, place }).collect();
        (PartTiles { side: batch.side, tiles }, sums)
    })
}

/// Sums of blocks, in units of 2^-32.
struct FixedSums {
    /// `[K, 4, S, S]`
    values: Vec<i64>,
    /// A bit for each value: whether some block's was NaN, infinite or too large.
    odd: Vec<u32>,
}

impl FixedSums {
    fn new(batch: &TileBatch) -> Result<Self> {
        let len = batch.tiles.len() * PLANES * (batch.side * batch.side) as usize;
        let odd = vec![0; len.div_ceil(32)];
        Ok(Self { values: memory::zeros(len, "the sums of a batch")?, odd })
    }

    fn add(&mut self, values: &[f32]) {
        for (index, (sum, &value)) in self.values.iter_mut().zip(values).enumerate() {
            if value.abs() <= LARGEST {
                *sum += (f64::from(value) * UNITS).round_ties_even() as i64;
            } else {
                self.odd[index / 32] |= 1 << (index % 32);
            }
        }
    }

    /// Adds what all ranks have.
    fn finish(
        mut self,
        ranks: &dyn Ranks,
        report: RenderReport,
    ) -> Result<(Vec<f32>, RenderReport)> {
        let len = self.values.len();
        self.values.extend(report_to_numbers(report).map(|number| number as i64));
        ranks.sum(&mut self.values)?;
        ranks.or(&mut self.odd)?;
        let (values, numbers) = self.values.split_at(len);
        let numbers: [i64; REPORT_NUMBERS] = numbers.try_into().expect("as many as were added");
        let report = report_from_numbers(numbers.map(|number| number as u64));
        let value = |(index, &sum): (usize, &i64)| {
            let is_odd = self.odd[index / 32] >> (index % 32) & 1 == 1;
            // the product is exact
            if is_odd { f32::NAN } else { sum as f32 * (1.0 / UNITS) as f32 }
        };
        Ok((values.iter().enumerate().map(value).collect(), report))
    }
}

/// Bytes that a rank hands over for a batch of tiles: an i64 and a bit for each of `[K, 4, S, S]`, and the report.
#[must_use]
pub fn shard_bytes(tiles: usize, side: u32) -> u64 {
    let values = tiles * PLANES * (side * side) as usize;
    (8 * (values + REPORT_NUMBERS) + 4 * values.div_ceil(32)) as u64
}

#[cfg(test)]
mod tests {
    use super::*;
    use organza_core::ranks::ThreadRanks;
    use organza_core::tile::Tile;

    /// Any order gives the same sums; what is no number stays none.
    #[test]
    fn sums_do_not_depend_on_the_order() {
        let batch = TileBatch { side: 4, tiles: vec![Tile { camera: 0, origin: [0, 0] }] };
        let blocks: Vec<Vec<f32>> = (0..5)
            .map(|block| {
                (0..64).map(|at| (1.7_f32 * block as f32 + at as f32).sin() * 1e3).collect()
            })
            .collect();
        let sums = |order: &[usize], odd: f32| {
            let mut sums = FixedSums::new(&batch).expect("sums");
            for &block in order {
                let mut values = blocks[block].clone();
                values[7] = if block == 2 { odd } else { values[7] };
                sums.add(&values);
            }
            let ranks = ThreadRanks::new(1).remove(0);
            let report = RenderReport { pairs: 3, ..RenderReport::default() };
            let (sums, found) = sums.finish(&ranks, report).expect("sums");
            assert_eq!(found, report);
            sums
        };
        let found = sums(&[0, 1, 2, 3, 4], 0.5);
        assert_eq!(found, sums(&[3, 1, 4, 2, 0], 0.5));
        for (at, found) in found.iter().enumerate().filter(|(at, _)| *at != 7) {
            let exact: f64 = blocks.iter().map(|values| f64::from(values[at])).sum();
            assert!(
                (f64::from(*found) - exact).abs() < 1e-7 * exact.abs() + 1e-9,
                "{found} {exact}"
            );
        }
        for odd in [f32::NAN, f32::INFINITY, 1e9] {
            let found = sums(&[4, 2, 0], odd);
            assert!(found[7].is_nan() && found.iter().filter(|sum| sum.is_nan()).count() == 1);
        }
    }
}
