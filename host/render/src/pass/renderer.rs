//! Renders batches of tiles, part by part.

use organza_core::{Channel, RenderReport, RenderedTiles};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use super::capacity::CapacityPredictor;
use super::results::place;
use crate::pass::part::{self, Part, RenderedPart, report_of_part};
use crate::scene::device_scene::DeviceScene;
use crate::scene::device_shard::{DeviceShard, WHOLE};
use crate::scene::options::UploadOptions;
use crate::stages::composite::pixels;
use crate::stages::counts::{Capacity, Needed};
use crate::stages::cut::{Limits, PART_BYTES, PartTiles};
use muslin_device::Device;
use organza_core::camera::Camera;
use organza_core::error::Result;
use organza_core::image::{self, Image};
use organza_core::scene::{GAUSSIANS_PER_BLOCK, Scene, SceneShard};
use organza_core::tile::TileBatch;

/// Renders scenes on a device.
///
/// ```
/// use organza_core::{Tile, TileBatch, demo};
/// use muslin_device::DeviceOptions;
/// use organza_render::{Renderer, open_device};
///
/// // DeviceOptions::default() takes a GPU if there is one
/// let renderer = Renderer::new(open_device(&DeviceOptions::cpu(None))?);
/// // or Scene::load("scene.safetensors"), and scene.config.placement.load_cameras("cameras.json")
/// let scene = renderer.upload(&demo::scene())?;
/// let cameras = demo::turntable(2, 48);
///
/// // two tiles of 16 x 16 pixels, one of each camera
/// let tiles = (0..2).map(|camera| Tile { camera, origin: [16, 16] }).collect();
/// let rendered = renderer.render(&scene, &cameras, &TileBatch { side: 16, tiles })?;
/// assert_eq!(rendered.data.len(), 2 * 3 * 16 * 16); // [K, 3, S, S]
/// let [red, green, blue] = rendered.rgb(1, 8, 8);
/// assert!(red > 0.0 && green > 0.0 && blue > 0.0);
///
/// // a whole image
/// let image = renderer.render_view(&scene, &cameras[0])?;
/// assert_eq!(image.size(), [48, 48]);
/// # Ok::<(), organza_core::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Renderer {
    pub(crate) device: Arc<Device>,
    pub(crate) part_bytes: Arc<AtomicU64>,
    predictor: Arc<Mutex<CapacityPredictor>>,
}

impl Renderer {
    /// A renderer on `device`.
    #[must_use]
    pub fn new(device: Device) -> Self {
        Self {
            device: Arc::new(device),
            part_bytes: Arc::new(PART_BYTES.into()),
            predictor: Arc::default(),
        }
    }

    /// The same renderer, whose batches are cut into parts with tables of about this many bytes; 512 MiB unless set.
    ///
    /// A part holds at least one tile, so that it may take more; what a part takes beside its tables grows with the
    /// pairs and samples of its tiles.
    #[must_use]
    pub fn with_part_bytes(mut self, bytes: u64) -> Self {
        self.part_bytes = Arc::new(bytes.into());
        self
    }

    /// The device it renders on.
    #[must_use]
    pub fn device(&self) -> &Device {
        &self.device
    }

    /// Renders a batch of tiles.  A batch that does not fit into the device's memory is rendered in parts; a part does
    /// not change the image.
    ///
    /// # Errors
    /// [`Error::Tile`](organza_core::Error::Tile) where a tile has no camera or an impossible place,
    /// [`DeviceError::OutOfMemory`](organza_core::error::DeviceError::OutOfMemory) where a single tile does not fit,
    /// [`DeviceError::DeviceLost`](organza_core::error::DeviceError::DeviceLost).
    pub fn render(
        &self,
        scene: &DeviceScene,
        cameras: &[Camera],
        batch: &TileBatch,
    ) -> Result<RenderedTiles> {
        self.render_with_progress(scene, cameras, batch, &mut |_, _| {})
    }

    /// Like [`Renderer::render`], but calls `progress` after each part with the number of tiles that are done, and of
    /// all.
    ///
    /// # Errors
    /// The same errors as [`Renderer::render`].
    pub fn render_with_progress(
        &self,
        scene: &DeviceScene,
        cameras: &[Camera],
        batch: &TileBatch,
        progress: &mut dyn FnMut(usize, usize),
    ) -> Result<RenderedTiles> {
        self.render_channels(scene, cameras, batch, &[], progress)
    }

    /// Like [`Renderer::render_with_progress`], with [channels](Channel) beside the color.
    ///
    /// # Errors
    /// The same errors as [`Renderer::render`].
    pub fn render_channels(
        &self,
        scene: &DeviceScene,
        cameras: &[Camera],
        batch: &TileBatch,
        channels: &[Channel],
        progress: &mut dyn FnMut(usize, usize),
    ) -> Result<RenderedTiles> {
        batch.validate(cameras)?;
        let mut tiles = RenderedTiles::new(batch, channels)?;
        self.render_parts(scene, batch, progress, &mut |plan| {
            let (_, part) = self.render_part(scene, cameras, plan, channels, false)?;
            place(&mut tiles, plan, part, channels)?;
            Ok(true)
        })?;
        Ok(tiles)
    }

    /// Renders tiles of one camera into its image, in 8 bits: values are clamped to 0 to 1 and rounded on the device.
    /// `progress` is that of [`Renderer::render_with_progress`].
    ///
    /// # Errors
    /// The same errors as [`Renderer::render`].
    pub fn paint(
        &self,
        image: &mut Image,
        scene: &DeviceScene,
        cameras: &[Camera],
        batch: &TileBatch,
        progress: &mut dyn FnMut(usize, usize),
    ) -> Result<RenderReport> {
        batch.validate(cameras)?;
        let device = self.device();
        let mut report = RenderReport::default();
        self.render_parts(scene, batch, progress, &mut |plan| {
            let paint = |capacity| {
                let part = Part::evaluate(scene, cameras, plan, false, capacity)?;
                let pixels = pixels(device, plan.side, &part.composite.image)?;
                let buffers = vec![pixels, part.bins.degenerate.view()];
                let (words, needed) = part.read(device, buffers)?;
                Ok(((words, needed), needed))
            };
            let (words, needed) =
                device.run_in_pool(|| self.with_predicted_capacity(scene, plan, paint))?;
            let tiles: Vec<_> = plan.tiles.iter().map(|planned| planned.tile).collect();
            device.run_in_pool(|| image.paste_words(plan.side, &tiles, &words[0]));
            report.add(&report_of_part(words[1][0], needed));
            Ok(true)
        })?;
        Ok(report)
    }

    /// Does something for a batch part by part, as long as `render` is true. Returns whether it was to the end.
    pub(crate) fn render_parts(
        &self,
        scene: &DeviceScene,
        batch: &TileBatch,
        progress: &mut dyn FnMut(usize, usize),
        render: &mut dyn FnMut(&PartTiles) -> Result<bool>,
    ) -> Result<bool> {
        let mut done = 0;
        let mut plans = self.plans(scene, batch)?;
        while let Some(plan) = plans.pop() {
            match render(&plan) {
                Ok(false) => return Ok(false),
                Ok(true) => {
                    done += plan.tiles.len();
                    progress(done, batch.tiles.len());
                }
                Err(error) if error.is_out_of_memory() && plan.tiles.len() > 1 => {
                    plans.extend(plan.halves())
                }
                Err(error) if error.is_out_of_memory() && self.forget() => plans.push(plan),
                Err(error) => return Err(error),
            }
        }
        Ok(true)
    }

    /// Renders a part; `keep` says whether it will be gone back through.
    pub(crate) fn render_part(
        &self,
        scene: &DeviceScene,
        cameras: &[Camera],
        plan: &PartTiles,
        channels: &[Channel],
        keep: bool,
    ) -> Result<(Part, RenderedPart)> {
        let device = self.device();
        let render = |capacity| Ok(part::render(scene, cameras, plan, channels, keep, capacity)?);
        device.run_in_pool(|| self.with_predicted_capacity(scene, plan, render))
    }
}

impl Renderer {
    /// Copies a scene to the device, as it is; [`Renderer::upload_with`] has choices.
    ///
    /// # Errors
    /// The errors of [`Scene::validate`], and [`DeviceError::OutOfMemory`](organza_core::error::DeviceError::OutOfMemory).
    pub fn upload(&self, scene: &Scene) -> Result<DeviceScene> {
        self.upload_with(scene, UploadOptions::default())
    }

    /// Like [`Renderer::upload`], with choices that are for rendering alone.
    ///
    /// # Errors
    /// The same errors as [`Renderer::upload`]; [`Error::Invalid`](organza_core::Error::Invalid) where
    /// [`UploadOptions`] says that it is refused.
    pub fn upload_with(&self, scene: &Scene, options: UploadOptions) -> Result<DeviceScene> {
        DeviceScene::upload(&self.device, scene, options)
    }

    /// Copies the Gaussians of a shard, and the fields of its scene, to the device. A shard may have no Gaussians.
    ///
    /// # Errors
    /// The same errors as [`Renderer::upload_with`].
    pub fn upload_shard(&self, shard: &SceneShard, options: UploadOptions) -> Result<DeviceShard> {
        DeviceShard::upload(&self.device, &shard.scene, GAUSSIANS_PER_BLOCK, options)
    }

    /// Copies a scene to the device as training has it: in one block, or in those of a shard.
    ///
    /// # Errors
    /// The same errors as [`Renderer::upload`].
    pub fn upload_blocks(&self, scene: &Scene, is_shard: bool) -> Result<DeviceShard> {
        let block = if is_shard { GAUSSIANS_PER_BLOCK } else { WHOLE };
        DeviceShard::upload(&self.device, scene, block, UploadOptions::default())
    }

    /// Renders the whole image of a camera. Values are clamped to 0 to 1 and rounded to 8 bits.
    ///
    /// # Errors
    /// The same errors as [`Renderer::render`].
    pub fn render_view(&self, scene: &DeviceScene, camera: &Camera) -> Result<Image> {
        let size = [camera.width, camera.height];
        let mut image = Image::new(size[0], size[1])?;
        for batch in image::bands(0, size, image::TILE_SIDE) {
            let cameras = std::slice::from_ref(camera);
            self.paint(&mut image, scene, cameras, &batch?, &mut |_, _| {})?;
        }
        Ok(image)
    }

    /// The parts of a batch, last first.
    pub(crate) fn plans(&self, scene: &DeviceScene, batch: &TileBatch) -> Result<Vec<PartTiles>> {
        Ok(PartTiles::split(scene, batch, self.part_bytes.load(Ordering::Relaxed))?)
    }

    /// The view batches of a batch, and what joins them to parts.
    pub(crate) fn view_batches(
        &self,
        scene: &DeviceScene,
        batch: &TileBatch,
    ) -> Result<(Vec<PartTiles>, Limits)> {
        Ok(PartTiles::view_batches(scene, batch, self.part_bytes.load(Ordering::Relaxed))?)
    }

    /// Does `work` for a part with a predicted capacity, so that nothing waits for the device before the end. If the
    /// capacity was too small, or without a prediction, does it with room for everything.
    pub(crate) fn with_predicted_capacity<R>(
        &self,
        scene: &DeviceScene,
        plan: &PartTiles,
        mut work: impl FnMut(Option<Capacity>) -> Result<(R, Needed)>,
    ) -> Result<R> {
        let kind = [scene.gaussians, plan.side];
        let tiles = plan.tiles.len();
        let guesses = self.device.leaves_counts_on_device();
        let mut capacity = if guesses { self.predictor().predict(kind, tiles) } else { None };
        loop {
            match work(capacity)? {
                (result, Needed::Capacity(needed)) => {
                    if guesses {
                        self.predictor().observe(kind, tiles, needed);
                    }
                    return Ok(result);
                }
                (_, Needed::Overflow) => capacity = None,
            }
        }
    }

    /// Forgets the predictions, after memory ran out: a part may need less. Returns whether there were any.
    pub(crate) fn forget(&self) -> bool {
        std::mem::take(&mut *self.predictor()) != CapacityPredictor::default()
    }

    fn predictor(&self) -> MutexGuard<'_, CapacityPredictor> {
        self.predictor.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
