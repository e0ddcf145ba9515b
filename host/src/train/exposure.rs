//! The exposure of each photograph: a gain and an offset for each channel, learned with the scene.

use std::collections::BTreeMap;
use std::path::Path;

use super::config::OptimizerConfig;
use crate::error::{Error, Result};
use crate::render::ExposureGradient;
use crate::scene::Tensor;
use crate::tile::TileBatch;

/// Learned values of a photograph: the logarithm of the gain, and the offset, of red, green and blue.
pub const VALUES: usize = 6;

/// Names in a checkpoint: the values, Adam's moments of them, and the steps.
const NAMES: [&str; 4] =
    ["train.exposure", "adam.first.exposure", "adam.second.exposure", "adam.steps.exposure"];

/// The exposures of all photographs that are trained on, with Adam's state.
///
/// A rendered color x of photograph i is compared as `exp(a) x + b`. Without more, the scene could become darker and all
/// gains larger, and nothing would change. So the means of a and b over all photographs stay 0: on average, a photograph
/// shows the scene's own colors.
///
/// A step moves the photographs that it shows, and each counts its own steps: Adam's moments of a photograph do not decay
/// while others are shown.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Exposures {
    /// `[photographs, 3, 2]`: a and b.
    pub values: Vec<[f32; VALUES]>,
    /// Adam's moments of `values`.
    pub moments: [Vec<[f32; VALUES]>; 2],
    /// `[photographs]`: in how many steps each was shown.
    pub steps: Vec<u32>,
}

impl Exposures {
    /// Those of so many photographs before the first step: none changes a color.
    #[must_use]
    pub fn new(photographs: usize) -> Self {
        let zeros = || vec![[0.0; VALUES]; photographs];
        Self { values: zeros(), moments: [zeros(), zeros()], steps: vec![0; photographs] }
    }

    /// `[K, 3, 2]`: gain and offset of each channel for a batch's tiles.
    pub(super) fn of_tiles(&self, batch: &TileBatch) -> Vec<f32> {
        let of = |camera: usize| {
            let [r, r0, g, g0, b, b0] = self.values[camera];
            [gain(r), r0, gain(g), g0, gain(b), b0]
        };
        batch.tiles.iter().flat_map(|tile| of(tile.camera)).collect()
    }

    /// One step of Adam with the gradients of a batch's tiles, in their order.
    ///
    /// # Errors
    /// [`Error::Diverged`] where a gradient is not finite; nothing has moved then.
    pub(super) fn step(
        &mut self,
        tiles: &[ExposureGradient],
        config: &OptimizerConfig,
        rate: f64,
    ) -> Result<()> {
        let mut sums: BTreeMap<usize, [f64; VALUES]> = BTreeMap::new();
        for tile in tiles {
            let sum = sums.entry(tile.camera).or_default();
            for (channel, [by_gain, by_offset]) in tile.gradient.into_iter().enumerate() {
                // da of exp(a) is exp(a)
                let gain = f64::from(gain(self.values[tile.camera][2 * channel]));
                sum[2 * channel] += by_gain * gain;
                sum[2 * channel + 1] += by_offset;
            }
        }
        if let Some((camera, _)) = sums.iter().find(|(_, sum)| sum.iter().any(|g| !g.is_finite())) {
            let reason =
                format!("the gradient of the exposure of photograph {camera} is not finite");
            return Err(Error::Diverged { reason });
        }
        for (camera, gradient) in sums {
            self.steps[camera] += 1;
            let t = f64::from(self.steps[camera]);
            let corrections = [config.beta1, config.beta2].map(|beta| 1.0 - beta.powf(t));
            let [first, second] = &mut self.moments;
            for (at, g) in gradient.into_iter().enumerate() {
                let mix = |before: f32, now: f64, beta: f64| {
                    (beta * f64::from(before) + (1.0 - beta) * now) as f32
                };
                first[camera][at] = mix(first[camera][at], g, config.beta1);
                second[camera][at] = mix(second[camera][at], g * g, config.beta2);
                let m = f64::from(first[camera][at]) / corrections[0];
                let v = f64::from(second[camera][at]) / corrections[1];
                let moved = rate * m / (v.sqrt() + config.epsilon);
                self.values[camera][at] = (f64::from(self.values[camera][at]) - moved) as f32;
            }
        }
        self.center();
        Ok(())
    }

    /// As a checkpoint has them. Steps are whole numbers, which f32 has up to 2^24.
    pub(super) fn tensors(&self) -> Vec<(&'static str, Tensor)> {
        let count = self.values.len();
        let [first, second] = &self.moments;
        let values = [&self.values, first, second].map(|values| Tensor {
            shape: vec![count, 3, 2],
            data: values.as_flattened().to_vec(),
        });
        let steps = self.steps.iter().map(|&steps| steps as f32).collect();
        let steps = Tensor { shape: vec![count], data: steps };
        NAMES.into_iter().zip(values.into_iter().chain([steps])).collect()
    }

    /// Those of a checkpoint's tensors, if it has any; `origin` is what errors name.
    ///
    /// # Errors
    /// [`Error::Invalid`] where they do not belong together.
    pub(super) fn of_tensors(
        tensors: &mut BTreeMap<String, Tensor>,
        origin: &Path,
    ) -> Result<Option<Self>> {
        let found = NAMES.map(|name| tensors.remove(name).map(|tensor| tensor.data));
        if found.iter().all(Option::is_none) {
            return Ok(None);
        }
        let [values, first, second, steps] = found.map(Option::unwrap_or_default);
        let rows = |values: Vec<f32>| values.as_chunks::<VALUES>().0.to_vec();
        let lengths = [&values, &first, &second].map(Vec::len);
        let is_count =
            |steps: &f32| *steps >= 0.0 && *steps <= 16_777_216.0 && steps.fract() == 0.0;
        if lengths != [VALUES * steps.len(); 3] || !steps.iter().all(is_count) {
            let reason = format!(
                "its tensors `{}` do not belong together: the checkpoint is damaged",
                NAMES.join("`, `")
            );
            return Err(Error::Invalid { origin: origin.to_owned(), reason });
        }
        let steps = steps.into_iter().map(|steps| steps as u32).collect();
        let [values, first, second] = [values, first, second].map(rows);
        Ok(Some(Self { values, moments: [first, second], steps }))
    }

    /// Moves all values by the same, so that their means are 0.
    fn center(&mut self) {
        let count = self.values.len() as f64;
        for at in 0..VALUES {
            let mean = self.values.iter().map(|values| f64::from(values[at])).sum::<f64>() / count;
            for values in &mut self.values {
                values[at] = (f64::from(values[at]) - mean) as f32;
            }
        }
    }
}

/// In f64, whose exponential is the same in every program on one machine.
fn gain(log: f32) -> f32 {
    f64::from(log).exp() as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    fn gradient(camera: usize, value: f64) -> ExposureGradient {
        ExposureGradient { place: 0, camera, gradient: [[value, -value]; 3] }
    }

    #[test]
    fn adam_moves_by_its_rate_and_the_mean_stays() {
        let mut exposures = Exposures::new(4);
        let config = OptimizerConfig::default();
        // a first step of Adam is the rate, whatever the gradient's size
        exposures.step(&[gradient(1, 3e-5), gradient(1, 1e-5)], &config, 0.01).unwrap();
        for (photograph, share) in [(0, 0.25), (1, -0.75), (2, 0.25), (3, 0.25)] {
            for channel in 0..3 {
                let found = [0, 1].map(|part| exposures.values[photograph][2 * channel + part]);
                let expected = [0.01 * share, -0.01 * share];
                let is_near = |(a, b): (f32, f32)| (a - b).abs() < 1e-6;
                assert!(found.into_iter().zip(expected).all(is_near), "{photograph}: {found:?}");
            }
        }
        assert_eq!(exposures.steps, [0, 1, 0, 0]);
        let before = exposures.clone();
        let error = exposures.step(&[gradient(2, f64::NAN)], &config, 0.01).unwrap_err();
        assert!(error.to_string().contains("photograph 2"), "{error}");
        assert_eq!(exposures, before);
    }
}
