//! Distills a scene into Gaussians for viewers that sort. Colors and opacities first come from the scene's networks and from what
//! its images show of each Gaussian, and are then fitted to these images.

use std::ops::RangeInclusive;

use bytemuck::Zeroable;
use muslin::math::sigmoid;
use organza_core::error::argument;
use organza_core::memory;
use organza_data::random;
use rand::seq::SliceRandom;
use rayon::prelude::*;

use super::first::first;
use super::harmonics::HARMONICS;
use super::placed::turn;
use super::sorted::render;
use super::sorted_backward::gradient;
use super::views::between;
use super::{Splat, VALUES, Views};
use organza_core::scene::Scene;
use organza_core::{Camera, Image, Result, metrics};
use organza_render::{DeviceScene, Renderer};

const SHUFFLE: u64 = 7;

/// Least number of compared views. If there are fewer cameras, cameras between them are added: otherwise, harmonics
/// and opacities would only fit a few views.
const VIEWS: usize = 160;
/// Largest absolute value of an opacity's logit.
const LARGEST_LOGIT: f32 = 9.0;
/// Adam's rates at the first step. A position's is relative to the Gaussian's own size.
const POSITION: f32 = 0.04;
const ROTATION: f32 = 8e-3;
const LOG_SCALE: f32 = 0.016;
const OPACITY: f32 = 0.1;
const FIRST_COLOR: f32 = 0.03;
const OTHER_COLORS: f32 = 0.006;
/// Factor of the rates at the last step.
const LAST: f32 = 0.05;
/// Adam's decays and epsilon.
const DECAY: [f32; 2] = [0.9, 0.99];
const EPSILON: f32 = 1e-12;
/// PSNR of equal images, in dB: they have 8 bits.
const BEST_PSNR: f64 = 60.0;

/// Settings of the fit.
#[derive(Clone, Copy, Debug)]
pub struct Fit {
    /// Number of steps. Each compares one view.
    pub steps: u32,
    /// Longest side of a view, in pixels.
    pub side: u32,
}

impl Fit {
    /// Allowed numbers of steps.
    pub const STEPS: RangeInclusive<i64> = 0..=1_000_000;
    /// Allowed sides of views, in pixels.
    pub const SIDES: RangeInclusive<i64> = 16..=4096;
}

/// 300 steps, with views of 480 pixels.
impl Default for Fit {
    fn default() -> Self {
        Self { steps: 300, side: 480 }
    }
}

/// A distilled scene.
#[derive(Clone, Debug)]
pub struct Distilled {
    /// The Gaussians for a viewer. Those with an opacity below 1/255 are left out.
    pub splats: Vec<Splat>,
    /// Mean PSNR, in dB, of their images compared with the scene's own, over views that were not fitted.
    pub psnr: f64,
    /// The same PSNR before the first step.
    pub first_psnr: f64,
    pub(super) held_out: HeldOutViews,
}

/// Views in which Gaussians are measured.
#[derive(Clone, Debug)]
pub(super) struct HeldOutViews {
    targets: Vec<(Camera, Image)>,
    background: [f32; 3],
}

impl HeldOutViews {
    pub fn new(
        renderer: &Renderer,
        scene: &Scene,
        uploaded: &DeviceScene,
        views: &Views,
        options: Fit,
    ) -> Result<Self> {
        let cameras = if views.held_out.is_empty() { &views.fitted } else { &views.held_out };
        let targets = targets(renderer, uploaded, cameras, options.side)?;
        Ok(Self { targets, background: background(scene) })
    }

    /// The mean PSNR of Gaussians' images, compared with the scene's own.
    pub fn psnr(&self, splats: &[Splat]) -> f64 {
        let of = |(camera, image): &(Camera, Image)| {
            let psnr = psnr(splats, camera, self.background, image.pixels(), None);
            psnr.unwrap_or(BEST_PSNR).min(BEST_PSNR)
        };
        self.targets.iter().map(of).sum::<f64>() / self.targets.len() as f64
    }
}

impl Distilled {
    /// The PSNR of other Gaussians in the views of [`Self::psnr`], such as Gaussians that a file has rounded.
    pub fn psnr_of(&self, splats: &[Splat]) -> f64 {
        self.held_out.psnr(splats)
    }
}

/// Cameras with images of at most this side, and the scene's images.
fn targets<'a>(
    renderer: &Renderer,
    uploaded: &DeviceScene,
    cameras: impl IntoIterator<Item = &'a Camera>,
    side: u32,
) -> Result<Vec<(Camera, Image)>> {
    let cameras = cameras.into_iter().map(|camera| camera.within(side));
    cameras.map(|camera| Ok((camera.clone(), renderer.render_view(uploaded, &camera)?))).collect()
}

fn background(scene: &Scene) -> [f32; 3] {
    scene.config.background.map(|x| x as f32)
}

/// Fits Gaussians to a scene, as some cameras and others between them see it. Without views that are only measured,
/// the fitted views are measured. Scenes that are [shown with](DeviceScene::put) the first one add their Gaussians. `progress` is called with the number of finished steps. An error of it ends the
/// fit.
///
/// # Errors
/// [`Error::Argument`](organza_core::Error::Argument) without cameras; errors of [`Renderer::render`] and of `progress`.
pub fn distill(
    renderer: &Renderer,
    scene: &Scene,
    uploaded: &DeviceScene,
    views: &Views,
    options: Fit,
    progress: &mut dyn FnMut(usize) -> Result<()>,
) -> Result<Distilled> {
    let cameras = &views.fitted;
    if cameras.is_empty() {
        return argument("distilling a scene needs a camera");
    }
    let background = background(scene);
    let mut splats = first(renderer, scene, uploaded, cameras, options.side)?;
    for other in uploaded.all().skip(1) {
        let place = *other.place();
        let own: Vec<_> = cameras.iter().map(|camera| place.own_camera(camera)).collect();
        let scene = other.download(renderer.device())?;
        let mut found = first(renderer, &scene, other, &own, options.side)?;
        turn(&mut found, place.rotation(), place.scale, |at| place.world(at));
        splats.extend(found);
    }
    let held_out = HeldOutViews::new(renderer, scene, uploaded, views, options)?;
    let first_psnr = held_out.psnr(&splats);
    let steps = options.steps as usize;
    // views that no step will see need no image
    let others = between(cameras, VIEWS.min(steps).saturating_sub(cameras.len()))?;
    let fitted: Vec<_> = cameras.iter().chain(&others).take(steps).collect();
    let pixels = |camera: &&Camera| {
        let Camera { width, height, .. } = camera.within(options.side);
        u64::from(width) * u64::from(height)
    };
    memory::check(3 * fitted.iter().map(pixels).sum::<u64>(), "the images to compare")?;
    let mut targets = targets(renderer, uploaded, fitted, options.side)?;
    // so that successive steps do not compare neighbors
    targets.shuffle(&mut random(0, SHUFFLE, 0));
    let mut adam = Adam::new(splats.len())?;
    for step in 0..steps {
        let (camera, image) = &targets[step % targets.len()];
        let gradient = gradient(&splats, camera, background, &colors(image.pixels()));
        let rate = LAST.powf(step as f32 / options.steps as f32);
        adam.step(&mut splats, &gradient, rate);
        progress(step + 1)?;
    }
    splats.retain(|splat| sigmoid(splat.opacity) >= 1.0 / 255.0);
    let psnr = held_out.psnr(&splats);
    Ok(Distilled { splats, psnr, first_psnr, held_out })
}

/// PSNR of the image that a viewer shows, compared with an 8-bit image, over its valid pixels. See [`metrics::psnr`].
pub fn psnr(
    splats: &[Splat],
    camera: &Camera,
    background: [f32; 3],
    pixels: &[[u8; 3]],
    valid: Option<&[bool]>,
) -> Option<f64> {
    metrics::psnr(&displayed(render(splats, camera, background, false)), &colors(pixels), valid)
}

fn colors(pixels: &[[u8; 3]]) -> Vec<[f32; 3]> {
    pixels.iter().map(|pixel| pixel.map(|x| f32::from(x) / 255.0)).collect()
}

/// Clamps colors to the range of a screen.
fn displayed(mut image: Vec<[f32; 3]>) -> Vec<[f32; 3]> {
    image.as_flattened_mut().iter_mut().for_each(|value| *value = value.clamp(0.0, 1.0));
    image
}

/// Adam (Kingma and Ba 2015). A Gaussian takes a step if the view shows it.
struct Adam {
    moments: Vec<Moments>,
}

#[derive(Clone, Copy, Zeroable)]
struct Moments {
    first: [f32; VALUES],
    second: [f32; VALUES],
    steps: i32,
    /// Index of the Gaussian's gradient in this step, plus 1.
    slope: u32,
}

impl Adam {
    fn new(len: usize) -> Result<Self> {
        Ok(Self { moments: memory::zeros(len, "distilling the Gaussians")? })
    }

    fn step(&mut self, splats: &mut [Splat], gradient: &[(u32, Splat)], rate: f32) {
        for (index, (gaussian, _)) in gradient.iter().enumerate() {
            self.moments[*gaussian as usize].slope = index as u32 + 1;
        }
        splats.par_iter_mut().zip(&mut self.moments).for_each(|(splat, moments)| {
            let slope = std::mem::take(&mut moments.slope);
            if slope > 0 {
                moments.step(splat, &gradient[slope as usize - 1].1, rate);
            }
        });
    }
}

impl Moments {
    fn step(&mut self, splat: &mut Splat, slope: &Splat, rate: f32) {
        let slope: &[f32; VALUES] = bytemuck::cast_ref(slope);
        if !slope.iter().all(|value| value.is_finite()) {
            return;
        }
        self.steps += 1;
        let corrections = DECAY.map(|decay| 1.0 - decay.powi(self.steps));
        let rates = rates(splat);
        let rates: &[f32; VALUES] = bytemuck::cast_ref(&rates);
        let values: &mut [f32; VALUES] = bytemuck::cast_mut(splat);
        for at in 0..VALUES {
            let g = slope[at];
            self.first[at] += (1.0 - DECAY[0]) * (g - self.first[at]);
            self.second[at] += (1.0 - DECAY[1]) * (g * g - self.second[at]);
            let size = (self.second[at] / corrections[1]).sqrt() + EPSILON;
            values[at] -= rate * rates[at] * (self.first[at] / corrections[0]) / size;
        }
        splat.opacity = splat.opacity.clamp(-LARGEST_LOGIT, LARGEST_LOGIT);
    }
}

/// The learning rate of each value.
fn rates(splat: &Splat) -> Splat {
    let size = (splat.log_scale.iter().sum::<f32>() / 3.0).exp();
    let length = splat.rotation.iter().map(|x| x * x).sum::<f32>().sqrt();
    let mut color = [[OTHER_COLORS; 3]; HARMONICS];
    color[0] = [FIRST_COLOR; 3];
    Splat {
        position: [POSITION * size; 3],
        rotation: [ROTATION * length; 4],
        log_scale: [LOG_SCALE; 3],
        opacity: OPACITY,
        color,
    }
}
