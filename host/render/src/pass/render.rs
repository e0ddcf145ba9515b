//! Renders tiles and whole images.

use super::batch::Pass;
use super::blend::blend;
use super::output::Output;
use super::renderer::Renderer;
use crate::scene::device_scene::DeviceScene;
use organza_core::image::{self, Image};
use organza_core::{Camera, Channel, RenderReport, RenderedTiles, Result, TileBatch};

impl Renderer {
    /// Renders a batch of tiles. A batch that does not fit into the device's memory is rendered in parts; a part does
    /// not change the image.
    ///
    /// # Errors
    /// [`Error::Invalid`](organza_core::Error::Invalid) where a tile has no camera or an impossible place,
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
        if let Some(scenes) = scene.grounds() {
            let [count, tiles] = [scenes.len(), batch.tiles.len()];
            let render = &mut |index, one: &_, own: &_, some: &_, all: &_| {
                let progress = &mut |done, _| progress((index * tiles + done) / count, tiles);
                self.render_channels(one, own, some, all, progress).map(Some)
            };
            let blended = blend(&scenes, cameras, batch, channels, render)?;
            progress(tiles, tiles);
            return Ok(blended.expect("nothing cancels it"));
        }
        let pass = self.pass(scene, cameras);
        let mut parts = pass.cut(batch)?;
        let mut tiles = RenderedTiles::new(batch, channels)?;
        let output = &mut Output::Tiles { tiles: &mut tiles, channels };
        let all = batch.tiles.len();
        pass.forward(&mut parts, false, output, &mut |done| progress(done, all))?;
        Ok(tiles)
    }

    /// Renders tiles of one camera into its image, in 8 bits: values are clamped to 0 to 1 and rounded on the device.
    /// `progress` as for [`Renderer::render_channels`].
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
        if scene.is_blended() {
            let tiles = self.render_channels(scene, cameras, batch, &[], progress)?;
            image.paste(batch, &tiles)?;
            return Ok(tiles.report);
        }
        let pass = self.pass(scene, cameras);
        let mut parts = pass.cut(batch)?;
        let mut report = RenderReport::default();
        let output = &mut Output::Image { image, report: &mut report };
        let all = batch.tiles.len();
        pass.forward(&mut parts, false, output, &mut |done| progress(done, all))?;
        Ok(report)
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

    /// What all parts of a batch share. No other ranks take part, and the host waits for results.
    pub(crate) fn pass<'a>(&'a self, scene: &'a DeviceScene, cameras: &'a [Camera]) -> Pass<'a> {
        Pass { renderer: self, scene, cameras, ranks: None, queue_counts: None }
    }
}
