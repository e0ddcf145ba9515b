//! Renders one view as an image.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use organza::image::{self, ChannelImage, TILE_SIDE};
use organza::{Camera, Channel, DeviceScene, Image, Renderer, Result};
use serde::Serialize;

use super::console::{Console, Progress};
use super::summary::{Summary, grouped};
use super::{refuse, text_of};

/// Everything that views are rendered from.
#[derive(Debug)]
pub struct Pictures<'a> {
    pub renderer: &'a Renderer,
    pub scene: &'a DeviceScene,
    pub cameras: &'a [Camera],
    /// Asks to stop within an image, which is then an error.
    pub stop: Option<&'a AtomicBool>,
}

impl Pictures<'_> {
    /// Number of tiles in some views, for a progress bar.
    pub fn tiles(&self, views: &[usize]) -> usize {
        let across = |pixels: u32| pixels.div_ceil(TILE_SIDE) as usize;
        let tiles = |&view: &usize| {
            let camera = &self.cameras[view];
            across(camera.width) * across(camera.height)
        };
        views.iter().map(tiles).sum()
    }

    /// Renders a view, and channels besides its color.
    pub fn render_channels(
        &self,
        view: usize,
        channels: &[Channel],
        summary: &mut Summary,
        progress: &Progress,
    ) -> Result<(Image, Vec<ChannelImage>)> {
        let Camera { width, height, .. } = self.cameras[view];
        let mut picture = Image::new(width, height)?;
        let beside = channels.iter().map(|&channel| ChannelImage::new(channel, width, height));
        let mut beside = beside.collect::<Result<Vec<_>>>()?;
        for batch in image::bands(view, [width, height], TILE_SIDE) {
            let batch = batch?;
            if self.stop.is_some_and(|stop| stop.load(Ordering::Relaxed)) {
                return refuse("stopped by a signal");
            }
            let renderer = self.renderer;
            let cameras = self.cameras;
            let advance = &mut progress.part();
            if channels.is_empty() {
                summary.add(&renderer.paint(&mut picture, self.scene, cameras, &batch, advance)?);
                continue;
            }
            let tiles = renderer.render_channels(self.scene, cameras, &batch, channels, advance)?;
            summary.add(&tiles.report);
            picture.paste(&batch, &tiles)?;
            beside.iter_mut().try_for_each(|image| image.paste(&batch, &tiles))?;
        }
        Ok((picture, beside))
    }
}

/// A written image, as `--json` prints it.
#[derive(Clone, Debug, Serialize)]
pub struct Picture {
    view: usize,
    file: String,
    width: u32,
    height: u32,
    /// Files of the channels, by the channels' names.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    channels: BTreeMap<&'static str, String>,
}

impl Picture {
    pub fn new(view: usize, file: &Path, camera: &Camera) -> Self {
        let width = camera.width;
        Self { view, file: text_of(file), width, height: camera.height, channels: BTreeMap::new() }
    }

    pub fn with_channels(mut self, channels: &[Channel], files: &[PathBuf]) -> Self {
        let names = channels.iter().map(|channel| channel.name());
        self.channels = names.zip(files.iter().map(|file| text_of(file))).collect();
        self
    }
}

/// Warns of pixels that are not finite: they were rendered as black.
pub fn warn_not_finite(console: Console, pixels: u64) {
    if pixels > 0 {
        let pixels = grouped(pixels);
        console.warn(&format!("NaN or infinite pixels: {pixels}; check the networks' weights"));
    }
}

/// The size of the views, such as `96 x 80`, or a note that sizes differ.
pub fn sizes(cameras: &[Camera], views: &[usize]) -> String {
    let size = |view: &usize| (cameras[*view].width, cameras[*view].height);
    match views.split_first() {
        Some((first, rest)) if rest.iter().all(|view| size(view) == size(first)) => {
            let (width, height) = size(first);
            format!("{width} x {height}")
        }
        _ => "various sizes".to_owned(),
    }
}
