//! Coarse to fine. For most of a run, steps see photographs at half their size, and T has longer steps. A tile then
//! shows four times the area, so large structures converge before small ones. 3D Gaussian Splatting (Kerbl et al. 2023)
//! begins with smaller images, too.

use std::borrow::Cow;

use super::config::RunConfig;
use super::sampler::Sampler;
use organza_core::{Camera, Error, Result, TileBatch};
use organza_data::Frame;
use organza_render::{DeviceScene, Roulette};

/// Factor by which photographs are smaller in coarse steps.
const FACTOR: u32 = 2;
/// Length of T's steps in coarse steps, as a multiple of sigma.
const RAY_STEPS: u32 = 2;

/// Draws the tiles of a run.
#[derive(Debug)]
pub struct Batches {
    whole: Sampler,
    /// Draws tiles of smaller photographs. `None` if a smaller photograph is less than a tile wide or high, or if no pixel of
    /// any is valid.
    smaller: Option<Sampler>,
}

/// The tiles of a step.
#[derive(Debug)]
pub struct Drawn {
    /// Tiles, in pixels of images that are `factor` times smaller than the photographs.
    pub batch: TileBatch,
    /// Factor by which the images are smaller than the photographs, 1 or more.
    pub factor: u32,
    /// Length of T's steps, as a multiple of sigma.
    pub ray_steps: u32,
    /// See [`DeviceScene::with_roulette`].
    pub roulette: Roulette,
}

impl Batches {
    /// Batches for photographs.
    ///
    /// # Errors
    /// [`Error::Argument`] if no pixel of them is valid; the other errors of [`Sampler::new`].
    pub fn new(frames: &[&Frame], run: &RunConfig) -> Result<Self> {
        let Some(whole) = Sampler::new(frames, 1, run)? else {
            let reason = "no pixel of the photographs to train on is valid".to_owned();
            return Err(Error::Argument { reason });
        };
        let holds_a_tile =
            |frame: &&Frame| frame.camera.width.min(frame.camera.height) / FACTOR >= run.tile_size;
        let smaller = match frames.iter().all(holds_a_tile) {
            true => Sampler::new(frames, FACTOR, run)?,
            false => None,
        };
        Ok(Self { whole, smaller })
    }

    /// Draws the tiles of a step from the photographs of [`Self::new`].
    pub fn draw(&mut self, run: &RunConfig, step: u32, frames: &[&Frame]) -> Drawn {
        let roulette = Roulette {
            samples: run.roulette as f32,
            // the loss is a mean over pixels
            gradients: (run.gradient_roulette / run.pixels_per_step()) as f32,
        };
        if run.fraction(step) >= run.coarse {
            return Drawn { roulette, ..self.whole(step, frames) };
        }
        let ray_steps = RAY_STEPS;
        match &mut self.smaller {
            Some(smaller) => {
                Drawn { batch: smaller.batch(step, frames), factor: FACTOR, ray_steps, roulette }
            }
            None => Drawn { ray_steps, roulette, ..self.whole(step, frames) },
        }
    }

    /// Draws the tiles of a step that is as exact as an image.
    pub fn whole(&mut self, step: u32, frames: &[&Frame]) -> Drawn {
        Drawn {
            batch: self.whole.batch(step, frames),
            factor: 1,
            ray_steps: 1,
            roulette: Roulette::default(),
        }
    }
}

impl Drawn {
    /// The scene as the step shows it.
    #[must_use]
    pub fn scene(&self, scene: &DeviceScene) -> DeviceScene {
        scene.coarser(self.factor, self.ray_steps).with_roulette(self.roulette)
    }

    /// The cameras of the images that the tiles belong to, given the photographs' cameras.
    #[must_use]
    pub fn cameras<'c>(&self, cameras: &'c [Camera]) -> Cow<'c, [Camera]> {
        match self.factor {
            1 => cameras.into(),
            factor => cameras.iter().map(|camera| camera.smaller(factor)).collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use organza_core::demo;
    use organza_data::Photograph;

    #[test]
    fn coarse_steps_see_half_the_size_and_have_longer_steps_of_t() {
        let cameras = demo::turntable(3, 40);
        let frame = |camera: &Camera| {
            let image = Photograph::new([40; 2], vec![[0; 3]; 1600], None).unwrap();
            Frame { name: String::new(), camera: camera.clone(), image }
        };
        let frames: Vec<_> = cameras.iter().map(frame).collect();
        let frames: Vec<_> = frames.iter().collect();
        let mut run = RunConfig { steps: 20, tile_size: 16, coarse: 0.3, ..RunConfig::default() };
        let mut batches = Batches::new(&frames, &run).unwrap();
        for step in 0..20 {
            let drawn = batches.draw(&run, step, &frames);
            let expected = if step < 6 { [2; 2] } else { [1; 2] };
            assert_eq!([drawn.factor, drawn.ray_steps], expected, "{step}");
            assert_eq!(drawn.roulette.samples, 0.25);
            assert_eq!(batches.whole(step, &frames).roulette, Roulette::default());
            let seen = drawn.cameras(&cameras);
            let side = 40 / drawn.factor;
            assert!(seen.iter().all(|camera| [camera.width, camera.height] == [side; 2]));
        }
        // half of a photograph is less than a tile wide
        run.tile_size = 21;
        let drawn = Batches::new(&frames, &run).unwrap().draw(&run, 0, &frames);
        assert_eq!([drawn.factor, drawn.ray_steps], [1, 2]);
        run.coarse = 0.0;
        let drawn = batches.draw(&run, 0, &frames);
        assert_eq!([drawn.factor, drawn.ray_steps], [1; 2]);
    }
}
