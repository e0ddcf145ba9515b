//! Turns Gaussians of other programs into a scene: renders them as a sorting viewer does, and trains on these images.

use std::ops::RangeInclusive;

use super::config::{Rate, TrainConfig};
use super::start::from_splats;
use crate::{Checkpoint, Trainer};
use organza_core::image::to_8_bit;
use organza_core::scene::{Placement, Scene};
use organza_core::{Camera, Result};
use organza_data::{Dataset, Frame, Photograph};
use organza_render::Renderer;
use organza_splats::{SplatFile, Views, render};

/// Smallest share of the pixels that a scene must cover. With less, the cameras are too far away, or look elsewhere.
const COVERED: f64 = 0.05;

/// Settings for turning Gaussians into a scene.
#[derive(Clone, Copy, Debug)]
pub struct Import {
    /// Number of training steps.
    pub steps: u32,
    /// Longest side of an image to train on, in pixels.
    pub side: u32,
    /// Background color, 0 to 1. Files have none.
    pub background: [f32; 3],
}

impl Import {
    /// Allowed numbers of steps.
    pub const STEPS: RangeInclusive<i64> = 1..=10_000_000;
}

/// 1500 steps, on images whose longer side has 480 pixels, with a black background.
impl Default for Import {
    fn default() -> Self {
        Self { steps: 1500, side: 480, background: [0.0; 3] }
    }
}

/// A scene made from Gaussians.
#[derive(Clone, Debug)]
pub struct Imported {
    /// The scene.
    pub scene: Scene,
    /// Mean PSNR, in dB, of its images against the file's, over views that training has not seen. `None` without such
    /// views.
    pub psnr: Option<f64>,
    /// What may be wrong with the file or the views, for the user to read.
    pub notes: Vec<String>,
}

/// Makes a scene with the same images as the Gaussians of a file. Training adapts the networks, and moves all values of the
/// Gaussians a little. `progress` is called with the number of finished steps. Its error ends the training.
///
/// # Errors
/// The same errors as [`Trainer::start`]; [`Error::Invalid`](organza_core::Error::Invalid) if no camera sees a Gaussian; any error
/// of `progress`.
pub fn import(
    renderer: &Renderer,
    file: SplatFile,
    views: &Views,
    options: Import,
    progress: &mut dyn FnMut(usize) -> Result<()>,
) -> Result<Imported> {
    let Views { fitted: cameras, held_out } = views;
    let path = file.path.display();
    let mut notes: Vec<_> = file.notes.iter().map(|note| format!("{path}: {note}")).collect();
    let all: Vec<_> = cameras.iter().chain(held_out).cloned().collect();
    let placement = Placement::of(&all, &[]);
    let own: Vec<_> = all.iter().map(|camera| placement.own_camera(camera)).collect();
    let is_antialiased = file.is_antialiased;
    let splats = file.into_seen(&placement, &own)?;
    let frame = |(index, camera): (usize, &Camera)| {
        let camera = camera.within(options.side);
        let own = placement.own_camera(&camera);
        let colors = render(&splats, &own, options.background, is_antialiased);
        let pixels = colors.into_iter().map(|color| color.map(to_8_bit)).collect();
        let image = Photograph::new([camera.width, camera.height], pixels, None)?;
        Ok(Frame { name: format!("view-{index:03}"), camera, image })
    };
    let frames =
        cameras.iter().chain(held_out).enumerate().map(frame).collect::<Result<Vec<_>>>()?;
    let background = options.background.map(to_8_bit);
    let pixels = frames.iter().flat_map(|frame| frame.image.pixels());
    let covered = pixels.clone().filter(|&&pixel| pixel != background).count() as f64;
    let covered = covered / pixels.count() as f64;
    if covered < COVERED {
        notes.push(format!(
            "the Gaussians are in {:.1}% of the pixels, so the scene is hardly trained, and its PSNR means little: name \
             cameras that see them",
            100.0 * covered
        ));
    }
    let mut dataset = Dataset::from_frames(frames, 0).placed(placement);
    dataset.held_out = dataset.train.split_off(cameras.len());
    dataset.background = options.background.map(f64::from);
    let mut config = config(splats.len(), options.steps);
    config.scene.antialiased = is_antialiased;
    let fitted: Vec<_> = dataset.train_frames().map(|frame| frame.camera.clone()).collect();
    let mut scene = from_splats(&splats, &config, dataset.background, &fitted)?;
    scene.config.placement = placement;
    let begin = Checkpoint::begin(scene, &config)?;
    let mut trainer = Trainer::resume(renderer, config, dataset, &begin)?;
    while !trainer.is_finished() {
        trainer.step()?;
        progress(trainer.steps() as usize)?;
    }
    let psnr = trainer.evaluate()?.mean.psnr;
    Ok(Imported { scene: trainer.scene().download(renderer.device())?, psnr, notes })
}

/// The settings of training: the number of Gaussians is constant, and their positions and shapes change slowly.
fn config(gaussians: usize, steps: u32) -> TrainConfig {
    let mut config = TrainConfig::default();
    config.run.steps = steps;
    config.densification.end = 0.0;
    config.densification.max_gaussians = gaussians as u32;
    config.start.gaussians = gaussians as u32;
    config.optimizer.position = Rate { first: 1e-4, last: 1e-5 };
    config.optimizer.log_scale = Rate { first: 3e-3, last: 1e-3 };
    config
}
