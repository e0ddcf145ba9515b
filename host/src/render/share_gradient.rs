//! Gradients with Gaussians that are dealt to ranks.
//!
//! Every rank knows C and S of all Gaussians, so it has dL/dC and dL/dS of Eq. 13 without another message, and from them
//! the gradients of its own Gaussians. The gradients of the fields are added up. Their bits do not depend on the number of
//! ranks, either:
//!
//! - **hash grids** are 64-bit integers of one scale for all ranks, as in [a step over views](super::step).
//! - **networks and poses** are [binned](organza_kernel::binned) sums, which are exact.
//!
//! In a [grid](Grid) of ranks, each group renders the tiles of some cameras. The ranks that have the same share add up its
//! Gaussians' gradients camera by camera, as [`Rows`].

use glam::Vec4;

use super::backward::of_tiles;
use super::device_share::DeviceShare;
use super::field_sums::{finish, set_scales};
use super::gradient::SceneGradient;
use super::part::Part;
use super::part_counts::Capacity;
use super::renderer::Renderer;
use super::results::RenderedTiles;
use super::rows::Rows;
use super::scene::DeviceScene;
use super::share::{PLANES, ShareForward, SharePart};
use crate::camera::Camera;
use crate::error::{Error, Result};
use crate::ranks::{Grid, Ranks};
use crate::scene::{Gradient, Scene};
use crate::tile::TileBatch;
use organza_device::{Buffer, Device};

/// A batch that ranks have rendered together, each with its [share](DeviceShare), and that keeps what its gradient needs.
#[derive(Debug)]
pub struct ShareRecording<'a> {
    renderer: &'a Renderer,
    share: &'a DeviceShare,
    cameras: &'a [Camera],
    grid: Grid<'a>,
    /// Cameras of all groups.
    units: usize,
    forward: ShareForward,
}

impl Renderer {
    /// As [`Renderer::render_share`], and keeps what the gradient needs.
    ///
    /// # Errors
    /// As [`Renderer::render_share`]; [`Error::Argument`] where the scene's grids or networks are halves.
    pub fn record_share<'a>(
        &'a self,
        share: &'a DeviceShare,
        cameras: &'a [Camera],
        batch: &TileBatch,
        ranks: &'a dyn Ranks,
    ) -> Result<ShareRecording<'a>> {
        batch.validate(cameras)?;
        self.record_group((share, Grid::of_one_group(ranks)), cameras, batch, batch.tiles.len())
    }

    /// What a group renders of a step with so many cameras.
    pub(super) fn record_group<'a>(
        &'a self,
        (share, grid): (&'a DeviceShare, Grid<'a>),
        cameras: &'a [Camera],
        batch: &TileBatch,
        units: usize,
    ) -> Result<ShareRecording<'a>> {
        share.fields.require_gradients()?;
        let forward = self.share_forward(share, cameras, batch, &grid.row(), true)?;
        Ok(ShareRecording { renderer: self, share, cameras, grid, units, forward })
    }
}

impl ShareRecording<'_> {
    /// Y `[K, 3, S, S]`, which all ranks have.
    #[must_use]
    pub fn tiles(&self) -> &RenderedTiles {
        &self.forward.tiles
    }

    /// dLoss/dtensor for every tensor of the share, given `grad_output [K, 3, S, S]`, dLoss/dY, the same on all ranks.
    /// Those of the fields are of all Gaussians, and all ranks have them.
    ///
    /// # Errors
    /// [`Error::Argument`] where `grad_output` has another length; [`Error::Diverged`] where a gradient of the fields is
    /// not finite; as [`Renderer::render_share`].
    pub fn backward(self, grad_output: &[f32]) -> Result<Gradient> {
        let expected = self.forward.tiles.data.len();
        if grad_output.len() != expected {
            let found = grad_output.len();
            let reason = format!("found {found} values of dLoss/dY, expected {expected}");
            return Err(Error::Argument { reason });
        }
        let device = self.renderer.device();
        let fields = SceneGradient::new(device, &self.share.fields)?;
        let gradient = ShareGradient::new(device, self.share, fields)?;
        self.add(grad_output, &gradient)?;
        gradient.fields.check(device)?;
        self.download(&gradient)
    }

    /// Adds dLoss/dtensor to `gradient`, that of a step: zero before but for the statistics.
    pub(super) fn add(&self, grad_output: &[f32], gradient: &ShareGradient) -> Result<()> {
        let (device, fields) = (self.renderer.device(), &gradient.fields);
        let kept = self.raise_bounds(grad_output, gradient)?;
        let (units, column) = (self.units, self.grid.column());
        let has_groups = self.grid.groups() > 1;
        let mut rows =
            has_groups.then(|| Rows::new(device, &column, &gradient.blocks)).transpose()?;
        let mut kept = kept.into_iter();
        for (index, (scene, parts)) in self.parts().enumerate() {
            let gradient = &gradient.blocks[index];
            for (at, part) in parts.iter().enumerate() {
                let rendered = self.part(scene, part)?;
                let pairs = kept.next().expect("one for each part");
                let continues = parts.get(at + 1).is_some_and(|next| next.begins_in(part));
                device.run_in_pool(|| {
                    let pairs = match pairs {
                        Some(pairs) => pairs,
                        None => self.pair_gradient(scene, part, rendered.get(), grad_output)?,
                    };
                    let part = rendered.get();
                    let rows = rows.as_mut().map(|rows| (rows, index));
                    part.add_pairs(device, scene, &pairs, gradient, rows, continues)
                })?;
            }
        }
        rows.map_or(Ok(()), |rows| rows.add(units))?;
        finish(device, Some(self.grid.all), fields)
    }

    /// Finds the one scale of all ranks' hash grids. Returns the gradient of the pairs of each part, `[pairs, 3]`, if the part
    /// was kept.
    fn raise_bounds(
        &self,
        grad_output: &[f32],
        gradient: &ShareGradient,
    ) -> Result<Vec<Option<Buffer<Vec4>>>> {
        let device = self.renderer.device();
        let (mut samples, mut kept) = ([0; 2], Vec::new());
        for ((scene, parts), gradient) in self.parts().zip(&gradient.blocks) {
            for part in parts {
                let rendered = self.part(scene, part)?;
                let pairs = device.run_in_pool(|| {
                    let pairs = self.pair_gradient(scene, part, rendered.get(), grad_output)?;
                    rendered.get().raise_bounds(device, &pairs, gradient)?;
                    Ok::<_, Error>(pairs)
                })?;
                kept.push(part.part.is_some().then_some(pairs));
                samples = std::array::from_fn(|field| samples[field] + part.samples[field]);
            }
        }
        set_scales(device, Some(self.grid.all), &self.share.fields, &gradient.fields, samples)?;
        Ok(kept)
    }

    fn parts(&self) -> impl Iterator<Item = (&DeviceScene, &[SharePart])> {
        self.share.blocks().iter().zip(self.forward.parts.iter().map(Vec::as_slice))
    }

    /// A part that was kept, or rendered again.
    fn part<'p>(&self, slice: &DeviceScene, kept: &'p SharePart) -> Result<Rendered<'p>> {
        if let Some(part) = &kept.part {
            return Ok(Rendered::Kept(part));
        }
        let (renderer, device) = (self.renderer, self.renderer.device());
        let render = |capacity: Option<Capacity>| {
            let part = Part::evaluate(device, slice, self.cameras, &kept.plan, true, capacity)?;
            let (_, needed) = part.read(device, Vec::new())?;
            Ok((part, needed))
        };
        let work = || renderer.with_predicted_capacity(slice, &kept.plan, render);
        Ok(Rendered::Again(Box::new(device.run_in_pool(work)?)))
    }

    /// `[pairs, 3]`, of dL/dC and dL/dS at the sums of all Gaussians.
    fn pair_gradient(
        &self,
        slice: &DeviceScene,
        planned: &SharePart,
        part: &Part,
        grad_output: &[f32],
    ) -> Result<Buffer<Vec4>> {
        let (device, plan) = (self.renderer.device(), &planned.plan);
        let area = (plan.side * plan.side) as usize;
        let sums = of_tiles(&self.forward.sums, &plan.tiles, PLANES * area);
        device.write(&part.composite.sum, 0, &sums)?;
        let pixels = of_tiles(grad_output, &plan.tiles, 3 * area);
        let pixels = device.upload("gradient of the tiles", &pixels)?;
        part.pair_gradient(device, slice, plan.side, &pixels)
    }

    fn download(&self, gradient: &ShareGradient) -> Result<Gradient> {
        let ShareGradient { fields, blocks } = gradient;
        let (device, config) = (self.renderer.device(), self.share.config());
        let mut values = Scene::zeros(config.clone(), self.share.len())?;
        let of_fields = fields.download(device, config, 1)?.into_values();
        (values.color, values.transmittance) = (of_fields.color, of_fields.transmittance);
        let mut begin = 0;
        for (slice, gradient) in self.share.blocks().iter().zip(blocks) {
            let targets = values.gaussians.tensors_mut().zip(gradient.tensors.gaussians.as_ref());
            for (target, source) in targets.into_vec() {
                let source = source.read(device)?;
                let width = source.len() / slice.len();
                target[begin * width..][..source.len()].copy_from_slice(&source);
            }
            begin += slice.len();
        }
        Ok(Gradient::of(values))
    }
}

/// Gradients of the tensors of a share, or of a whole scene; kernels add to them.
#[derive(Debug)]
pub(crate) struct ShareGradient {
    /// Those of the fields.
    pub fields: SceneGradient,
    /// Those of each block's Gaussians; those of the fields are the same, on the same memory.
    pub blocks: Vec<SceneGradient>,
}

impl ShareGradient {
    /// Zeros for a share's Gaussians; `fields` are the gradients of [`DeviceShare::fields`].
    pub fn new(device: &Device, share: &DeviceShare, fields: SceneGradient) -> Result<Self> {
        let mut gradient = Self { fields, blocks: Vec::new() };
        gradient.replace_gaussians(device, share)?;
        Ok(gradient)
    }

    /// Zeros for the Gaussians that a share has now.
    pub fn replace_gaussians(&mut self, device: &Device, share: &DeviceShare) -> Result<()> {
        // not both at once
        self.blocks.clear();
        for block in share.blocks() {
            self.blocks.push(self.fields.of_block(device, block)?);
        }
        Ok(())
    }

    /// As [`SceneGradient::snapshot`].
    pub fn snapshot(&self, device: &Device) {
        self.blocks.iter().for_each(|block| block.snapshot(device));
    }

    /// As [`SceneGradient::rollback`].
    pub fn rollback(&self, device: &Device) {
        self.blocks.iter().chain([&self.fields]).for_each(|gradient| gradient.rollback(device));
    }
}

/// A part to go back through.
enum Rendered<'a> {
    Kept(&'a Part),
    Again(Box<Part>),
}

impl Rendered<'_> {
    fn get(&self) -> &Part {
        match self {
            Self::Kept(part) => part,
            Self::Again(part) => part,
        }
    }
}
