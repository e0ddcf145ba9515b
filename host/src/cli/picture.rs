//! One view as an image.

use std::path::{Path, PathBuf};

use organza::{Camera, DeviceScene, Image, Renderer, Result, image};
use serde::Serialize;

use super::console::{Console, Progress};
use super::summary::{Summary, grouped};

/// What views are rendered from, and how.
#[derive(Debug)]
pub struct Pictures<'a> {
    pub renderer: &'a Renderer,
    pub scene: &'a DeviceScene,
    pub cameras: &'a [Camera],
    pub tile_size: u32,
}

impl Pictures<'_> {
    /// Tiles of some views, for a progress bar.
    pub fn tiles(&self, views: &[usize]) -> u64 {
        let across = |pixels: u32| u64::from(pixels.div_ceil(self.tile_size));
        let tiles = |&view: &usize| {
            let camera = &self.cameras[view];
            across(camera.width) * across(camera.height)
        };
        views.iter().map(tiles).sum()
    }

    pub fn render(&self, view: usize, summary: &mut Summary, progress: &Progress) -> Result<Image> {
        let Camera { width, height, .. } = self.cameras[view];
        let mut picture = Image::new(width, height)?;
        for batch in image::bands(view, [width, height], self.tile_size) {
            let batch = batch?;
            let (renderer, cameras) = (self.renderer, self.cameras);
            let advance = &mut progress.part();
            let tiles = renderer.render_with_progress(self.scene, cameras, &batch, advance)?;
            summary.add(&tiles.report);
            picture.paste(&batch, &tiles)?;
        }
        Ok(picture)
    }
}

/// An image that was written, as `--json` prints it.
#[derive(Clone, Debug, Serialize)]
pub struct Picture {
    view: usize,
    file: PathBuf,
    width: u32,
    height: u32,
}

impl Picture {
    pub fn new(view: usize, file: &Path, camera: &Camera) -> Self {
        Self { view, file: file.to_owned(), width: camera.width, height: camera.height }
    }
}

/// Says so where pixels are no numbers: black is not what they were rendered as.
pub fn warn_not_finite(console: Console, pixels: u64) {
    if pixels > 0 {
        let pixels = grouped(pixels);
        console.warn(&format!("NaN or infinite pixels: {pixels}; check the networks' weights"));
    }
}

/// `96 x 80`, or that sizes differ.
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
