//! The gradient of a step that ranks share.
//!
//! A unit is a step's tiles of one camera. Units are dealt to ranks: unit u is computed by rank u mod R. Its gradients
//! have the same bits whoever computes it, and they are added in the order of the cameras, so the sum does not depend on
//! the number of ranks:
//!
//! - **hash grids** as 64-bit integers, whose sums are exact in any order. All units share one scale: its bound is the
//!   largest of all ranks' bounds. Only blocks that some rank has touched travel.
//! - **Gaussians** as rows of those that a unit has seen. A row goes to the rank that owns the Gaussian. The owner adds
//!   the rows of all units in their order, and tells everyone the sums.
//! - **networks** unit by unit, to everyone.

use std::ops::Range;

use glam::Vec4;

use super::backward::{LossTarget, of_tiles};
use super::field_sums::{add_grids, set_scales, take_networks, write_networks};
use super::gradient::{SceneGradient, TensorGradient};
use super::loss::{Loss, LossInputs, TileLoss};
use super::part::Part;
use super::part_counts::{Capacity, Needed};
use super::plan::Plan;
use super::renderer::Renderer;
use super::scene::DeviceScene;
use crate::camera::Camera;
use crate::error::Result;
use crate::ranks::Ranks;
use crate::tile::TileBatch;
use organza_device::{Buffer, Device};

/// The most samples of units that are kept between both passes: about 2 GiB of tables. Other units are rendered twice.
const KEPT_SAMPLES: u64 = 1 << 24;

/// A unit that was rendered and compared.
#[derive(Debug)]
struct Unit {
    part: Part,
    /// `[pairs, 3]`
    pair_gradient: Buffer<Vec4>,
    capacity: Capacity,
}

/// A step, as units see it.
struct Step<'a> {
    renderer: &'a Renderer,
    scene: &'a DeviceScene,
    cameras: &'a [Camera],
    target: &'a LossTarget<'a>,
    gradient: &'a SceneGradient,
    ranks: &'a dyn Ranks,
    /// All units, by camera.
    units: Vec<Plan>,
}

impl Renderer {
    /// Adds the gradients of a batch's loss to `gradient`, as [`Renderer::add_loss_gradient`] does, together with other
    /// ranks: each has the same scene and the same batch, and then the same gradient. Returns the losses of all tiles, by
    /// camera.
    ///
    /// # Errors
    /// As [`Renderer::render`]; [`Error::Rank`].
    pub(crate) fn add_ranks_gradient(
        &self,
        scene: &DeviceScene,
        cameras: &[Camera],
        batch: &TileBatch,
        target: &LossTarget<'_>,
        gradient: &SceneGradient,
        ranks: &dyn Ranks,
    ) -> Result<Vec<TileLoss>> {
        let units = by_camera(self.plans(scene, batch)?);
        let step = Step { renderer: self, scene, cameras, target, gradient, ranks, units };
        gradient.begin(self.device());
        step.run().inspect_err(|_| gradient.restart(self.device()))
    }
}

/// Plans of one camera each, in their order; `plans` are those of a batch, last first.
fn by_camera(plans: Vec<Plan>) -> Vec<Plan> {
    let of_camera = |plan: &Plan| {
        let tiles = plan.tiles.chunk_by(|a, b| a.tile.camera == b.tile.camera);
        tiles.map(|tiles| Plan { side: plan.side, tiles: tiles.to_vec() }).collect::<Vec<_>>()
    };
    plans.iter().rev().flat_map(of_camera).collect()
}

impl Step<'_> {
    fn device(&self) -> &Device {
        self.renderer.device()
    }

    /// The units of a rank.
    fn units_of(&self, rank: usize) -> impl Iterator<Item = usize> + use<> {
        (rank..self.units.len()).step_by(self.ranks.size())
    }

    fn run(&self) -> Result<Vec<TileLoss>> {
        let loss = &mut None;
        let mut losses = Vec::new();
        let mut kept: Vec<Option<Unit>> = Vec::new();
        let (mut samples, mut keeps) = ([0_i64; 2], true);
        for index in self.units_of(self.ranks.rank()) {
            let (unit, found) = match self.unit(index, loss) {
                Err(error) if error.is_out_of_memory() && kept.iter().any(Option::is_some) => {
                    // those that were kept may be what takes the memory
                    (keeps, kept) = (false, kept.iter().map(|_| None).collect());
                    self.unit(index, loss)?
                }
                result => result?,
            };
            unit.part.raise_bounds(self.device(), &unit.pair_gradient, self.gradient)?;
            samples[0] += i64::from(unit.capacity.pairs);
            samples[1] += i64::from(unit.capacity.samples);
            losses.extend(found);
            let is_kept = keeps && samples.iter().sum::<i64>() as u64 <= KEPT_SAMPLES;
            kept.push(is_kept.then_some(unit));
        }
        let (device, ranks, gradient) = (self.device(), self.ranks, self.gradient);
        set_scales(device, ranks, self.scene, gradient, samples)?;
        let mut networks = Vec::new();
        let mut rows = Rows::new(self)?;
        for (index, unit) in self.units_of(self.ranks.rank()).zip(kept) {
            let unit = match unit {
                Some(unit) => unit,
                None => self.unit(index, loss)?.0,
            };
            device.run_in_pool(|| {
                unit.part.spread(device, self.scene, &unit.pair_gradient, gradient)
            })?;
            networks.push(take_networks(device, gradient)?);
            rows.take(self)?;
        }
        self.add_networks(networks)?;
        rows.add(self)?;
        add_grids(device, ranks, gradient)?;
        self.all_losses(&losses)
    }

    /// Renders a unit, compares it, and goes back to its pairs.
    fn unit(&self, index: usize, loss: &mut Option<Loss>) -> Result<(Unit, Vec<TileLoss>)> {
        let (device, plan, target) = (self.device(), &self.units[index], self.target);
        let area = (plan.side * plan.side) as usize;
        let loss = Loss::of_tiles(loss, device, plan.side, plan.tiles.len())?;
        let render = |capacity: Option<Capacity>| {
            let part = Part::evaluate(device, self.scene, self.cameras, plan, true, capacity)?;
            let image = of_tiles(target.image, &plan.tiles, 3 * area);
            let valid = of_tiles(target.valid, &plan.tiles, area);
            let inputs = LossInputs {
                image: &part.composite.image,
                target: &device.upload("photographs", &image)?,
                valid: &device.upload("masks", &valid)?,
                valid_pixels: target.valid_pixels,
                ssim_weight: target.ssim_weight,
            };
            let output = loss.evaluate(device, &inputs)?;
            let pair_gradient =
                part.pair_gradient(device, self.scene, plan.side, &output.grad_image)?;
            let (losses, _, needed) = output.sums_and_needed(device, &part, None)?;
            Ok(((part, pair_gradient, losses, needed), needed))
        };
        let work = || self.renderer.with_predicted_capacity(self.scene, plan, render);
        let (part, pair_gradient, losses, needed) = device.run_in_pool(work)?;
        let Needed::Capacity(capacity) = needed else { unreachable!("it was rendered again") };
        Ok((Unit { part, pair_gradient, capacity }, losses))
    }

    /// Adds the networks' gradients of all units, in their order.
    fn add_networks(&self, mine: Vec<Vec<f32>>) -> Result<()> {
        let all = self.ranks.gather(bytemuck::cast_slice(&mine.concat()).to_vec())?;
        let fields = [&self.gradient.color, &self.gradient.transmittance];
        let len: usize = fields.map(|field| 4 * field.parameters.len()).iter().sum();
        let mut sum = vec![0.0_f32; len];
        let mut places = vec![0; self.ranks.size()];
        for index in 0..self.units.len() {
            let rank = index % self.ranks.size();
            let begin = places[rank];
            places[rank] += len * 4;
            let values: Vec<f32> = bytemuck::pod_collect_to_vec(&all[rank][begin..begin + len * 4]);
            sum.iter_mut().zip(values).for_each(|(sum, value)| *sum += value);
        }
        write_networks(self.device(), self.gradient, &sum)
    }

    /// The losses of all tiles, by camera.
    fn all_losses(&self, mine: &[TileLoss]) -> Result<Vec<TileLoss>> {
        let values = |l: &TileLoss| [l.absolute, l.dissimilarity, l.squared, l.valid];
        let mine: Vec<f64> = mine.iter().flat_map(values).collect();
        let all = self.ranks.gather(bytemuck::cast_slice(&mine).to_vec())?;
        let all: Vec<Vec<f64>> =
            all.iter().map(|bytes| bytemuck::pod_collect_to_vec(bytes)).collect();
        let mut rest: Vec<_> = all.iter().map(|values| values.as_chunks::<4>().0.iter()).collect();
        let mut losses = Vec::new();
        for (index, unit) in self.units.iter().enumerate() {
            let of_rank = &mut rest[index % self.ranks.size()];
            losses.extend(of_rank.take(unit.tiles.len()).map(
                |&[absolute, dissimilarity, squared, valid]| TileLoss {
                    absolute,
                    dissimilarity,
                    squared,
                    valid,
                },
            ));
        }
        Ok(losses)
    }
}

/// The gradients of Gaussians, and the statistics of growth, as rows: what a unit has made of each Gaussian.
///
/// One rank alone needs none of it on a CPU: its units add to the gradient one after the other. A GPU may round such a sum
/// otherwise, as it can fuse it with the product before.
struct Rows<'a> {
    is_needed: bool,
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
    fn new(step: &Step<'a>) -> Result<Self> {
        let mut tensors = Vec::new();
        step.gradient.tensors.gaussians.as_ref().map(|tensor| tensors.push(tensor));
        let gaussians = step.scene.len();
        let is_needed = step.ranks.size() > 1 || step.device().backend() != "cpu";
        let mut before = Vec::new();
        if is_needed {
            before = step.device().read(&step.gradient.statistics)?;
            step.device().clear(&step.gradient.statistics);
        }
        let for_each = vec![Vec::new(); step.ranks.size()];
        Ok(Self { is_needed, tensors, gaussians, for_each, before })
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
    fn take(&mut self, step: &Step<'_>) -> Result<()> {
        if !self.is_needed {
            return Ok(());
        }
        let device = step.device();
        let mut columns = Vec::with_capacity(self.tensors.len());
        for tensor in &self.tensors {
            let values = tensor.read(device)?;
            columns.push((values.len() / self.gaussians, values));
        }
        self.tensors.iter().for_each(|tensor| device.clear(&tensor.buffer));
        let statistics = device.read(&step.gradient.statistics)?;
        device.clear(&step.gradient.statistics);
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

    /// Adds the rows of all units in their order, and writes the sums to the gradient.
    fn add(mut self, step: &Step<'_>) -> Result<()> {
        if !self.is_needed {
            return Ok(());
        }
        let ranks = step.ranks;
        let bytes = |words: Vec<u32>| bytemuck::cast_slice(&words).to_vec();
        let for_each = self.for_each.iter_mut().map(|words| bytes(std::mem::take(words)));
        let received = ranks.exchange(for_each.collect())?;
        let sums = ranks.gather(bytes(self.sum(step, &received)))?;
        self.write(step, &sums)
    }

    /// The sums of the rows that this rank owns: those that any unit has.
    fn sum(&self, step: &Step<'_>, received: &[Vec<u8>]) -> Vec<u32> {
        let (width, owned) = (self.width(), self.owned(step.ranks.rank()));
        let received: Vec<Vec<u32>> =
            received.iter().map(|bytes| bytemuck::pod_collect_to_vec(bytes)).collect();
        let mut rest: Vec<&[u32]> = received.iter().map(Vec::as_slice).collect();
        let first_statistic = width - STATISTICS;
        let mut sums: Vec<f32> = vec![0.0; owned.len() * width];
        for (row, before) in sums.chunks_exact_mut(width).zip(&self.before[owned.clone()]) {
            row[first_statistic..].copy_from_slice(&before.to_array()[..STATISTICS]);
        }
        let mut is_touched = vec![false; owned.len()];
        for unit in 0..step.units.len() {
            let words = &mut rest[unit % step.ranks.size()];
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
    fn write(&self, step: &Step<'_>, sums: &[Vec<u8>]) -> Result<()> {
        let (device, width) = (step.device(), self.width());
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
        Ok(device.write(&step.gradient.statistics, 0, &statistics)?)
    }
}
