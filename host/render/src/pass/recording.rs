//! A rendered batch that keeps what its gradient needs, so that nothing is rendered twice.
//!
//! With Gaussians that are dealt to ranks, every rank knows C and S of all Gaussians. So it has dL/dC and dL/dS of Eq.
//! 13 without another message, and from them the gradients of its own Gaussians. Those of the fields and the poses are
//! added up as integers, as in [a step over views](crate::pass::step): their bits do not depend on the number of
//! ranks, either. In a [grid](Grid) of ranks, each group renders the tiles of some cameras. The ranks that have the
//! same shard add up its Gaussians' gradients camera by camera, as [`Rows`](crate::pass::ranks::Rows).

use std::slice::from_ref;
use std::sync::atomic::Ordering;

use super::renderer::Renderer;
use super::results::place;
use super::shard::{KeptPart, ShardForward};
use crate::scene::device_scene::DeviceScene;
use crate::scene::device_shard::DeviceShard;
use crate::stages::gradient::SceneGradient;
use crate::stages::project::POSE;
use organza_core::camera::Camera;
use organza_core::error::{Error, Result};
use organza_core::ranks::{Grid, Ranks};
use organza_core::scene::{Gradient, Scene};
use organza_core::tile::TileBatch;
use organza_core::{Channel, RenderedTiles};

/// The most parts that are kept: 2 GiB of tables, unless [`Renderer::with_part_bytes`] says otherwise.
const KEPT_PARTS: usize = 4;

/// A rendered batch, from which the gradient of any loss follows without rendering again.
///
/// ```
/// use organza_core::{Tile, TileBatch, demo};
/// use muslin_device::DeviceOptions;
/// use organza_render::{Renderer, open_device};
///
/// let renderer = Renderer::new(open_device(&DeviceOptions::cpu(None))?);
/// let scene = renderer.upload(&demo::scene())?;
/// let cameras = demo::turntable(1, 32);
/// let batch = TileBatch { side: 8, tiles: vec![Tile { camera: 0, origin: [12, 12] }] };
///
/// let recording = renderer.record(&scene, &cameras, &batch)?;
/// // the loss is half the sum of squares, so dL/dY is Y
/// let gradient = recording.backward(&recording.tiles().data)?;
/// assert_eq!(gradient.gaussians().position.len(), scene.len());
/// # Ok::<(), organza_core::Error>(())
/// ```
///
/// A batch in many parts keeps the first of them, as far as they fit; [`Recording::backward`] renders the others again.
#[derive(Debug)]
pub struct Recording<'a> {
    pub(crate) renderer: Renderer,
    pub(crate) fields: DeviceScene,
    /// The Gaussians, each block with the fields.
    pub(crate) blocks: Vec<DeviceScene>,
    /// [`DeviceScene::write`]s before it was rendered.
    version: u64,
    pub(crate) cameras: Vec<Camera>,
    pub(crate) batch: TileBatch,
    /// Those that have other Gaussians, and the cameras that all of their groups show.
    pub(crate) shared: Option<(Grid<'a>, usize)>,
    tiles: RenderedTiles,
    /// `[K, 4, S, S]`: C and S of the Gaussians of all ranks.
    pub(crate) sums: Vec<f32>,
    /// Of each block.
    pub(crate) parts: Vec<Vec<KeptPart>>,
}

/// [`DeviceScene::write`]s of all blocks.
fn version(blocks: &[DeviceScene]) -> u64 {
    blocks.iter().map(|block| block.version.load(Ordering::Relaxed)).sum()
}

impl Renderer {
    /// Like [`Renderer::render`], but keeps what the gradient needs.
    ///
    /// # Errors
    /// The same errors as [`Renderer::render`]; [`Error::Argument`] where the scene's grids or networks are halves.
    pub fn record(
        &self,
        scene: &DeviceScene,
        cameras: &[Camera],
        batch: &TileBatch,
    ) -> Result<Recording<'static>> {
        self.record_channels(scene, cameras, batch, &[])
    }

    /// Like [`Renderer::record`], with [channels](Channel) beside the color. They have no gradients.
    ///
    /// # Errors
    /// The same errors as [`Renderer::record`].
    pub fn record_channels(
        &self,
        scene: &DeviceScene,
        cameras: &[Camera],
        batch: &TileBatch,
        channels: &[Channel],
    ) -> Result<Recording<'static>> {
        batch.validate(cameras)?;
        scene.require_gradients()?;
        let version = version(from_ref(scene));
        let (parts, tiles) = self.in_parts(scene, batch, |plans| {
            let mut tiles = RenderedTiles::new(batch, channels)?;
            let mut parts: Vec<KeptPart> = Vec::with_capacity(plans.len());
            let mut most = KEPT_PARTS;
            for plan in plans {
                let render = || self.render_part(scene, cameras, plan, channels, true);
                let (part, rendered) = match render() {
                    Err(error) if error.is_out_of_memory() && most > 0 && !parts.is_empty() => {
                        // those that were kept may be what takes the memory
                        most = 0;
                        parts.iter_mut().for_each(|kept| kept.part = None);
                        render()?
                    }
                    rendered => rendered?,
                };
                let samples = [rendered.report.pairs, rendered.report.samples];
                place(&mut tiles, plan, rendered, channels)?;
                let part = (parts.len() < most).then_some(part);
                parts.push(KeptPart { plan: plan.clone(), samples, part });
            }
            Ok((parts, tiles))
        })?;
        Ok(Recording {
            renderer: self.clone(),
            fields: scene.view(),
            blocks: vec![scene.view()],
            version,
            cameras: cameras.to_vec(),
            batch: batch.clone(),
            shared: None,
            tiles,
            sums: Vec::new(),
            parts: vec![parts],
        })
    }

    /// Like [`Renderer::render_shard`], but keeps what the gradient needs.
    ///
    /// # Errors
    /// The same errors as [`Renderer::render_shard`]; [`Error::Argument`] where the scene's grids or networks are
    /// halves.
    pub fn record_shard<'a>(
        &self,
        shard: &DeviceShard,
        cameras: &[Camera],
        batch: &TileBatch,
        ranks: &'a dyn Ranks,
    ) -> Result<Recording<'a>> {
        batch.validate(cameras)?;
        let grid = Grid::one_group(ranks);
        self.record_group((shard, grid), cameras, batch, batch.tiles.len())
    }

    /// Records a group's part of a batch.
    pub(crate) fn record_group<'a>(
        &self,
        (shard, grid): (&DeviceShard, Grid<'a>),
        cameras: &[Camera],
        batch: &TileBatch,
        views: usize,
    ) -> Result<Recording<'a>> {
        shard.fields().require_gradients()?;
        let version = version(shard.blocks());
        let ShardForward { tiles, sums, parts } =
            self.shard_forward(shard, cameras, batch, &grid.row(), true)?;
        Ok(Recording {
            renderer: self.clone(),
            fields: shard.fields().view(),
            blocks: shard.blocks().iter().map(DeviceScene::view).collect(),
            version,
            cameras: cameras.to_vec(),
            batch: batch.clone(),
            shared: Some((grid, views)),
            tiles,
            sums,
            parts,
        })
    }
}

impl Recording<'_> {
    /// Y `[K, 3, S, S]`; if ranks share the batch, all of them have it.
    #[must_use]
    pub fn tiles(&self) -> &RenderedTiles {
        &self.tiles
    }

    /// dLoss/dtensor for every tensor of the scene, given `grad_output [K, 3, S, S]`, dLoss/dY: what
    /// [`Renderer::gradient`] gives. If ranks share the batch, `grad_output` is the same on all of them. The gradients
    /// of the Gaussians are those of this rank; those of the fields are of all Gaussians.
    ///
    /// # Errors
    /// [`Error::Argument`] where `grad_output` has another number of values, or where the scene has been written to
    /// since; [`Error::Diverged`] if a gradient is not finite; as [`Renderer::render`].
    pub fn backward(&self, grad_output: &[f32]) -> Result<Gradient> {
        self.check(grad_output)?;
        let gradient = SceneGradient::new(self.renderer.device(), &self.fields)?;
        self.download(&gradient, grad_output)
    }

    /// Like [`Recording::backward`], with the gradients of the poses of all cameras: `[cameras, 6]`, by the rotation
    /// vector and the shift of [`Camera::moved`], where both are 0. Those of a camera that shows no tile are 0. As the
    /// networks see positions and directions as constants, they see the camera's center as one.
    ///
    /// # Errors
    /// The same errors as [`Recording::backward`].
    pub fn backward_with_poses(&self, grad_output: &[f32]) -> Result<(Gradient, Vec<[f32; POSE]>)> {
        self.check(grad_output)?;
        let device = self.renderer.device();
        let gradient = SceneGradient::new(self.renderer.device(), &self.fields)?;
        let gradient = gradient.with_poses(device, self.cameras.len())?;
        let found = self.download(&gradient, grad_output)?;
        Ok((found, gradient.read_poses(device)?))
    }

    /// Like [`Recording::backward`], into buffers that are kept from one batch to the next. Their values before do not
    /// matter. [`TensorGradient::read_into`](crate::TensorGradient::read_into) and [`SceneGradient::download`] read
    /// them.
    ///
    /// # Errors
    /// The same errors as [`Recording::backward`]; [`Error::Argument`] if ranks share the Gaussians.
    pub fn backward_into(&self, gradient: &SceneGradient, grad_output: &[f32]) -> Result<()> {
        let device = self.renderer.device();
        self.check(grad_output)?;
        if self.shared.is_some() {
            let reason = "the gradient of a shard is not in one piece: use `backward`".to_owned();
            return Err(Error::Argument { reason });
        }
        gradient.clear(device);
        self.add_to(grad_output, gradient, from_ref(gradient))?;
        gradient.check(device)
    }

    /// Gives up the memory of what was kept. [`Recording::backward`] then renders again.
    pub fn release(&mut self) {
        self.parts.iter_mut().flatten().for_each(|kept| kept.part = None);
    }

    fn check(&self, grad_output: &[f32]) -> Result<()> {
        let found = grad_output.len();
        let shape = self.batch.output_shape();
        let reason = if found != shape.iter().product::<usize>() {
            format!("the gradient has {found} values, but the batch is {shape:?}")
        } else if self.version != version(&self.blocks) {
            "the scene has been written to since the batch was recorded: record it again".to_owned()
        } else {
            return Ok(());
        };
        Err(Error::Argument { reason })
    }

    /// Adds to new gradients, and reads them.
    fn download(&self, fields: &SceneGradient, grad_output: &[f32]) -> Result<Gradient> {
        let device = self.renderer.device();
        let config = &self.fields.config;
        if self.shared.is_none() {
            self.add_to(grad_output, fields, from_ref(fields))?;
            fields.check(device)?;
            return fields.download(device, config, self.fields.len());
        }
        let of_blocks = self.blocks.iter().map(|block| fields.zeros_for_block(device, block));
        let of_blocks = of_blocks.collect::<Result<Vec<_>>>()?;
        self.add_to(grad_output, fields, &of_blocks)?;
        fields.check(device)?;
        let len = self.blocks.iter().map(DeviceScene::len).sum();
        let mut values = Scene::zeros(config.clone(), len)?;
        let of_fields = fields.download(device, config, self.fields.len())?.into_values();
        (values.color, values.transmittance) = (of_fields.color, of_fields.transmittance);
        let mut rest = values.gaussians.tensors_mut();
        for gradient in &of_blocks {
            rest =
                rest.zip(gradient.tensors.gaussians.as_ref()).try_map(|_, (values, source)| {
                    let (values, after) = values.split_at_mut(source.range.len());
                    source.read_into(device, values)?;
                    Ok::<_, Error>(after)
                })?;
        }
        Ok(Gradient::new(values))
    }
}
