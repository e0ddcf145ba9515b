//! A rendered batch that keeps what its gradient needs, so that nothing is rendered twice.

use std::sync::atomic::Ordering;

use super::backward::of_tiles;
use super::channels::Channel;
use super::gradient::SceneGradient;
use super::part::Part;
use super::plan::Plan;
use super::pose::POSE;
use super::renderer::Renderer;
use super::results::RenderedTiles;
use super::scene::DeviceScene;
use crate::camera::Camera;
use crate::error::{Error, Result};
use crate::scene::Gradient;
use crate::tile::TileBatch;

/// The most parts that are kept: 2 GiB of tables, unless [`Renderer::with_part_bytes`] says otherwise.
const KEPT_PARTS: usize = 4;

/// A rendered batch, from which the gradient of any loss follows without rendering again.
///
/// ```
/// use organza::{DeviceOptions, Renderer, Tile, TileBatch, demo};
///
/// let renderer = Renderer::new(organza::open_device(&DeviceOptions::cpu(None))?);
/// let scene = renderer.upload(&demo::scene())?;
/// let cameras = demo::turntable(1, 32);
/// let batch = TileBatch { side: 8, tiles: vec![Tile { camera: 0, origin: [12, 12] }] };
///
/// let recording = renderer.record(&scene, &cameras, &batch)?;
/// // the loss is half the sum of squares, so dL/dY is Y
/// let gradient = recording.backward(&recording.tiles().data)?;
/// assert_eq!(gradient.gaussians().position.len(), scene.len());
/// # Ok::<(), organza::Error>(())
/// ```
///
/// A batch in many parts keeps the first of them, as far as they fit; [`Recording::backward`] renders the others again.
#[derive(Debug)]
pub struct Recording {
    renderer: Renderer,
    scene: DeviceScene,
    /// [`DeviceScene::write`]s before it was rendered.
    version: u64,
    cameras: Vec<Camera>,
    batch: TileBatch,
    parts: Vec<(Plan, Option<Part>)>,
    tiles: RenderedTiles,
}

impl Renderer {
    /// As [`Renderer::render`], and keeps what the gradient needs.
    ///
    /// # Errors
    /// As [`Renderer::render`]; [`Error::Argument`] where the scene's grids or networks are halves.
    pub fn record(
        &self,
        scene: &DeviceScene,
        cameras: &[Camera],
        batch: &TileBatch,
    ) -> Result<Recording> {
        self.record_channels(scene, cameras, batch, &[])
    }

    /// As [`Renderer::record`], with [channels](Channel) beside the color. They have no gradients.
    ///
    /// # Errors
    /// As [`Renderer::record`].
    pub fn record_channels(
        &self,
        scene: &DeviceScene,
        cameras: &[Camera],
        batch: &TileBatch,
        channels: &[Channel],
    ) -> Result<Recording> {
        batch.validate(cameras)?;
        scene.require_gradients()?;
        let version = scene.version.load(Ordering::Relaxed);
        let (parts, tiles) = self.in_parts(scene, batch, |plans| {
            let mut tiles = RenderedTiles::zeros(batch, channels)?;
            let mut parts: Vec<(Plan, Option<Part>)> = Vec::with_capacity(plans.len());
            let mut most = KEPT_PARTS;
            for plan in plans {
                let render = || self.render_part(scene, cameras, plan, channels, true);
                let (part, rendered) = match render() {
                    Err(error) if error.is_out_of_memory() && most > 0 && !parts.is_empty() => {
                        // those that were kept may be what takes the memory
                        most = 0;
                        parts.iter_mut().for_each(|(_, part)| *part = None);
                        render()?
                    }
                    rendered => rendered?,
                };
                tiles.place(plan, &rendered, channels);
                let kept = (parts.len() < most).then_some(part);
                parts.push((plan.clone(), kept));
            }
            Ok((parts, tiles))
        })?;
        let (renderer, scene) = (self.clone(), scene.view());
        let (cameras, batch) = (cameras.to_vec(), batch.clone());
        Ok(Recording { renderer, scene, version, cameras, batch, parts, tiles })
    }
}

impl Recording {
    /// Y `[K, 3, S, S]`
    #[must_use]
    pub fn tiles(&self) -> &RenderedTiles {
        &self.tiles
    }

    /// dLoss/dtensor for every tensor of the scene, given `grad_output [K, 3, S, S]`, dLoss/dY: what
    /// [`Renderer::gradient`] gives.
    ///
    /// # Errors
    /// [`Error::Argument`] where `grad_output` has another number of values, or where the scene has been written to
    /// since; [`Error::Diverged`] if a gradient is not finite; as [`Renderer::render`].
    pub fn backward(&self, grad_output: &[f32]) -> Result<Gradient> {
        let device = self.renderer.device();
        self.check(grad_output)?;
        let gradient = SceneGradient::new(device, &self.scene)?;
        self.add_to(&gradient, grad_output)?;
        gradient.check(device)?;
        gradient.download(device, &self.scene.config, self.scene.len())
    }

    /// As [`Recording::backward`], with the gradients of the poses of all cameras: `[cameras, 6]`, by the rotation vector
    /// and the shift of [`Camera::moved`], where both are 0. Those of a camera that shows no tile are 0. As the networks see
    /// positions and directions as constants, they see the camera's center as one.
    ///
    /// # Errors
    /// As [`Recording::backward`].
    pub fn backward_with_poses(&self, grad_output: &[f32]) -> Result<(Gradient, Vec<[f32; POSE]>)> {
        let device = self.renderer.device();
        self.check(grad_output)?;
        let gradient = SceneGradient::new(device, &self.scene)?;
        let gradient = gradient.with_poses(device, self.cameras.len())?;
        self.add_to(&gradient, grad_output)?;
        gradient.check(device)?;
        let poses = gradient.read_poses(device)?;
        Ok((gradient.download(device, &self.scene.config, self.scene.len())?, poses))
    }

    /// As [`Recording::backward`], into buffers that are kept from one batch to the next. Their values before do not
    /// matter. [`TensorGradient::read_into`](super::TensorGradient::read_into) and [`SceneGradient::download`] read them.
    ///
    /// # Errors
    /// As [`Recording::backward`].
    pub fn backward_into(&self, gradient: &SceneGradient, grad_output: &[f32]) -> Result<()> {
        let device = self.renderer.device();
        self.check(grad_output)?;
        gradient.clear(device);
        self.add_to(gradient, grad_output)?;
        gradient.check(device)
    }

    /// Gives up the memory of what was kept. [`Recording::backward`] then renders again.
    pub fn release(&mut self) {
        self.parts.iter_mut().for_each(|(_, part)| *part = None);
    }

    fn check(&self, grad_output: &[f32]) -> Result<()> {
        let (found, shape) = (grad_output.len(), self.batch.output_shape());
        let reason = if found != shape.iter().product::<usize>() {
            format!("the gradient has {found} values, but the batch is {shape:?}")
        } else if self.version != self.scene.version.load(Ordering::Relaxed) {
            "the scene has been written to since the batch was recorded: record it again".to_owned()
        } else {
            return Ok(());
        };
        Err(Error::Argument { reason })
    }

    /// Adds dLoss/dtensor to `gradient`: that of a step, zero before but for the statistics.
    ///
    /// # Errors
    /// As [`Recording::backward`], but for [`Error::Diverged`]. The gradient is then as it was before.
    pub(crate) fn add_to(&self, gradient: &SceneGradient, grad_output: &[f32]) -> Result<()> {
        let device = self.renderer.device();
        gradient.snapshot(device);
        let add = || {
            self.parts.iter().try_for_each(|(plan, part)| match part {
                Some(part) => self.add_part(plan, part, grad_output, gradient),
                None => self.add_again(std::slice::from_ref(plan), grad_output, gradient),
            })
        };
        match add() {
            Err(error) if error.is_out_of_memory() => {
                gradient.rollback(device);
                let again = |plans: &[Plan]| {
                    let added = self.add_again(plans, grad_output, gradient);
                    added.inspect_err(|_| gradient.rollback(device))
                };
                self.renderer.in_parts(&self.scene, &self.batch, again)
            }
            result => result.inspect_err(|_| gradient.rollback(device)),
        }
    }

    /// Adds the gradient of a part that was kept.
    fn add_part(
        &self,
        plan: &Plan,
        part: &Part,
        grad_output: &[f32],
        gradient: &SceneGradient,
    ) -> Result<()> {
        let device = self.renderer.device();
        let pixels = of_tiles(grad_output, &plan.tiles, 3 * (plan.side * plan.side) as usize);
        let pixels = device.upload("gradient of the tiles", &pixels)?;
        device.run_in_pool(|| part.backward(device, &self.scene, plan.side, &pixels, gradient))
    }

    /// Renders parts again, and adds their gradients.
    fn add_again(
        &self,
        plans: &[Plan],
        grad_output: &[f32],
        gradient: &SceneGradient,
    ) -> Result<()> {
        self.renderer.add_parts(&self.scene, &self.cameras, plans, grad_output, gradient)
    }
}
