//! The start of a fit: what the scene's networks and its images say of each Gaussian.

use std::ops::AddAssign;

use glam::Vec3;
use muslin::math::sigmoid;
use organza_shaders::splat::Compensation;
use rayon::prelude::*;

use super::Splat;
use super::harmonics::{HARMONICS, Sample, fit, harmonics};
use super::sorted::{Placed, SortedView};
use organza_core::scene::{Scene, logit};
use organza_core::{Camera, Result};
use organza_render::{DeviceScene, Renderer};

/// Most pairs of a camera and a Gaussian that are looked at.
const MAX_PAIRS: usize = 8_000_000;
/// Fewest and most cameras.
const CAMERAS: [usize; 2] = [8, 64];
/// Least weight of a color, for a Gaussian that no image shows: a part of a pixel.
const MIN_WEIGHT: f32 = 0.002;
/// Smallest and largest opacity at the start: at 0 and 1, no gradient would change them.
const OPACITIES: [f32; 2] = [0.002, 0.98];

/// What images say of a Gaussian: sums over their pixels.
#[derive(Clone, Copy, Debug, Default)]
struct Seen {
    /// Its parts `w` of the pixels, `alpha / max(S, 1)` (Eq. 12 and 13).
    part: f32,
    /// `l f w`, with its falloff f and the light l that nearer parts leave.
    product: f32,
    /// `(l f)^2`
    square: f32,
}

impl AddAssign for Seen {
    fn add_assign(&mut self, other: Self) {
        self.part += other.part;
        self.product += other.product;
        self.square += other.square;
    }
}

impl Seen {
    /// The opacity with which a viewer that sorts shows the same parts. It shows `o l f`, so least squares find o.
    fn opacity(&self) -> f32 {
        let opacity = if self.square > 0.0 { self.product / self.square } else { 0.0 };
        opacity.clamp(OPACITIES[0], OPACITIES[1])
    }
}

/// The Gaussians before the first step. Harmonics are fitted to the networks' colors for the cameras, by the Gaussians' parts of
/// their images.
pub(super) fn first(
    renderer: &Renderer,
    scene: &Scene,
    uploaded: &DeviceScene,
    cameras: &[Camera],
    side: u32,
) -> Result<Vec<Splat>> {
    let gaussians = &scene.gaussians;
    let all = 0..gaussians.len();
    let max = (MAX_PAIRS / all.len().max(1)).clamp(CAMERAS[0], CAMERAS[1]);
    let every = cameras.len().div_ceil(max).max(1);
    let splat = |gaussian: usize, opacity: f32, color| Splat {
        position: gaussians.position[gaussian],
        rotation: gaussians.rotation[gaussian],
        log_scale: gaussians.log_scale[gaussian],
        opacity: logit(opacity),
        color,
    };
    let blur = if scene.config.antialiased { scene.config.blur as f32 } else { 0.0 };
    let look = |camera: &Camera| {
        let (colors, transmittance) = renderer.shades(uploaded, camera)?;
        let shown = |gaussian: usize| {
            let opacity = sigmoid(gaussians.opacity[gaussian]) * transmittance[gaussian];
            splat(gaussian, opacity, [[0.0; 3]; HARMONICS])
        };
        let shown: Vec<_> = all.clone().into_par_iter().map(shown).collect();
        let eye = Vec3::from(camera.eye().map(|x| x as f32));
        Ok((eye, colors, seen(&shown, &camera.within(side), blur)))
    };
    let looks = cameras.iter().step_by(every).map(look).collect::<Result<Vec<_>>>()?;
    let fitted = |gaussian: usize| {
        let mut sum = Seen::default();
        let sample = |(eye, colors, seen): &(Vec3, Vec<[f32; 3]>, Vec<Seen>)| {
            sum += seen[gaussian];
            let basis = harmonics(*eye, gaussians.position[gaussian]);
            Sample { basis, color: colors[gaussian], weight: seen[gaussian].part + MIN_WEIGHT }
        };
        let samples: Vec<_> = looks.iter().map(sample).collect();
        splat(gaussian, sum.opacity(), fit(&samples))
    };
    Ok(all.into_par_iter().map(fitted).collect())
}

/// What an image says of Gaussians whose opacities are `opacity_i T_i`. `blur` is what their weights make up for, or 0.
fn seen(splats: &[Splat], camera: &Camera, blur: f32) -> Vec<Seen> {
    let view = SortedView::new(splats, camera, false);
    view.sums(|placed, pixels, sums: &mut [Seen]| {
        let factor = |placed: &Placed| Compensation::new(placed.conic, blur).factor;
        let factors: Vec<_> = placed.iter().map(factor).collect();
        let mut reaching = Vec::new();
        for (x, y, _) in pixels {
            let alphas = placed.iter().enumerate();
            let alphas = alphas.filter_map(|(at, placed)| Some((at, placed.alpha(x, y)?.0)));
            reaching.clear();
            reaching.extend(alphas);
            let sum: f32 = reaching.iter().map(|(at, alpha)| factors[*at] * alpha).sum();
            let mut light = 1.0;
            for &(at, alpha) in &reaching {
                let part = factors[at] * alpha / sum.max(1.0);
                let shown = light * alpha / placed[at].opacity;
                sums[at] += Seen { part, product: shown * part, square: shown * shown };
                light = f32::max(light - part, 0.0);
            }
        }
    })
}

#[cfg(test)]
mod tests {
    use super::super::sorted::tests::{ball, camera};
    use super::*;

    /// Parts of 0.5 and 0.3 of each pixel are opacities of 0.5 and 0.6: half of the light reaches the second.
    #[test]
    fn opacities_show_the_same_parts() {
        let mut front = ball();
        front.log_scale = [4.0; 3];
        front.opacity = logit(0.5);
        let mut back = front;
        back.position = [0.0, 5.0, -0.375];
        back.opacity = logit(0.3);
        let camera = camera();
        let found = seen(&[back, front], &camera, 0.0);
        let pixels = (camera.width * camera.height) as f32;
        for (seen, part, opacity) in [(found[0], 0.3, 0.6), (found[1], 0.5, 0.5)] {
            assert!((seen.part / pixels - part).abs() < 0.01, "{seen:?}");
            assert!((seen.opacity() - opacity).abs() < 0.01, "{seen:?}");
        }
        // more than a pixel is divided: two thirds, and then all that is left
        front.opacity = logit(0.9999);
        back.opacity = logit(0.5);
        let found = seen(&[back, front], &camera, 0.0);
        assert!((found[1].opacity() - 0.667).abs() < 0.01, "{:?}", found[1]);
        assert!((found[0].opacity() - OPACITIES[1]).abs() < 0.02, "{:?}", found[0]);
    }
}
