//! What ranks add up: C and S of pixels, and the gradients of the fields, of poses, and of Gaussians.

use std::ops::Range;

use glam::Vec4;
use organza_shaders::hash_grid_backward::VALUES_PER_FLAG;

use super::part::report_of_part;
use super::pass::{Parts, Pass};
use crate::stages::composite::resolve;
use crate::stages::cut::{PartTiles, PlannedTile};
use crate::stages::field::hash_grid::HashGridGradient;
use crate::{DeviceScene, SceneGradient, TensorGradient};
use muslin_device::{Buffer, Count, Device, memory};
use organza_core::ranks::{Ranks, ThreadRanks};
use organza_core::scene::GAUSSIANS_PER_BLOCK;
use organza_core::{Error, RenderReport, RenderedTiles, Result, TileBatch};

/// Planes of a tile's sums: C and S.
pub const PLANES: usize = 4;
/// The unit of sums is 2^-32.
const UNITS: f64 = (1_u64 << 32) as f64;
/// Weights and colors are at most 1, so a block's sums are at most its size. What is larger is no sum of theirs.
const LARGEST: f32 = 2.0 * GAUSSIANS_PER_BLOCK as f32;
/// Pixels that are resolved at once.
const RESOLVED_PIXELS: usize = 1 << 22;

impl Pass<'_> {
    /// Renders the tiles of a shard, which are the parts, together with the group's other ranks: returns them, and C and S
    /// of all Gaussians, `[K, 4, S, S]`.
    ///
    /// A pixel's C and S (Eq. 12) are sums over Gaussians, and nothing is sorted: each rank adds up its own, and one sum
    /// over the ranks gives the image. Its bits do not depend on the number of ranks. Each block is added up in f32, by
    /// the rank that holds it. The sums of blocks are rounded to multiples of 2^-32 and added as 64-bit integers, which
    /// is exact in any order.
    pub fn forward_sums(
        &self,
        parts: &mut Parts,
        batch: &TileBatch,
        keep: bool,
    ) -> Result<(RenderedTiles, Vec<f32>)> {
        let device = self.renderer.device();
        let group = self.grid.map(|grid| grid.row());
        self.scene.update_occupancy(device, group.as_ref().map(|group| group as &dyn Ranks))?;
        let mut all = FixedSums::new(batch)?;
        let mut report = RenderReport::default();
        self.forward(parts, keep, |plan, part| {
            let buffers = vec![part.composite.sum.view(), part.bins.degenerate.view()];
            let Some((words, needed)) = part.read(device, buffers)? else { return Ok(None) };
            let len = PLANES * plan.area();
            let tiles = bytemuck::cast_slice(&words[0]).chunks_exact(len).zip(&plan.tiles);
            tiles.for_each(|(values, tile)| all.add(tile.place * len, values));
            report.add(&report_of_part(words[1][0], needed));
            Ok(Some(needed))
        })?;
        let (sums, report) = match group {
            Some(group) => all.finish(&group, report)?,
            None => all.finish(&ThreadRanks::alone(), report)?,
        };
        let mut tiles = RenderedTiles::new(batch, &[])?;
        tiles.data = resolve_sums(self.scene.fields, batch, &sums)?;
        tiles.report = report;
        Ok((tiles, sums))
    }
}

/// Eq. 13 of all sums.
fn resolve_sums(scene: &DeviceScene, batch: &TileBatch, sums: &[f32]) -> Result<Vec<f32>> {
    let device = scene.device();
    let background = scene.config.background;
    let divide_above = scene.divide_above;
    let side = batch.side;
    let area = (side * side) as usize;
    let most = (RESOLVED_PIXELS / area).max(1);
    let mut image = memory::reserve(sums.len() / PLANES * 3, "the rendered batch")?;
    for (tiles, sums) in batch.tiles.chunks(most).zip(sums.chunks(most * PLANES * area)) {
        let tiles = tiles.iter().map(|&tile| PlannedTile { tile, place: 0, view: 0 }).collect();
        let sum = device.upload("sums", sums)?;
        let tile = device.upload("tiles", &PartTiles { side, tiles }.pack().0)?;
        let resolve = || resolve(device, background, divide_above, side, &tile, &sum);
        image.extend(device.read(&device.run_in_pool(resolve)?)?);
    }
    Ok(image)
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

    /// Adds the values of a block, from the value `first` on.
    fn add(&mut self, first: usize, values: &[f32]) {
        for (index, &value) in (first..).zip(values) {
            if value.abs() <= LARGEST {
                self.values[index] += (f64::from(value) * UNITS).round_ties_even() as i64;
            } else {
                self.odd[index / 32] |= 1 << (index % 32);
            }
        }
    }

    /// Adds the sums of all ranks.
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

/// How many numbers a report has.
const REPORT_NUMBERS: usize = 5;

/// A report as numbers, for other ranks.
fn report_to_numbers(report: RenderReport) -> [u64; REPORT_NUMBERS] {
    let RenderReport { parts, pairs, members, samples, degenerate } = report;
    [parts as u64, pairs, members, samples, degenerate]
}

/// The report that another rank has sent.
fn report_from_numbers(numbers: [u64; REPORT_NUMBERS]) -> RenderReport {
    let [parts, pairs, members, samples, degenerate] = numbers;
    RenderReport { parts: parts as usize, pairs, members, samples, degenerate }
}

fn tables(gradient: &SceneGradient) -> [&HashGridGradient; 2] {
    [&gradient.color.table, &gradient.transmittance.table]
}

/// One scale for all that ranks will add to the hash grids: its bound is the largest of all ranks' bounds. `samples` are
/// those of the color and of the transmittance field, of this rank.
pub fn set_scales(
    device: &Device,
    ranks: Option<&dyn Ranks>,
    scene: &DeviceScene,
    gradient: &SceneGradient,
    mut samples: [i64; 2],
) -> Result<()> {
    ranks.map_or(Ok(()), |ranks| ranks.sum(&mut samples))?;
    if let Some(ranks) = ranks.filter(|ranks| ranks.size() > 1) {
        let [color, transmittance] = tables(gradient).map(|table| device.read(&table.bound));
        let color = color?;
        let transmittance = transmittance?;
        let mut bounds = [&color[..], &transmittance[..]].concat();
        ranks.max(&mut bounds)?;
        let (first, second) = bounds.split_at(color.len());
        for (table, bound) in tables(gradient).into_iter().zip([first, second]) {
            device.write(&table.bound, 0, bound)?;
        }
    }
    let fields = [&scene.color, &scene.transmittance];
    for ((table, field), samples) in tables(gradient).into_iter().zip(fields).zip(samples) {
        let Ok(samples) = u32::try_from(samples) else {
            let reason = format!(
                "the step has {samples} samples, and their gradients are counted in 32 bits: use fewer tiles in a step"
            );
            return Err(Error::Argument { reason });
        };
        table.set_scale(device, field, &Count::known(samples))?;
    }
    Ok(())
}

/// Adds the sums of all ranks, and makes gradients of them.
pub fn finish(device: &Device, ranks: Option<&dyn Ranks>, gradient: &SceneGradient) -> Result<()> {
    if let Some(ranks) = ranks.filter(|ranks| ranks.size() > 1) {
        sum(device, ranks, gradient)?;
    }
    gradient.finish(device)
}

/// Integers on the device that all ranks have some of.
struct SharedSums<'a> {
    buffer: &'a Buffer<u32>,
    values: Vec<i64>,
    /// Not 0 where a block of [`VALUES_PER_FLAG`] values was added to.
    touched: Vec<u32>,
}

impl<'a> SharedSums<'a> {
    /// `touched` is known of a hash grid. Elsewhere, it says which blocks are not zero.
    fn read(device: &Device, buffer: &'a Buffer<u32>, touched: Option<Vec<u32>>) -> Result<Self> {
        let values: Vec<i64> = bytemuck::pod_collect_to_vec(&device.read(buffer)?);
        let blocks = values.chunks(VALUES_PER_FLAG as usize);
        let look = || blocks.map(|block| u32::from(block.iter().any(|&sum| sum != 0))).collect();
        let touched = touched.unwrap_or_else(look);
        Ok(Self { buffer, values, touched })
    }

    /// The blocks that were touched.
    fn blocks(&mut self) -> impl Iterator<Item = &mut [i64]> {
        let blocks = self.values.chunks_mut(VALUES_PER_FLAG as usize).zip(&self.touched);
        blocks.filter(|(_, touched)| **touched != 0).map(|(block, _)| block)
    }
}

/// Only blocks that some rank has touched travel.
fn sum(device: &Device, ranks: &dyn Ranks, gradient: &SceneGradient) -> Result<()> {
    let mut all = Vec::new();
    let mut flags = Vec::new();
    for table in tables(gradient) {
        let touched = device.read(&table.touched)?;
        all.push(SharedSums::read(device, &table.sum, Some(touched))?);
        flags.extend(device.read(&table.status)?);
    }
    let networks = [&gradient.color.network, &gradient.transmittance.network];
    for binned in networks.into_iter().chain(&gradient.poses) {
        all.push(SharedSums::read(device, &binned.sum, None)?);
    }
    flags.extend(all.iter().flat_map(|sums| &sums.touched));
    ranks.or(&mut flags)?;
    let (status, mut rest) = flags.split_at(tables(gradient).len());
    for sums in &mut all {
        let (touched, after) = rest.split_at(sums.touched.len());
        sums.touched.copy_from_slice(touched);
        rest = after;
    }
    let mut packed = Vec::new();
    all.iter_mut().for_each(|sums| sums.blocks().for_each(|block| packed.extend(&*block)));
    ranks.sum(&mut packed)?;
    let mut rest = &packed[..];
    for sums in &mut all {
        for block in sums.blocks() {
            let (values, after) = rest.split_at(block.len());
            block.copy_from_slice(values);
            rest = after;
        }
        device.write(sums.buffer, 0, bytemuck::cast_slice::<i64, u32>(&sums.values))?;
    }
    for ((table, sums), status) in tables(gradient).into_iter().zip(&all).zip(status) {
        device.write(&table.touched, 0, &sums.touched)?;
        device.write(&table.status, 0, &[*status])?;
    }
    Ok(())
}

/// The gradients of Gaussians, and the statistics of growth, as rows: one for each Gaussian that a view batch has seen.
pub struct Rows<'a> {
    device: &'a Device,
    ranks: &'a dyn Ranks,
    /// All ranks have the same.
    scenes: Vec<SceneRows<'a>>,
    /// For each rank, what goes to it: for each scene and view batch, how many rows follow, and the rows. A row is the Gaussian's
    /// place, its values of all tensors, and its three statistics.
    for_each: Vec<Vec<u32>>,
}

/// The Gaussians of a scene, or of a block of one.
struct SceneRows<'a> {
    gradient: &'a SceneGradient,
    tensors: Vec<&'a TensorGradient>,
    /// Their places among those of all scenes.
    range: Range<usize>,
    /// The statistics before the step.
    before: Vec<Vec4>,
}

/// Values of a Gaussian's statistics that count.
const STATISTICS: usize = 3;

impl<'a> Rows<'a> {
    /// No rows yet. The gradients' statistics are taken, and written back with [`Rows::add`].
    pub fn new(
        device: &'a Device,
        ranks: &'a dyn Ranks,
        gradients: impl IntoIterator<Item = &'a SceneGradient>,
    ) -> Result<Self> {
        let mut scenes = Vec::new();
        let mut end = 0;
        for gradient in gradients {
            let mut tensors = Vec::new();
            gradient.tensors.gaussians.as_ref().map(|tensor| tensors.push(tensor));
            let before = device.read(&gradient.statistics)?;
            device.clear(&gradient.statistics);
            let range = end..end + before.len();
            end = range.end;
            scenes.push(SceneRows { gradient, tensors, range, before });
        }
        Ok(Self { device, ranks, scenes, for_each: vec![Vec::new(); ranks.size()] })
    }

    /// Takes the rows that a view batch has made of a scene from the device.
    pub fn take(&mut self, scene: usize) -> Result<()> {
        let device = self.device;
        let scene = &self.scenes[scene];
        let mut columns = Vec::with_capacity(scene.tensors.len());
        for tensor in &scene.tensors {
            let values = tensor.read(device)?;
            columns.push((values.len() / scene.range.len(), values));
        }
        scene.tensors.iter().for_each(|tensor| device.clear(&tensor.buffer));
        let statistics = device.read(&scene.gradient.statistics)?;
        device.clear(&scene.gradient.statistics);
        let size = self.for_each.len();
        for (rank, rows) in self.for_each.iter_mut().enumerate() {
            let place = rows.len();
            rows.push(0);
            for index in scene.owned(rank, size) {
                let begin = rows.len();
                rows.push((scene.range.start + index) as u32);
                for (width, values) in &columns {
                    let values = &values[index * width..][..*width];
                    rows.extend(values.iter().map(|value| value.to_bits()));
                }
                let statistics = statistics[index].to_array();
                rows.extend(statistics[..STATISTICS].iter().map(|value| value.to_bits()));
                match rows[begin + 1..].iter().any(|&bits| bits != 0) {
                    true => rows[place] += 1,
                    false => rows.truncate(begin),
                }
            }
        }
        Ok(())
    }

    /// Adds the rows of all ranks' view batches in their order, and writes the sums to the gradients.
    pub fn add(mut self, views: usize) -> Result<()> {
        let ranks = self.ranks;
        let bytes = |words: Vec<u32>| bytemuck::cast_slice(&words).to_vec();
        let words = |bytes: &[Vec<u8>]| -> Vec<Vec<u32>> {
            bytes.iter().map(|bytes| bytemuck::pod_collect_to_vec(bytes)).collect()
        };
        let for_each = self.for_each.iter_mut().map(|words| bytes(std::mem::take(words)));
        let received = words(&ranks.exchange(for_each.collect())?);
        let mut rest: Vec<_> = received.iter().map(Vec::as_slice).collect();
        let sums = self.scenes.iter().flat_map(|scene| scene.sum(views, &mut rest, ranks.rank()));
        let sums = words(&ranks.gather(bytes(sums.collect()))?);
        let mut rest: Vec<_> = sums.iter().map(Vec::as_slice).collect();
        self.scenes.iter().try_for_each(|scene| scene.write(self.device, &mut rest))
    }
}

impl SceneRows<'_> {
    /// Values of a row, without the place.
    fn width(&self) -> usize {
        let values: usize = self.tensors.iter().map(|tensor| tensor.range.len()).sum();
        values / self.range.len() + STATISTICS
    }

    /// The Gaussians that a rank owns.
    fn owned(&self, rank: usize, ranks: usize) -> Range<usize> {
        let begin = |rank| self.range.len() * rank / ranks;
        begin(rank)..begin(rank + 1)
    }

    /// The sums of the rows that a rank owns, those that any view batch has. Takes the rows that each rank has sent.
    fn sum(&self, views: usize, rest: &mut [&[u32]], rank: usize) -> Vec<u32> {
        let width = self.width();
        let owned = self.owned(rank, rest.len());
        let first_statistic = width - STATISTICS;
        let mut sums: Vec<f32> = vec![0.0; owned.len() * width];
        for (row, before) in sums.chunks_exact_mut(width).zip(&self.before[owned.clone()]) {
            row[first_statistic..].copy_from_slice(&before.to_array()[..STATISTICS]);
        }
        let first = self.range.start + owned.start;
        let mut is_touched = vec![false; owned.len()];
        for view in 0..views {
            let words = &mut rest[view % rest.len()];
            let (rows, after) = words[1..].split_at(words[0] as usize * (width + 1));
            *words = after;
            for row in rows.chunks_exact(width + 1) {
                let place = row[0] as usize - first;
                is_touched[place] = true;
                let sums = &mut sums[place * width..][..width];
                for (column, (sum, bits)) in sums.iter_mut().zip(&row[1..]).enumerate() {
                    let value = f32::from_bits(*bits);
                    // the last one is the largest radius
                    *sum = if column + 1 == width { sum.max(value) } else { *sum + value };
                }
            }
        }
        let touched = (0..owned.len()).filter(|&place| is_touched[place]);
        let row = |place: usize| {
            let values = sums[place * width..][..width].iter().map(|value| value.to_bits());
            std::iter::once((first + place) as u32).chain(values)
        };
        touched.flat_map(row).collect()
    }

    /// Writes the sums of all owners. Takes them from what each has told.
    fn write(&self, device: &Device, rest: &mut [&[u32]]) -> Result<()> {
        let width = self.width();
        let len = self.range.len();
        let zeros = |tensor: &&TensorGradient| vec![0.0_f32; tensor.range.len()];
        let mut columns: Vec<_> = self.tensors.iter().map(zeros).collect();
        let mut statistics = self.before.clone();
        for words in rest {
            while let Some((row, after)) = words.split_at_checked(width + 1)
                && self.range.contains(&(row[0] as usize))
            {
                *words = after;
                let index = row[0] as usize - self.range.start;
                let mut values = row[1..].iter().map(|&bits| f32::from_bits(bits));
                for column in &mut columns {
                    let width = column.len() / len;
                    column[index * width..][..width].fill_with(|| values.next().expect("a row"));
                }
                let mut value = || values.next().expect("a row");
                let [x, y, z] = std::array::from_fn(|_| value());
                statistics[index] = Vec4::new(x, y, z, statistics[index].w);
            }
        }
        for (tensor, values) in self.tensors.iter().zip(&columns) {
            tensor.write(device, values)?;
        }
        Ok(device.write(&self.gradient.statistics, 0, &statistics)?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use organza_core::tile::Tile;

    /// Any order gives the same sums, and NaN stays NaN.
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
                sums.add(0, &values);
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
