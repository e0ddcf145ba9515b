//! Where the weight of pixels lies: at the surface that they show, behind it, or in front of it.

use serde::Serialize;

use super::pixel_gaussians::{PartSplats, PixelGaussian, depths, surface};
use crate::pass::part::Part;
use crate::{DeviceScene, Renderer};
use organza_core::error::argument;
use organza_core::{Camera, Result, Tile, TileBatch};

/// Weight farther from the median depth than this part of it is not at the surface.
pub const SURFACE: f64 = 0.12;
/// A pixel of less weight shows the background.
pub const OPEN: f64 = 0.98;

/// Where the weight of pixels lies, as means over pixels.
///
/// The surface of a pixel is the median depth of its weights `alpha_i` (Eq. 12): Gaussians with half of the weight are nearer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Leakage {
    /// Pixels that some Gaussian reaches: the means are over these.
    pub pixels: u64,
    /// Gaussians that reach a pixel.
    #[serde(rename = "members")]
    pub gaussians: f64,
    /// Share of a pixel's weight that is more than 12% deeper than its surface, 0 to 1.
    pub behind: f64,
    /// Share of a pixel's weight that is more than 12% nearer than its surface, 0 to 1.
    pub in_front: f64,
    /// Share of the pixels whose weight S is less than 0.98, 0 to 1.
    pub open: f64,
}

impl Leakage {
    /// The leakage of one pixel.
    fn from_gaussians(reaching: &mut [PixelGaussian]) -> Self {
        let Some((surface, sum)) = surface(reaching) else { return Self::default() };
        let share = |is_there: &dyn Fn(f64) -> bool| {
            let there = reaching.iter().filter(|one| is_there(one.depth));
            there.map(|one| one.weight).sum::<f64>() / sum
        };
        Self {
            pixels: 1,
            gaussians: reaching.len() as f64,
            behind: share(&|depth| depth > (1.0 + SURFACE) * surface),
            in_front: share(&|depth| depth < (1.0 - SURFACE) * surface),
            open: f64::from(u8::from(sum < OPEN)),
        }
    }

    /// The mean over the pixels of all parts.
    pub fn mean(parts: &[Self]) -> Self {
        let pixels = parts.iter().map(|part| part.pixels).sum::<u64>();
        let mean = |value: fn(&Self) -> f64| {
            let sum: f64 = parts.iter().map(|part| part.pixels as f64 * value(part)).sum();
            if pixels == 0 { 0.0 } else { sum / pixels as f64 }
        };
        Self {
            pixels,
            gaussians: mean(|part| part.gaussians),
            behind: mean(|part| part.behind),
            in_front: mean(|part| part.in_front),
            open: mean(|part| part.open),
        }
    }
}

impl Renderer {
    /// Measures where the weight of one view's pixels lies. The pixels are evenly spaced, at most `max` of them.
    ///
    /// # Errors
    /// [`Error::Argument`](organza_core::Error::Argument) where `max` is 0; else as [`Renderer::render`].
    pub fn leakage(
        &self,
        scene: &DeviceScene,
        cameras: &[Camera],
        camera: usize,
        max: u32,
    ) -> Result<Leakage> {
        let device = self.device();
        let batch = spaced(cameras, camera, max)?;
        let depths = depths(&device.read(&scene.tensors.gaussians.position)?, &cameras[camera]);
        let mut found = Vec::with_capacity(batch.tiles.len());
        self.pass(scene, cameras).each_part(&batch, |part_tiles| {
            let part = Part::evaluate(scene, cameras, part_tiles, false, None)?;
            let splats = PartSplats::read(device, &part)?;
            found.extend(part_tiles.tiles.iter().enumerate().map(|(tile, part_tile)| {
                let depth = |gaussian: usize| depths[gaussian];
                Leakage::from_gaussians(&mut splats.at(tile, part_tile.tile.origin, depth))
            }));
            Ok(())
        })?;
        Ok(Leakage::mean(&found))
    }
}

/// Evenly spaced pixels of a view, as tiles.
fn spaced(cameras: &[Camera], camera: usize, max: u32) -> Result<TileBatch> {
    let none = TileBatch { side: 1, tiles: vec![Tile { camera, origin: [0, 0] }] };
    none.validate(cameras)?;
    if max == 0 {
        return argument("0 pixels of a view were asked for");
    }
    let size = [cameras[camera].width, cameras[camera].height];
    let count =
        |stride: u32| size.iter().map(|&side| u64::from(side.div_ceil(stride))).product::<u64>();
    let stride = (1..=u32::MAX).find(|&stride| count(stride) <= u64::from(max)).unwrap_or(u32::MAX);
    let along = |side: u32| {
        let last = side - 1;
        (0..side).step_by(stride as usize).map(move |at| (at + stride / 2).min(last) as i32)
    };
    let tiles =
        along(size[1]).flat_map(|y| along(size[0]).map(move |x| Tile { camera, origin: [x, y] }));
    Ok(TileBatch { side: 1, tiles: tiles.collect() })
}

#[cfg(test)]
mod tests {
    use muslin_check::devices;

    use super::*;
    use organza_core::scene::{Scene, SceneConfig};

    #[test]
    fn shares_are_of_the_weight_around_the_median_depth() {
        // the surface is at 2: 1 + 3 of 10 are nearer than half, 5 reaches it
        let reaching = [(9.0, 1.0), (2.2, 2.0), (2.0, 3.0), (1.9, 3.0), (1.0, 1.0)];
        for scale in [1.0, 0.05] {
            let one =
                |(depth, weight)| PixelGaussian { gaussian: 0, depth, weight: weight * scale };
            let mut reaching = reaching.map(one);
            let found = Leakage::from_gaussians(&mut reaching);
            let close = |a: f64, b: f64| assert!((a - b).abs() < 1e-12, "{found:?}");
            close(found.behind, 0.1);
            close(found.in_front, 0.1);
            close(found.gaussians, 5.0);
            close(found.open, if scale < 0.1 { 1.0 } else { 0.0 });
        }
        assert_eq!(Leakage::from_gaussians(&mut []), Leakage::default());
        let parts = [(1, 0.5), (3, 0.1), (0, 0.9)].map(|(pixels, behind)| Leakage {
            pixels,
            behind,
            ..Leakage::default()
        });
        let mean = Leakage::mean(&parts);
        assert!(mean.pixels == 4 && (mean.behind - 0.2).abs() < 1e-12, "{mean:?}");
    }

    /// Gaussians on the axis of a camera with one pixel: weights are opacities where all light passes.
    #[test]
    fn shares_on_an_axis_follow_the_opacities() {
        let config = SceneConfig { antialiased: false, ..organza_core::demo::config() };
        let mut scene = Scene::zeros(config, 3).unwrap();
        let last = scene.transmittance.network.layers.last_mut().unwrap();
        last.bias[0] = 50.0;
        let gaussians = &mut scene.gaussians;
        gaussians.position = vec![[0.0, 0.0, 1.0], [0.0, 0.0, 2.0], [0.0, 0.0, 2.1]];
        gaussians.rotation.fill([1.0, 0.0, 0.0, 0.0]);
        gaussians.log_scale.fill([-2.0; 3]);
        let weights: [f32; 3] = [0.5, 0.8, 0.3];
        gaussians.opacity = weights.map(|weight| (weight / (1.0 - weight)).ln()).to_vec();
        let camera =
            Camera::look_at([0.0; 3], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0], 0.8, [1, 1]).unwrap();
        let renderer = Renderer::new(devices::cpu(Some(1)));
        let scene = renderer.upload(&scene).unwrap();
        let found = renderer.leakage(&scene, &[camera], 0, 16).unwrap();
        assert_eq!((found.pixels, found.gaussians, found.open, found.behind), (1, 3.0, 0.0, 0.0));
        assert!((found.in_front - 0.5 / 1.6).abs() < 1e-5, "{found:?}");
    }

    #[test]
    fn pixels_are_spaced_over_the_image() {
        let up = [0.0, 1.0, 0.0];
        let camera = Camera::look_at([0.0; 3], [0.0, 0.0, 1.0], up, 0.8, [100, 37]).unwrap();
        let tiles = spaced(&[camera], 0, 50).unwrap().tiles;
        assert!((30..=50).contains(&tiles.len()), "{}", tiles.len());
        let far = tiles.iter().fold([0, 0], |far, tile| [0, 1].map(|i| far[i].max(tile.origin[i])));
        assert!(far[0] > 90 && far[0] < 100 && far[1] > 30 && far[1] < 37, "{far:?}");
        assert!(spaced(&[], 0, 50).is_err());
    }
}
