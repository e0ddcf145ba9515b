//! Sums over ranks: the gradients of fields, poses, exposures and Gaussians.

use std::ops::Range;

use glam::Vec4;
use organza_shaders::hash_grid_backward::VALUES_PER_FLAG;

use super::hash_grid::HashGridGradient;
use super::{SceneGradient, TensorGradient};
use muslin_device::{Buffer, Device};
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

/// Integer sums on the device, which all ranks add up.
struct SharedSums<'a> {
    buffer: &'a Buffer<u32>,
    values: Vec<i64>,
    /// Not 0 where a block of [`VALUES_PER_FLAG`] values has changed.
    touched: Vec<u32>,
}

impl<'a> SharedSums<'a> {
    /// Hash grids have flags, `touched`. Without flags, the blocks that are not zero count as touched.
    fn read(device: &Device, buffer: &'a Buffer<u32>, touched: Option<Vec<u32>>) -> Result<Self> {
        let values: Vec<i64> = bytemuck::pod_collect_to_vec(&device.read(buffer)?);
        let blocks = values.chunks(VALUES_PER_FLAG as usize);
        let find = || blocks.map(|block| u32::from(block.iter().any(|&sum| sum != 0))).collect();
        let touched = touched.unwrap_or_else(find);
        Ok(Self { buffer, values, touched })
    }

    /// The blocks that were touched.
    fn blocks(&mut self) -> impl Iterator<Item = &mut [i64]> {
        let blocks = self.values.chunks_mut(VALUES_PER_FLAG as usize).zip(&self.touched);
        blocks.filter(|(_, touched)| **touched != 0).map(|(block, _)| block)
    }
}

/// Adds up the sums of all ranks. Only blocks that some rank has touched are sent.
pub fn sum(device: &Device, ranks: &dyn Ranks, gradient: &SceneGradient) -> Result<()> {
    let mut all = Vec::new();
    let mut flags = Vec::new();
    for table in tables(gradient) {
        let touched = device.read(&table.touched)?;
        all.push(SharedSums::read(device, &table.sum, Some(touched))?);
        flags.extend(device.read(&table.status)?);
    }
    let networks = [&gradient.color.network, &gradient.transmittance.network];
    for binned in networks.into_iter().chain(&gradient.poses).chain(&gradient.exposures) {
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

/// The gradients of Gaussians, and the statistics of densification, as rows: one for each Gaussian that a
/// [view batch](crate::pass::batch) has a gradient for. Each rank owns a range of the Gaussians, and sums their rows.
pub struct Rows<'a> {
    device: &'a Device,
    ranks: &'a dyn Ranks,
    gradient: &'a SceneGradient,
    tensors: Vec<&'a TensorGradient>,
    /// `[N]`: the statistics before the step.
    before: Vec<Vec4>,
    /// The words to send to each rank: for each view batch, the number of rows, and the rows. A row is the Gaussian's
    /// index, its gradient in all tensors, and its three statistics.
    for_each: Vec<Vec<u32>>,
}

/// Statistics of a Gaussian; the fourth value of the vector is not used.
const STATISTICS: usize = 3;

impl<'a> Rows<'a> {
    /// No rows yet. Takes the statistics out of the gradient; [`Rows::add`] writes them back.
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

    /// Moves a view batch's rows from the device to this list.
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

    /// Sums the rows of this rank's Gaussians over all view batches. Removes the rows from `rest`, the words of each rank.
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

    /// Writes the sums of all owners to the device.
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
            self.device.write(&tensor.buffer, tensor.range.start, values)?;
        }
        Ok(self.device.write(&self.gradient.statistics, 0, &statistics)?)
    }
}
