//! A rendered batch that keeps what its gradient needs, so that nothing is rendered twice.

use std::sync::atomic::Ordering;
use std::sync::{Mutex, MutexGuard, PoisonError};

use super::pass::{Parts, Pass};
use crate::{
    DeviceScene, DeviceShard, GradientBlocks, POSE, Renderer, SceneBlocks, SceneGradient,
    ShardGradient,
};
use organza_core::ranks::{Grid, Ranks};
use organza_core::scene::{Gaussians, Gradient};
use organza_core::{Camera, Channel, Error, RenderedTiles, Result, TileBatch};

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
/// assert_eq!(gradient.gaussians.position.len(), scene.len());
/// # Ok::<(), organza_core::Error>(())
/// ```
///
/// A batch in many parts keeps the first of them, as far as they fit; [`Recording::backward`] renders the others again.
#[derive(Debug)]
pub struct Recording<'a> {
    renderer: Renderer,
    fields: DeviceScene,
    blocks: Vec<DeviceScene>,
    is_shard: bool,
    /// [`DeviceScene::write`]s before it was rendered.
    version: u64,
    cameras: Vec<Camera>,
    batch: TileBatch,
    /// The ranks that have other Gaussians.
    grid: Option<Grid<'a>>,
    tiles: RenderedTiles,
    /// `[K, 4, S, S]`: C and S of the Gaussians of all ranks; nothing where this one has them all.
    sums: Vec<f32>,
    parts: Mutex<Parts>,
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
        self.record_blocks(scene.into(), cameras, batch, channels, None)
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
        self.record_blocks(shard.into(), cameras, batch, &[], Some(Grid::one_group(ranks)))
    }

    fn record_blocks<'a>(
        &self,
        scene: SceneBlocks<'_>,
        cameras: &[Camera],
        batch: &TileBatch,
        channels: &[Channel],
        grid: Option<Grid<'a>>,
    ) -> Result<Recording<'a>> {
        batch.validate(cameras)?;
        scene.fields.require_gradients()?;
        let version = version(scene.blocks);
        let pass = Pass { grid, ..self.pass(scene, cameras) };
        let mut parts = pass.cut(batch)?;
        let ignore = &mut |_, _| {};
        let (tiles, sums) = match scene.is_shard {
            true => pass.forward_sums(&mut parts, batch, true)?,
            false => (pass.forward_tiles(&mut parts, batch, channels, true, ignore)?, Vec::new()),
        };
        Ok(Recording {
            renderer: self.clone(),
            fields: scene.fields.clone(),
            blocks: scene.blocks.to_vec(),
            is_shard: scene.is_shard,
            version,
            cameras: cameras.to_vec(),
            batch: batch.clone(),
            grid,
            tiles,
            sums,
            parts: parts.into(),
        })
    }

    /// Renders a batch of tiles together with other ranks: each has its shard of the same scene, and the same batch,
    /// and gets all tiles. The report counts what all ranks did.
    ///
    /// The tiles differ from those of [`Renderer::render`] by rounding: by 2^-32 for each block, and because a pixel's
    /// sum begins anew with each.
    ///
    /// # Errors
    /// The same errors as [`Renderer::render`]; [`Error::Rank`](organza_core::Error::Rank) where another rank has
    /// failed. The caller [tells](Ranks::fail) the others of its own.
    pub fn render_shard(
        &self,
        shard: &DeviceShard,
        cameras: &[Camera],
        batch: &TileBatch,
        ranks: &dyn Ranks,
    ) -> Result<RenderedTiles> {
        batch.validate(cameras)?;
        let pass = Pass { grid: Some(Grid::one_group(ranks)), ..self.pass(shard, cameras) };
        let mut parts = pass.cut(batch)?;
        Ok(pass.forward_sums(&mut parts, batch, false)?.0)
    }

    /// dL/dtensor for every tensor of a scene, given `grad_tiles [K, 3, S, S]`, dL/dY.
    ///
    /// The networks see positions and directions as constants: position, rotation and scale have the gradient of the
    /// projection alone. [`Renderer::record`] gives the tiles, too.
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
    /// // the loss is the sum of all values, so dL/dY is 1 everywhere
    /// let ones = vec![1.0; batch.output_shape().iter().product()];
    /// let gradient = renderer.gradient(&scene, &cameras, &batch, &ones)?;
    /// assert_eq!(gradient.gaussians.position.len(), scene.len());
    /// assert!(gradient.tensor("gaussians.opacity").is_some_and(|g| g.iter().any(|&g| g != 0.0)));
    /// # Ok::<(), organza_core::Error>(())
    /// ```
    ///
    /// # Errors
    /// The same errors as [`Recording::backward`](crate::Recording::backward).
    pub fn gradient(
        &self,
        scene: &DeviceScene,
        cameras: &[Camera],
        batch: &TileBatch,
        grad_tiles: &[f32],
    ) -> Result<Gradient> {
        self.record(scene, cameras, batch)?.backward(grad_tiles)
    }

    /// Adds dL/dtensor of `grad_tiles [K, 3, S, S]` to `gradient`, and waits for it. Nothing is kept.
    ///
    /// # Errors
    /// The same errors as [`Renderer::gradient`]. If memory ran out on the way, `gradient` has lost its earlier values.
    pub fn add_gradient(
        &self,
        scene: &DeviceScene,
        cameras: &[Camera],
        batch: &TileBatch,
        grad_tiles: &[f32],
        gradient: &SceneGradient,
    ) -> Result<()> {
        let pass = self.pass(scene, cameras);
        let mut parts = pass.cut(batch)?;
        let into = GradientBlocks::from(gradient);
        into.snapshot(self.device());
        pass.backward_from(&mut parts, grad_tiles, into)?;
        gradient.check(self.device())
    }
}

impl Recording<'_> {
    /// Y `[K, 3, S, S]`; if ranks share the batch, all of them have it.
    #[must_use]
    pub fn tiles(&self) -> &RenderedTiles {
        &self.tiles
    }

    /// dL/dtensor for every tensor of the scene, given `grad_tiles [K, 3, S, S]`, dL/dY: what
    /// [`Renderer::gradient`] gives. If ranks share the batch, `grad_tiles` is the same on all of them. The gradients
    /// of the Gaussians are those of this rank; those of the fields are of all Gaussians.
    ///
    /// # Errors
    /// [`Error::Argument`] where `grad_tiles` has another number of values, or where the scene has been written to
    /// since; [`Error::Diverged`] if a gradient is not finite; as [`Renderer::render`].
    pub fn backward(&self, grad_tiles: &[f32]) -> Result<Gradient> {
        self.download(grad_tiles, false).map(|(gradient, _)| gradient)
    }

    /// Like [`Recording::backward`], with the gradients of the poses of all cameras: `[cameras, 6]`, by the rotation
    /// vector and the shift of [`Camera::moved`], where both are 0. Those of a camera that shows no tile are 0. As the
    /// networks see positions and directions as constants, they see the camera's center as one.
    ///
    /// # Errors
    /// The same errors as [`Recording::backward`].
    pub fn backward_with_poses(&self, grad_tiles: &[f32]) -> Result<(Gradient, Vec<[f32; POSE]>)> {
        self.download(grad_tiles, true)
    }

    /// Like [`Recording::backward`], into buffers that are kept from one batch to the next. Their values before do not
    /// matter. [`TensorGradient::read_into`](crate::TensorGradient::read_into) and [`SceneGradient::download`] read
    /// them.
    ///
    /// # Errors
    /// The same errors as [`Recording::backward`]; [`Error::Argument`] if ranks share the Gaussians.
    pub fn backward_into(&self, gradient: &SceneGradient, grad_tiles: &[f32]) -> Result<()> {
        let device = self.renderer.device();
        self.check(grad_tiles)?;
        if self.is_shard {
            let reason = "the gradient of a shard is not in one piece: use `backward`".to_owned();
            return Err(Error::Argument { reason });
        }
        gradient.clear(device);
        self.add_to(grad_tiles, gradient.into())?;
        gradient.check(device)
    }

    /// Gives up the memory of kept parts. [`Recording::backward`] then renders again.
    pub fn release(&mut self) {
        self.parts().release();
    }

    fn parts(&self) -> MutexGuard<'_, Parts> {
        self.parts.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn check(&self, grad_tiles: &[f32]) -> Result<()> {
        let found = grad_tiles.len();
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

    /// Adds dL/dtensor to gradients that are zero.
    fn add_to(&self, grad_tiles: &[f32], into: GradientBlocks<'_>) -> Result<()> {
        let Self { renderer, fields, blocks, is_shard, cameras, grid, sums, .. } = self;
        let scene = SceneBlocks { fields, blocks, is_shard: *is_shard };
        let views = self.batch.tiles.len();
        let pass = Pass { renderer, scene, cameras, grid: *grid, views, sums };
        into.snapshot(renderer.device());
        pass.backward_from(&mut self.parts(), grad_tiles, into)
    }

    /// Adds to new gradients, and reads them, with those of the poses if they are wanted.
    fn download(
        &self,
        grad_tiles: &[f32],
        has_poses: bool,
    ) -> Result<(Gradient, Vec<[f32; POSE]>)> {
        self.check(grad_tiles)?;
        let device = self.renderer.device();
        let one = Gaussians::zeros(&self.fields.config, 1)?;
        let mut fields = SceneGradient::new(device, &self.fields.with_gaussians(device, &one)?)?;
        if has_poses {
            fields = fields.with_poses(device, self.cameras.len())?;
        }
        let gradient = ShardGradient::of_blocks(device, &self.blocks, fields)?;
        self.add_to(grad_tiles, (&gradient).into())?;
        gradient.fields.check(device)?;
        let found = gradient.download(device, &self.fields.config)?;
        Ok((found, gradient.fields.read_poses(device)?))
    }
}
