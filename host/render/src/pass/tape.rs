//! A rendered batch that keeps what its gradient needs, so that nothing is rendered twice.

use std::sync::atomic::Ordering;

use super::batch::Parts;
use super::output::Output;
use super::renderer::Renderer;
use crate::gradient::{POSE, SceneGradient};
use crate::loss::compare::LossSource;
use crate::scene::device_scene::DeviceScene;
use organza_core::error::argument;
use organza_core::scene::Gradient;
use organza_core::{Camera, Channel, RenderedTiles, Result, TileBatch};
use parking_lot::Mutex;

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
/// let tape = renderer.record(&scene, &cameras, &batch)?;
/// // the loss is half the sum of squares, so dL/dY is Y
/// let gradient = tape.backward(&tape.tiles().data)?;
/// assert_eq!(gradient.gaussians.position.len(), scene.len());
/// assert!(gradient.tensor("gaussians.opacity").is_some_and(|g| g.iter().any(|&g| g != 0.0)));
/// // in one call, for dL/dY that does not depend on Y
/// assert_eq!(renderer.gradient(&scene, &cameras, &batch, &tape.tiles().data)?, gradient);
/// # Ok::<(), organza_core::Error>(())
/// ```
///
/// A batch in many parts keeps the first of them, as far as they fit; [`Tape::backward`] renders the others again.
#[derive(Debug)]
pub struct Tape {
    renderer: Renderer,
    scene: DeviceScene,
    /// [`DeviceScene::write`]s before it was rendered.
    version: u64,
    cameras: Vec<Camera>,
    batch: TileBatch,
    tiles: RenderedTiles,
    parts: Mutex<Parts>,
}

impl Renderer {
    /// Like [`Renderer::render`], but keeps what the gradient needs.
    ///
    /// # Errors
    /// The same errors as [`Renderer::render`]; [`Error::Argument`](organza_core::Error::Argument) where the scene's
    /// grids or networks are halves.
    pub fn record(
        &self,
        scene: &DeviceScene,
        cameras: &[Camera],
        batch: &TileBatch,
    ) -> Result<Tape> {
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
    ) -> Result<Tape> {
        scene.require_gradients()?;
        let version = scene.version.load(Ordering::Relaxed);
        let pass = self.pass(scene, cameras);
        let mut parts = pass.cut(batch)?;
        let mut tiles = RenderedTiles::new(batch, channels)?;
        let output = &mut Output::Tiles { tiles: &mut tiles, channels };
        pass.forward(&mut parts, true, output, &mut |_| {})?;
        Ok(Tape {
            renderer: self.clone(),
            scene: scene.clone(),
            version,
            cameras: cameras.to_vec(),
            batch: batch.clone(),
            tiles,
            parts: parts.into(),
        })
    }

    /// dL/dtensor for every tensor of a scene, given `grad_tiles [K, 3, S, S]`, dL/dY.
    ///
    /// The networks see positions and directions as constants: position, rotation and scale have the gradient of the
    /// projection alone. [`Renderer::record`] gives the tiles, too; [`Tape`] has an example.
    ///
    /// # Errors
    /// The same errors as [`Tape::backward`](crate::Tape::backward).
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
    /// The same errors as [`Renderer::gradient`]. If memory ran out meanwhile, `gradient` has lost its earlier values.
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
        gradient.snapshot(self.device());
        pass.backward(&mut parts, &mut LossSource::Given(grad_tiles), gradient)?;
        gradient.check(self.device())
    }
}

impl Tape {
    /// Y `[K, 3, S, S]`
    pub fn tiles(&self) -> &RenderedTiles {
        &self.tiles
    }

    /// dL/dtensor for every tensor of the scene, given `grad_tiles [K, 3, S, S]`, dL/dY: what
    /// [`Renderer::gradient`] gives.
    ///
    /// # Errors
    /// [`Error::Argument`](organza_core::Error::Argument) where `grad_tiles` has another number of values, or where the
    /// scene has been written to since; [`Error::Diverged`](organza_core::Error::Diverged) if a gradient is not finite;
    /// as [`Renderer::render`].
    pub fn backward(&self, grad_tiles: &[f32]) -> Result<Gradient> {
        self.download(grad_tiles, false).map(|(gradient, _)| gradient)
    }

    /// Like [`Tape::backward`], with the gradients of the poses of all cameras, `[cameras, 6]`: with respect to the rotation vector
    /// and the shift of [`Camera::moved`], at 0. The gradients of a camera that shows no tile are 0. As the
    /// networks see positions and directions as constants, they see the camera's center as one.
    ///
    /// # Errors
    /// The same errors as [`Tape::backward`].
    pub fn backward_with_poses(&self, grad_tiles: &[f32]) -> Result<(Gradient, Vec<[f32; POSE]>)> {
        self.download(grad_tiles, true)
    }

    /// Like [`Tape::backward`], into buffers that are kept from one batch to the next. Their values before do not
    /// matter. [`TensorGradient::read`](crate::TensorGradient::read) and [`SceneGradient::download`] read
    /// them.
    ///
    /// # Errors
    /// The same errors as [`Tape::backward`].
    pub fn backward_into(&self, gradient: &SceneGradient, grad_tiles: &[f32]) -> Result<()> {
        let device = self.renderer.device();
        let found = grad_tiles.len();
        let shape = self.batch.output_shape();
        let reason = if found != shape.iter().product::<usize>() {
            format!("the gradient has {found} values, but the batch is {shape:?}")
        } else if self.version != self.scene.version.load(Ordering::Relaxed) {
            "the scene has been written to since the batch was recorded: record it again".to_owned()
        } else {
            gradient.clear(device);
            let pass = self.renderer.pass(&self.scene, &self.cameras);
            pass.backward(&mut self.parts.lock(), &mut LossSource::Given(grad_tiles), gradient)?;
            return gradient.check(device);
        };
        argument(reason)
    }

    /// Gives up the memory of kept parts. [`Tape::backward`] then renders again.
    pub fn release(&mut self) {
        self.parts.lock().release();
    }

    fn download(
        &self,
        grad_tiles: &[f32],
        has_poses: bool,
    ) -> Result<(Gradient, Vec<[f32; POSE]>)> {
        let device = self.renderer.device();
        let mut gradient = SceneGradient::new(device, &self.scene)?;
        if has_poses {
            gradient = gradient.with_poses(device, self.cameras.len())?;
        }
        self.backward_into(&gradient, grad_tiles)?;
        let found = gradient.download(device, &self.scene.config, self.scene.len())?;
        Ok((found, gradient.read_poses(device)?))
    }
}
