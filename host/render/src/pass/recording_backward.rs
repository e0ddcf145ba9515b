//! How a recording goes back. If ranks share it, the sums of all of them become the gradients.

use glam::Vec4;

use super::field_sums::{finish, set_scales};
use super::ranks::Rows;
use crate::pass::part::Part;
use crate::pass::recording::Recording;
use crate::pass::shard::{KeptPart, PLANES};
use crate::scene::device_scene::DeviceScene;
use crate::stages::counts::Capacity;
use crate::stages::cut::values_of_tiles;
use crate::stages::gradient::SceneGradient;
use muslin_device::Buffer;
use organza_core::error::Result;
use organza_core::ranks::Grid;

impl KeptPart {
    /// Whether the last camera continues in another part.
    fn continues_in(&self, next: &Self) -> bool {
        let [last, first] = [self.plan.tiles.last(), next.plan.tiles.first()];
        first.map(|tile| tile.tile.camera) == last.map(|tile| tile.tile.camera)
    }
}

impl Recording<'_> {
    /// Adds dLoss/dtensor to the gradients of a step, zero before but for the statistics: those of the fields and of
    /// each block.
    ///
    /// # Errors
    /// The same errors as [`Recording::backward`], but for [`Error::Diverged`]. The gradient is then as it was before.
    pub(crate) fn add_to(
        &self,
        grad_output: &[f32],
        fields: &SceneGradient,
        of_blocks: &[SceneGradient],
    ) -> Result<()> {
        let device = self.renderer.device();
        of_blocks.iter().for_each(|gradient| gradient.snapshot(device));
        let rollback = || {
            of_blocks.iter().chain([fields]).for_each(|gradient| gradient.rollback(device));
        };
        let added = match self.shared {
            Some(shared) => self.add_shared(grad_output, fields, of_blocks, shared),
            None => self.add_alone(grad_output, fields),
        };
        match added {
            Err(error) if error.is_out_of_memory() && self.shared.is_none() => {
                rollback();
                let renderer = &self.renderer;
                let scene = &self.fields;
                let cameras = &self.cameras;
                renderer.in_parts(scene, &self.batch, |plans| {
                    let added = renderer.add_parts(scene, cameras, plans, grad_output, fields);
                    added.inspect_err(|_| rollback())
                })
            }
            added => added.inspect_err(|_| rollback()),
        }
    }

    /// Part by part.
    fn add_alone(&self, grad_output: &[f32], gradient: &SceneGradient) -> Result<()> {
        self.parts.iter().flatten().try_for_each(|kept| {
            self.with_part(&self.fields, kept, |part| {
                let pixels = self.pixels(kept, grad_output)?;
                part.backward(&self.fields, kept.plan.side, &pixels, gradient)
            })
        })
    }

    /// The sums of this rank, and then of all.
    fn add_shared(
        &self,
        grad_output: &[f32],
        fields: &SceneGradient,
        of_blocks: &[SceneGradient],
        (grid, views): (Grid<'_>, usize),
    ) -> Result<()> {
        let device = self.renderer.device();
        let mut kept_pairs = self.raise_bounds(grad_output, fields, of_blocks, grid)?.into_iter();
        let column = grid.column();
        let rows = (grid.groups() > 1).then(|| Rows::new(device, &column, of_blocks));
        let mut rows = rows.transpose()?;
        for (index, (block, parts)) in self.blocks.iter().zip(&self.parts).enumerate() {
            let gradient = &of_blocks[index];
            for (at, kept) in parts.iter().enumerate() {
                let pairs = kept_pairs.next().expect("one for each part");
                let continues = parts.get(at + 1).is_some_and(|next| kept.continues_in(next));
                let rows = rows.as_mut().map(|rows| (rows, index));
                self.with_part(block, kept, |part| {
                    let pairs = match pairs {
                        Some(pairs) => pairs,
                        None => self.pair_gradient(block, kept, part, grad_output)?,
                    };
                    part.add_pairs(block, &pairs, gradient, rows, continues)
                })?;
            }
        }
        rows.map_or(Ok(()), |rows| rows.add(views))?;
        finish(device, Some(grid.all), fields)
    }

    /// Finds the one scale of all ranks' hash grids. Returns the gradient of the pairs of each part, `[pairs, 3]`, if
    /// the part was kept.
    fn raise_bounds(
        &self,
        grad_output: &[f32],
        fields: &SceneGradient,
        of_blocks: &[SceneGradient],
        grid: Grid<'_>,
    ) -> Result<Vec<Option<Buffer<Vec4>>>> {
        let device = self.renderer.device();
        let mut samples = [0; 2];
        let mut all = Vec::new();
        for ((block, parts), gradient) in self.blocks.iter().zip(&self.parts).zip(of_blocks) {
            for kept in parts {
                let pairs = self.with_part(block, kept, |part| {
                    let pairs = self.pair_gradient(block, kept, part, grad_output)?;
                    part.raise_bounds(device, &pairs, gradient)?;
                    Ok(pairs)
                })?;
                all.push(kept.part.is_some().then_some(pairs));
                samples = [0, 1].map(|field| samples[field] + kept.samples[field] as i64);
            }
        }
        set_scales(device, Some(grid.all), &self.fields, fields, samples)?;
        Ok(all)
    }

    /// Works with a part that was kept, or that is rendered again.
    fn with_part<R: Send>(
        &self,
        block: &DeviceScene,
        kept: &KeptPart,
        work: impl FnOnce(&Part) -> Result<R> + Send,
    ) -> Result<R> {
        let renderer = &self.renderer;
        let device = self.renderer.device();
        let render = |capacity: Option<Capacity>| {
            let part = Part::evaluate(block, &self.cameras, &kept.plan, true, capacity)?;
            let (_, needed) = part.read(device, Vec::new())?;
            Ok((part, needed))
        };
        device.run_in_pool(|| match &kept.part {
            Some(part) => work(part),
            None => work(&renderer.with_predicted_capacity(block, &kept.plan, render)?),
        })
    }

    /// `[tiles, 3, S, S]`, of a part's tiles.
    fn pixels(&self, kept: &KeptPart, grad_output: &[f32]) -> Result<Buffer<f32>> {
        let area = (kept.plan.side * kept.plan.side) as usize;
        let pixels = values_of_tiles(grad_output, &kept.plan.tiles, 3 * area);
        Ok(self.renderer.device().upload("gradient of the tiles", &pixels)?)
    }

    /// `[pairs, 3]`, of dL/dC and dL/dS at the sums of all Gaussians.
    fn pair_gradient(
        &self,
        block: &DeviceScene,
        kept: &KeptPart,
        part: &Part,
        grad_output: &[f32],
    ) -> Result<Buffer<Vec4>> {
        let device = self.renderer.device();
        let plan = &kept.plan;
        let area = (plan.side * plan.side) as usize;
        let sums = values_of_tiles(&self.sums, &plan.tiles, PLANES * area);
        device.write(&part.composite.sum, 0, &sums)?;
        part.pair_gradient(block, plan.side, &self.pixels(kept, grad_output)?)
    }
}
