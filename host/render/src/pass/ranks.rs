//! Rows of Gaussians' gradients, as ranks exchange them: a row goes to the rank that owns the Gaussian. The owner adds the rows
//! of all view batches in their order, and sends everyone the sums.

use std::ops::Range;

use glam::Vec4;

use crate::stages::gradient::{SceneGradient, TensorGradient};
use muslin_device::Device;
use organza_core::error::Result;
use organza_core::ranks::Ranks;

/// The gradients of Gaussians, and the statistics of growth, as rows: what a view batch has made of each Gaussian.
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

    /// Takes what a view batch has left of a scene on the device.
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

    /// The sums of the rows that a rank owns, those that any view batch has. Takes the rows from what each rank has sent.
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
