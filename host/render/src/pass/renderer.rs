//! Renders batches of tiles, part by part.

use organza_core::{Camera, Channel, RenderReport, RenderedTiles, Result, TileBatch};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use super::part::{ReadTiles, report_of_part};
use super::pass::{CapacityPredictor, Parts, Pass};
use crate::stages::composite::pixels;
use crate::stages::cut::{PART_BYTES, PartTiles};
use crate::{Capacity, DeviceScene, UploadOptions};
use muslin_device::{Device, memory};
use organza_core::image::{self, Image};
use organza_core::scene::Scene;

/// Renders scenes on a device.
///
/// ```
/// use organza_core::{Tile, TileBatch, demo};
/// use muslin_device::DeviceOptions;
/// use organza_render::{Renderer, open_device};
///
/// // DeviceOptions::default() takes a GPU if there is one
/// let renderer = Renderer::new(open_device(&DeviceOptions::cpu(None))?);
/// // or Scene::load("scene.safetensors"), and scene.load_cameras("cameras.json")
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
    part_bytes: Arc<AtomicU64>,
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

    /// The same renderer, whose batches are cut into parts with tables of about this many bytes; 512 MiB unless set. Where
    /// a part does not fit into the device's memory, later ones are smaller.
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
        self.render_channels(scene, cameras, batch, &[], &mut |_, _| {})
    }

    /// Like [`Renderer::render`], with [channels](Channel) beside the color. Calls `progress` after each part with the
    /// number of tiles that are done, and of all.
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
        let pass = self.pass(scene, cameras);
        let mut parts = pass.cut(batch)?;
        pass.forward_tiles(&mut parts, batch, channels, false, progress)
    }

    /// Renders tiles of one camera into its image, in 8 bits: values are clamped to 0 to 1 and rounded on the device.
    /// `progress` is that of [`Renderer::render_channels`].
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
        let pass = self.pass(scene, cameras);
        let mut parts = pass.cut(batch)?;
        let mut done = 0;
        pass.forward(&mut parts, false, |plan, part| {
            let pixels = device.run_in_pool(|| pixels(device, plan.side, &part.composite.image))?;
            let buffers = vec![pixels, part.bins.degenerate.view()];
            let Some((words, needed)) = part.read(device, buffers)? else { return Ok(None) };
            let tiles: Vec<_> = plan.tiles.iter().map(|planned| planned.tile).collect();
            device.run_in_pool(|| image.paste_words(plan.side, &tiles, &words[0]));
            report.add(&report_of_part(words[1][0], needed));
            done += tiles.len();
            progress(done, batch.tiles.len());
            Ok(Some(needed))
        })?;
        Ok(report)
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

    /// The way through a batch of this renderer alone.
    pub(crate) fn pass<'a>(&'a self, scene: &'a DeviceScene, cameras: &'a [Camera]) -> Pass<'a> {
        Pass { renderer: self, scene, cameras, ranks: None, views: 0 }
    }

    /// The bytes of a part's tables.
    pub(crate) fn part_bytes(&self) -> u64 {
        self.part_bytes.load(Ordering::Relaxed)
    }

    /// Parts are half as large from now on; returns their bytes.
    pub(crate) fn halve_part_bytes(&self) -> u64 {
        let half = self.part_bytes() / 2;
        self.part_bytes.store(half, Ordering::Relaxed);
        half
    }

    /// The capacity that a part needs, judging by others; none on a CPU, which counts first.
    pub(crate) fn predict(&self, scene: &DeviceScene, plan: &PartTiles) -> Option<Capacity> {
        let kind = [scene.gaussians, plan.side];
        let guesses = self.device.leaves_counts_on_device();
        guesses.then(|| self.predictor().predict(kind, plan.tiles.len())).flatten()
    }

    /// Learns from the capacity that a part has needed.
    pub(crate) fn observe(&self, scene: &DeviceScene, plan: &PartTiles, needed: Capacity) {
        if self.device.leaves_counts_on_device() {
            let kind = [scene.gaussians, plan.side];
            self.predictor().observe(kind, plan.tiles.len(), needed);
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

impl Pass<'_> {
    /// Renders tiles and their channels; `progress` is that of [`Renderer::render_channels`].
    pub fn forward_tiles(
        &self,
        parts: &mut Parts,
        batch: &TileBatch,
        channels: &[Channel],
        keep: bool,
        progress: &mut dyn FnMut(usize, usize),
    ) -> Result<RenderedTiles> {
        let device = self.renderer.device();
        let mut tiles = RenderedTiles::new(batch, channels)?;
        let mut done = 0;
        self.forward(parts, keep, |plan, part| {
            let seen = part.seen(self.scene, plan.side);
            let read = |buffers| part.read(device, buffers);
            let read = || ReadTiles::new(seen, &part.composite, channels, read);
            let Some((found, needed)) = device.run_in_pool(read)? else { return Ok(None) };
            place(&mut tiles, plan, found, channels)?;
            done += plan.tiles.len();
            progress(done, batch.tiles.len());
            Ok(Some(needed))
        })?;
        Ok(tiles)
    }
}

/// Puts the tiles of a part in their places; `channels` are those of the part.
///
/// # Errors
/// [`Error::OutOfMemory`](muslin_device::Error::OutOfMemory).
pub fn place(
    tiles: &mut RenderedTiles,
    plan: &PartTiles,
    part: ReadTiles,
    channels: &[Channel],
) -> muslin_device::Result<()> {
    let area = plan.area();
    let count = tiles.count;
    let is_in_order = plan.tiles.iter().enumerate().all(|(place, tile)| tile.place == place);
    // New memory costs more than the copy: a batch of one part takes what was read.
    let is_whole = plan.tiles.len() == count && is_in_order;
    let place = |values: Vec<f32>, planes: usize, batch: &mut Vec<f32>| {
        if is_whole {
            *batch = values;
            return Ok(());
        }
        let len = planes * area;
        if batch.is_empty() {
            *batch = memory::zeros(count * len, "the rendered batch")?;
        }
        for (values, tile) in values.chunks_exact(len).zip(&plan.tiles) {
            batch[tile.place * len..][..len].copy_from_slice(values);
        }
        Ok(())
    };
    place(part.pixels, 3, &mut tiles.data)?;
    for (channel, values) in channels.iter().zip(part.channels) {
        let all = tiles.channels.get_mut(channel).expect("`RenderedTiles::new` has made it");
        place(values, channel.planes(), all)?;
    }
    tiles.report.add(&part.report);
    Ok(())
}
