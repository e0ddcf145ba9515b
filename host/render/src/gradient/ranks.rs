//! What ranks add up: the gradients of the fields, of poses, and of Gaussians.

use std::ops::Range;

use glam::Vec4;

use super::hash_grid::HashGridGradient;
use super::{SceneGradient, TensorGradient};
use muslin_device::Device;
use organza_core::Result;
use organza_core::ranks::Ranks;

fn tables(gradient: &SceneGradient) -> [&HashGridGradient; 2] {
    [&gradient.color.table, &gradient.transmittance.table]
}

/// Raises the bounds of both hash grids' sums to the largest of all ranks' bounds, and adds up the samples of the color and
/// of the transmittance field.
pub fn share_bounds(
    device: &Device,
    ranks: &dyn Ranks,
    gradient: &SceneGradient,
    samples: &mut [i64; 2],
) -> Result<()> {
    ranks.sum(samples)?;
    let [color, transmittance] = tables(gradient).map(|table| device.read(&table.bound));
    let color = color?;
    let mut bounds = [&color[..], &transmittance?[..]].concat();
    ranks.max(&mut bounds)?;
    let (first, second) = bounds.split_at(color.len());
    for (table, bound) in tables(gradient).into_iter().zip([first, second]) {
        device.write(&table.bound, 0, bound)?;
    }
    Ok(())
}

/// Adds up the sums of all ranks. Only blocks that are not zero on some rank travel.
pub fn sum(device: &Device, ranks: &dyn Ranks, gradient: &SceneGradient) -> Result<()> {
    let SceneGradient { color, transmittance, poses, .. } = gradient;
    let mut buffers = vec![
        &color.table.sum,
        &transmittance.table.sum,
        &color.network.sum,
        &transmittance.network.sum,
    ];
    buffers.extend(poses.iter().map(|poses| &poses.sum));
    let mut values: Vec<i64> = Vec::new();
    for buffer in &buffers {
        values.extend(bytemuck::pod_collect_to_vec::<u32, i64>(&device.read(*buffer)?));
    }
    let is_touched = |block: &[i64]| u32::from(block.iter().any(|&sum| sum != 0));
    let mut flags: Vec<_> = values.chunks(BLOCK).map(is_touched).collect();
    ranks.or(&mut flags)?;
    let mut packed = Vec::new();
    let touched = values.chunks(BLOCK).zip(&flags).filter(|(_, flag)| **flag != 0);
    touched.for_each(|(block, _)| packed.extend(block));
    ranks.sum(&mut packed)?;
    let touched = values.chunks_mut(BLOCK).zip(&flags).filter(|(_, flag)| **flag != 0);
    let mut rest = &packed[..];
    for (block, _) in touched {
        let (sums, after) = rest.split_at(block.len());
        block.copy_from_slice(sums);
        rest = after;
    }
    let mut words = bytemuck::cast_slice::<i64, u32>(&values);
    for buffer in buffers {
        let (own, after) = words.split_at(buffer.len());
        device.write(buffer, 0, own)?;
        words = after;
    }
    for flags in tables(gradient).into_iter().flat_map(|table| [&table.touched, &table.status]) {
        let mut of_all = device.read(flags)?;
        ranks.or(&mut of_all)?;
        device.write(flags, 0, &of_all)?;
    }
    Ok(())
}

/// Values of sums that travel together.
const BLOCK: usize = 64;

/// The gradients of Gaussians, and the statistics of growth, as rows: one for each Gaussian that a view batch has seen.
pub struct Rows<'a> {
    device: &'a Device,
    ranks: &'a dyn Ranks,
    gradient: &'a SceneGradient,
    tensors: Vec<&'a TensorGradient>,
    /// `[N]`: the statistics before the step.
    before: Vec<Vec4>,
    /// For each rank, what goes to it: for each view batch, how many rows follow, and the rows. A row is the Gaussian's
    /// index, its values of all tensors, and its three statistics.
    for_each: Vec<Vec<u32>>,
}

/// Values of a Gaussian's statistics that count.
const STATISTICS: usize = 3;

impl<'a> Rows<'a> {
    /// No rows yet. The gradient's statistics are taken, and written back with [`Rows::add`].
    pub fn new(
        device: &'a Device,
        ranks: &'a dyn Ranks,
        gradient: &'a SceneGradient,
    ) -> Result<Self> {
        let mut tensors = Vec::new();
        gradient.tensors.gaussians.as_ref().map(|tensor| tensors.push(tensor));
        let before = device.read(&gradient.statistics)?;
        device.clear(&gradient.statistics);
        let for_each = vec![Vec::new(); ranks.size()];
        Ok(Self { device, ranks, gradient, tensors, before, for_each })
    }

    /// Takes the rows that a view batch has made from the device.
    pub fn take(&mut self) -> Result<()> {
        let device = self.device;
        let mut columns = Vec::with_capacity(self.tensors.len());
        for tensor in &self.tensors {
            let values = tensor.read(device)?;
            columns.push((values.len() / self.before.len(), values));
        }
        self.tensors.iter().for_each(|tensor| device.clear(&tensor.buffer));
        let statistics = device.read(&self.gradient.statistics)?;
        device.clear(&self.gradient.statistics);
        for rank in 0..self.ranks.size() {
            let owned = self.owned(rank);
            let rows = &mut self.for_each[rank];
            let place = rows.len();
            rows.push(0);
            for index in owned {
                let begin = rows.len();
                rows.push(index as u32);
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

    /// Adds the rows of all ranks' view batches in their order, and writes the sums to the gradient.
    pub fn add(mut self, views: usize) -> Result<()> {
        let ranks = self.ranks;
        let bytes = |words: Vec<u32>| bytemuck::cast_slice(&words).to_vec();
        let words = |bytes: &[Vec<u8>]| -> Vec<Vec<u32>> {
            bytes.iter().map(|bytes| bytemuck::pod_collect_to_vec(bytes)).collect()
        };
        let for_each = std::mem::take(&mut self.for_each).into_iter().map(bytes);
        let received = words(&ranks.exchange(for_each.collect())?);
        let mut rest: Vec<_> = received.iter().map(Vec::as_slice).collect();
        let sums = self.sum(views, &mut rest);
        self.write(&words(&ranks.gather(bytes(sums))?))
    }

    /// Values of a row, without the index.
    fn width(&self) -> usize {
        let values: usize = self.tensors.iter().map(|tensor| tensor.range.len()).sum();
        values / self.before.len() + STATISTICS
    }

    /// The Gaussians that a rank owns.
    fn owned(&self, rank: usize) -> Range<usize> {
        let begin = |rank| self.before.len() * rank / self.ranks.size();
        begin(rank)..begin(rank + 1)
    }

    /// The sums of the rows that this rank owns, those that any view batch has. Takes the rows that each rank has sent.
    fn sum(&self, views: usize, rest: &mut [&[u32]]) -> Vec<u32> {
        let width = self.width();
        let owned = self.owned(self.ranks.rank());
        let first_statistic = width - STATISTICS;
        let mut sums: Vec<f32> = vec![0.0; owned.len() * width];
        for (row, before) in sums.chunks_exact_mut(width).zip(&self.before[owned.clone()]) {
            row[first_statistic..].copy_from_slice(&before.to_array()[..STATISTICS]);
        }
        let mut is_touched = vec![false; owned.len()];
        for view in 0..views {
            let words = &mut rest[view % self.ranks.size()];
            let (rows, after) = words[1..].split_at(words[0] as usize * (width + 1));
            *words = after;
            for row in rows.chunks_exact(width + 1) {
                let place = row[0] as usize - owned.start;
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
            std::iter::once((owned.start + place) as u32).chain(values)
        };
        touched.flat_map(row).collect()
    }

    /// Writes the sums that each owner has told.
    fn write(&self, sums: &[Vec<u32>]) -> Result<()> {
        let zeros = |tensor: &&TensorGradient| vec![0.0_f32; tensor.range.len()];
        let mut columns: Vec<_> = self.tensors.iter().map(zeros).collect();
        let mut statistics = self.before.clone();
        for row in sums.iter().flat_map(|rows| rows.chunks_exact(self.width() + 1)) {
            let index = row[0] as usize;
            let mut values = row[1..].iter().map(|&bits| f32::from_bits(bits));
            for column in &mut columns {
                let width = column.len() / self.before.len();
                column[index * width..][..width].fill_with(|| values.next().expect("a row"));
            }
            let mut value = || values.next().expect("a row");
            let [x, y, z] = std::array::from_fn(|_| value());
            statistics[index] = Vec4::new(x, y, z, statistics[index].w);
        }
        for (tensor, values) in self.tensors.iter().zip(&columns) {
            tensor.write(self.device, values)?;
        }
        Ok(self.device.write(&self.gradient.statistics, 0, &statistics)?)
    }
}
