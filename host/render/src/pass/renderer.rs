//! A renderer: a device, and what is known of the parts that fit it.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use super::capacity::CapacityPredictor;
use crate::scene::device_scene::DeviceScene;
use crate::scene::options::UploadOptions;
use crate::stages::cut::{PART_BYTES, PART_SHARES};
use muslin_device::Device;
use organza_core::Result;
use organza_core::scene::Scene;
use parking_lot::{Mutex, MutexGuard};

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
    pub fn new(device: Device) -> Self {
        let part_bytes = device.memory_share(PART_SHARES, PART_BYTES);
        Self {
            device: Arc::new(device),
            part_bytes: Arc::new(part_bytes.into()),
            predictor: Arc::default(),
        }
    }

    /// The same renderer, whose batches are cut into parts with tables of about this many bytes. Unless set, it is 512 MiB, or a
    /// sixteenth of a GPU's memory if that is more. Where a part does not fit into the device's memory, later ones are smaller.
    ///
    /// A part holds at least one tile, so that it may take more; what a part takes beside its tables grows with the
    /// pairs and samples of its tiles.
    #[must_use]
    pub fn with_part_bytes(mut self, bytes: u64) -> Self {
        self.part_bytes = Arc::new(bytes.into());
        self
    }

    /// The device it renders on.
    pub fn device(&self) -> &Device {
        &self.device
    }

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

    /// Makes predictions of the room that batches need smaller, by a factor. For tests.
    #[doc(hidden)]
    pub fn shrink_predictions(&self, factor: f64) {
        self.predictor().shrink(factor);
    }

    /// What earlier parts have needed.
    pub(crate) fn predictor(&self) -> MutexGuard<'_, CapacityPredictor> {
        self.predictor.lock()
    }
}
