//! Rows of Gaussians' gradients, as ranks exchange them: a row goes to the rank that owns the Gaussian. The owner adds the rows
//! of all units in their order, and tells everyone the sums.

use std::ops::Range;

use glam::Vec4;

use super::gradient::{SceneGradient, TensorGradient};
use crate::error::Result;
use crate::ranks::Ranks;
use organza_device::Device;

/// The gradients of Gaussians, and the statistics of growth, as rows: what a unit has made of each Gaussian.
pub struct Rows<'a> {
    device: &'a Device,
    ranks: &'a dyn Ranks,
    gradient: &'a SceneGradient,
    tensors: Vec<&'a TensorGradient>,
    gaussians: usize,
    /// For each rank, what goes to it: for each unit, how many rows follow, and the rows. A row is the Gaussian's index,
    /// its values of all tensors, and its three statistics.
    for_each: Vec<Vec<u32>>,
    /// What the statistics were before the step.
    before: Vec<Vec4>,
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
        let gaussians = gradient.statistics.len();
        let before = device.read(&gradient.statistics)?;
        device.clear(&gradient.statistics);
        let for_each = vec![Vec::new(); ranks.size()];
        Ok(Self { device, ranks, gradient, tensors, gaussians, for_each, before })
    }

    /// Values of a row, without the index.
    fn width(&self) -> usize {
        let values: usize = self.tensors.iter().map(|tensor| tensor.range.len()).sum();
        values / self.gaussians + STATISTICS
    }

    /// The Gaussians that a rank owns.
    fn owned(&self, rank: usize) -> Range<usize> {
        let begin = |rank| self.gaussians * rank / self.for_each.len();
        begin(rank)..begin(rank + 1)
    }

    /// Takes what a unit has left on the device.
    pub fn take(&mut self) -> Result<()> {
        let device = self.device;
        let mut columns = Vec::with_capacity(self.tensors.len());
        for tensor in &self.tensors {
            let values = tensor.read(device)?;
            columns.push((values.len() / self.gaussians, values));
        }
        self.tensors.iter().for_each(|tensor| device.clear(&tensor.buffer));
        let statistics = device.read(&self.gradient.statistics)?;
        device.clear(&self.gradient.statistics);
        for rank in 0..self.for_each.len() {
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

    /// Adds the rows of all ranks' units in their order, and writes the sums to the gradient.
    pub fn add(mut self, units: usize) -> Result<()> {
        let ranks = self.ranks;
        let bytes = |words: Vec<u32>| bytemuck::cast_slice(&words).to_vec();
        let for_each = self.for_each.iter_mut().map(|words| bytes(std::mem::take(words)));
        let received = ranks.exchange(for_each.collect())?;
        let sums = ranks.gather(bytes(self.sum(units, &received)))?;
        self.write(&sums)
    }

    /// The sums of the rows that this rank owns: those that any unit has.
    fn sum(&self, units: usize, received: &[Vec<u8>]) -> Vec<u32> {
        let (width, owned) = (self.width(), self.owned(self.ranks.rank()));
        let received: Vec<Vec<u32>> =
            received.iter().map(|bytes| bytemuck::pod_collect_to_vec(bytes)).collect();
        let mut rest: Vec<&[u32]> = received.iter().map(Vec::as_slice).collect();
        let first_statistic = width - STATISTICS;
        let mut sums: Vec<f32> = vec![0.0; owned.len() * width];
        for (row, before) in sums.chunks_exact_mut(width).zip(&self.before[owned.clone()]) {
            row[first_statistic..].copy_from_slice(&before.to_array()[..STATISTICS]);
        }
        let mut is_touched = vec![false; owned.len()];
        for unit in 0..units {
            let words = &mut rest[unit % self.ranks.size()];
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

    /// Writes the sums of all owners.
    fn write(&self, sums: &[Vec<u8>]) -> Result<()> {
        let (device, width) = (self.device, self.width());
        let zeros = |tensor: &&TensorGradient| vec![0.0_f32; tensor.range.len()];
        let mut columns: Vec<_> = self.tensors.iter().map(zeros).collect();
        let mut statistics = self.before.clone();
        for bytes in sums {
            let words: Vec<u32> = bytemuck::pod_collect_to_vec(bytes);
            for row in words.chunks_exact(width + 1) {
                let index = row[0] as usize;
                let mut values = row[1..].iter().map(|&bits| f32::from_bits(bits));
                for column in &mut columns {
                    let width = column.len() / self.gaussians;
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
