//! Compares a scene, and its Gaussians for viewers that sort, with photographs.

use super::evaluate;
use organza_core::error::Result;
use organza_data::Frame;
use organza_render::{DeviceScene, Renderer};
use organza_splats::{Splat, psnr};

/// Mean PSNRs compared with photographs, in dB.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SplatComparison {
    /// Number of photographs.
    pub photographs: usize,
    /// PSNR of the scene's own images.
    pub scene: f64,
    /// PSNR of the Gaussians' images, as a viewer that sorts shows them.
    pub splats: f64,
}

/// Compares a scene, and Gaussians that were [distilled from it](organza_splats::distill()), with photographs. `None` without
/// photographs that have a valid pixel.
///
/// # Errors
/// The same errors as [`Renderer::render`].
pub fn compare_splats(
    renderer: &Renderer,
    scene: &DeviceScene,
    splats: &[Splat],
    photographs: &[&Frame],
) -> Result<Option<SplatComparison>> {
    let Some(own) = evaluate(renderer, scene, photographs)?.mean.psnr else { return Ok(None) };
    let background = scene.config().background.map(|x| x as f32);
    let of = |frame: &&Frame| {
        let Frame { camera, image, .. } = frame;
        psnr(splats, camera, background, image.pixels(), image.valid())
    };
    let found: Vec<_> = photographs.iter().filter_map(of).collect();
    let splats = found.iter().sum::<f64>() / found.len() as f64;
    Ok(Some(SplatComparison { photographs: found.len(), scene: own, splats }))
}
