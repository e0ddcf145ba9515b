//! A fit in a file, for exports to come.

use std::path::Path;

use organza_core::input::read_file;
use organza_core::scene::Scene;
use organza_core::{Result, write_inside};
use organza_render::{DeviceScene, Renderer};

use super::distill::HeldOutViews;
use super::{Distilled, Fit, Splat, Views};

/// Most bytes of the file's first line.
const HEAD: u64 = 1024;

impl Distilled {
    /// Writes the Gaussians to a file. `key` is a word that says what they were made of.
    ///
    /// # Errors
    /// [`Error::WriteFile`](organza_core::Error::WriteFile).
    pub fn keep(&self, path: &Path, key: &str) -> Result<()> {
        write_inside(path, |writer| {
            writeln!(writer, "{key} {}", self.first_psnr)?;
            writer.write_all(bytemuck::cast_slice(&self.splats))
        })
    }

    /// Reads what [`Self::keep`] has written, and measures it again. `None` without a whole file of this key.
    ///
    /// # Errors
    /// Errors of [`Renderer::render`].
    pub fn kept(
        path: &Path,
        key: &str,
        renderer: &Renderer,
        scene: &Scene,
        uploaded: &DeviceScene,
        views: &Views,
        options: Fit,
    ) -> Result<Option<Self>> {
        let Some((splats, first_psnr)) = read(path, key, scene.gaussians.len()) else {
            return Ok(None);
        };
        let held_out = HeldOutViews::new(renderer, scene, uploaded, views, options)?;
        let psnr = held_out.psnr(&splats);
        Ok(Some(Self { splats, psnr, first_psnr, held_out }))
    }
}

/// The Gaussians, at most `max`, and the PSNR before the first step.
fn read(path: &Path, key: &str, max: usize) -> Option<(Vec<Splat>, f64)> {
    let bytes = read_file(path, HEAD + (max * size_of::<Splat>()) as u64, "a fit").ok()?;
    let end = bytes.iter().position(|&byte| byte == b'\n')?;
    let head = std::str::from_utf8(&bytes[..end]).ok()?;
    let first_psnr = head.strip_prefix(key)?.trim().parse().ok()?;
    let values = &bytes[end + 1..];
    let is_whole = values.len().is_multiple_of(size_of::<Splat>());
    let splats: Vec<Splat> = is_whole.then(|| bytemuck::pod_collect_to_vec(values))?;
    let is_finite = bytemuck::cast_slice(&splats).iter().all(|value: &f32| value.is_finite());
    (is_finite && !splats.is_empty()).then_some((splats, first_psnr))
}
