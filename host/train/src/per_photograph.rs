//! Learned values of each photograph, with Adam's state: exposures and poses.

use std::collections::BTreeMap;
use std::path::Path;

use serde::{Deserialize, Serialize};

use super::config::{EPSILON, OptimizerConfig};
use organza_core::scene::Tensor;
use organza_core::{Error, Result, TileBatch};
use organza_render::ExposureGradient;

/// Prefix of the values' name in a checkpoint.
pub(super) const VALUES_PREFIX: &str = "train.";

/// Number of learned values per photograph.
pub const VALUES: usize = 6;

/// Learned values of all training photographs, with Adam's state.
///
/// A step only changes the values of photographs in its batch, and each photograph counts its own steps. So a
/// photograph's moments do not decay in other steps.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct PerPhotograph {
    /// Learned values, `[photographs, 6]`.
    pub values: Vec<[f32; VALUES]>,
    /// Adam's moments of `values`.
    pub moments: [Vec<[f32; VALUES]>; 2],
    /// Number of steps that showed each photograph, `[photographs]`.
    pub steps: Vec<u32>,
}

impl PerPhotograph {
    /// Values of 0 for each photograph, before the first step.
    #[must_use]
    pub fn new(photographs: usize) -> Self {
        let zeros = || vec![[0.0; VALUES]; photographs];
        Self { values: zeros(), moments: [zeros(), zeros()], steps: vec![0; photographs] }
    }

    /// Takes one step of Adam for the photographs that have a gradient. There is a rate for each value. Errors call
    /// the values `what`.
    ///
    /// # Errors
    /// [`Error::Diverged`] if a gradient is not finite. Nothing has changed then.
    pub(super) fn adam(
        &mut self,
        gradients: &BTreeMap<usize, [f64; VALUES]>,
        config: &OptimizerConfig,
        rates: [f64; VALUES],
        what: &str,
    ) -> Result<()> {
        let is_wrong = |gradient: &[f64; VALUES]| gradient.iter().any(|g| !g.is_finite());
        if let Some((photograph, _)) = gradients.iter().find(|(_, gradient)| is_wrong(gradient)) {
            let reason =
                format!("the gradient of the {what} of photograph {photograph} is not finite");
            return Err(Error::Diverged { reason });
        }
        for (&photograph, gradient) in gradients {
            self.steps[photograph] += 1;
            let t = f64::from(self.steps[photograph]);
            let corrections = [config.beta1, config.beta2].map(|beta| 1.0 - beta.powf(t));
            let [first, second] = &mut self.moments;
            for (at, &g) in gradient.iter().enumerate() {
                first[photograph][at] = mix(first[photograph][at], g, config.beta1);
                second[photograph][at] = mix(second[photograph][at], g * g, config.beta2);
                let m = f64::from(first[photograph][at]) / corrections[0];
                let v = f64::from(second[photograph][at]) / corrections[1];
                let moved = rates[at] * m / (v.sqrt() + EPSILON);
                let value = &mut self.values[photograph][at];
                *value = (f64::from(*value) - moved) as f32;
            }
        }
        Ok(())
    }

    /// Tensors for a checkpoint: the values with their shape `[photographs, ..]`, Adam's moments, and the steps.
    /// Steps are whole numbers, which f32 represents up to 2^24.
    pub(super) fn tensors(&self, name: &str, shape: &[usize]) -> Vec<(String, Tensor)> {
        let count = self.values.len();
        let [first, second] = &self.moments;
        let values = [&self.values, first, second].map(|values| Tensor {
            shape: [&[count], shape].concat(),
            data: values.as_flattened().to_vec(),
        });
        let steps = self.steps.iter().map(|&steps| steps as f32).collect();
        let steps = Tensor { shape: vec![count], data: steps };
        names(name).into_iter().zip(values.into_iter().chain([steps])).collect()
    }

    /// Reads the values from a checkpoint's tensors, if it has any. Errors name `origin`.
    ///
    /// # Errors
    /// [`Error::Invalid`] if the tensors do not belong together.
    pub(super) fn from_tensors(
        name: &str,
        tensors: &mut BTreeMap<String, Tensor>,
        origin: &Path,
    ) -> Result<Option<Self>> {
        let names = names(name);
        let found = names.each_ref().map(|name| tensors.remove(name).map(|tensor| tensor.data));
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
                names.join("`, `")
            );
            return Err(Error::Invalid { origin: origin.to_owned(), reason });
        }
        let steps = steps.into_iter().map(|steps| steps as u32).collect();
        let [values, first, second] = [values, first, second].map(rows);
        Ok(Some(Self { values, moments: [first, second], steps }))
    }
}

/// One step of a moving average, with decay `beta`.
fn mix(before: f32, now: f64, beta: f64) -> f32 {
    (beta * f64::from(before) + (1.0 - beta) * now) as f32
}

/// Names in a checkpoint: the values, Adam's two moments, and the steps.
pub(super) fn names(name: &str) -> [String; 4] {
    [VALUES_PREFIX, "adam.first.", "adam.second.", "adam.steps."]
        .map(|prefix| format!("{prefix}{name}"))
}

/// The exposures of all training photographs.
///
/// The values of a photograph are, for red, green and blue, the logarithm a of the gain and the offset b. A rendered
/// color x is compared as `exp(a) x + b`. A darker scene with larger gains would look the same. So the means of a and
/// b over all photographs are kept at 0: on average, a photograph shows the scene's own colors.
#[derive(Clone, Debug)]
pub(super) struct Exposures(pub PerPhotograph);

impl Exposures {
    /// Gain and offset of each channel for a batch's tiles: `[K, 3, 2]`.
    pub fn tile_values(&self, batch: &TileBatch) -> Vec<f32> {
        let of = |camera: usize| {
            let [r, r0, g, g0, b, b0] = self.0.values[camera];
            [gain(r), r0, gain(g), g0, gain(b), b0]
        };
        batch.tiles.iter().flat_map(|tile| of(tile.camera)).collect()
    }

    /// Takes one step of Adam with the gradients of a batch's tiles, in the order of the tiles.
    pub fn step(
        &mut self,
        tiles: &[ExposureGradient],
        config: &OptimizerConfig,
        rate: f64,
    ) -> Result<()> {
        let mut sums: BTreeMap<usize, [f64; VALUES]> = BTreeMap::new();
        for tile in tiles {
            let sum = sums.entry(tile.camera).or_default();
            for (channel, [by_gain, by_offset]) in tile.gradient.into_iter().enumerate() {
                // the derivative of exp(a) is exp(a)
                let gain = f64::from(gain(self.0.values[tile.camera][2 * channel]));
                sum[2 * channel] += by_gain * gain;
                sum[2 * channel + 1] += by_offset;
            }
        }
        self.0.adam(&sums, config, [rate; VALUES], "exposure")?;
        self.center();
        Ok(())
    }

    /// Shifts all values so that their means are 0.
    fn center(&mut self) {
        let count = self.0.values.len() as f64;
        for at in 0..VALUES {
            let mean =
                self.0.values.iter().map(|values| f64::from(values[at])).sum::<f64>() / count;
            for values in &mut self.0.values {
                values[at] = (f64::from(values[at]) - mean) as f32;
            }
        }
    }
}

/// Computed in f64: its exponential is the same in every program on one machine.
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
        let mut exposures = Exposures(PerPhotograph::new(4));
        let config = OptimizerConfig::default();
        // Adam's first step has the size of the rate, for any size of the gradient
        exposures.step(&[gradient(1, 3e-5), gradient(1, 1e-5)], &config, 0.01).unwrap();
        for (photograph, share) in [(0, 0.25), (1, -0.75), (2, 0.25), (3, 0.25)] {
            for channel in 0..3 {
                let found = [0, 1].map(|part| exposures.0.values[photograph][2 * channel + part]);
                let expected = [0.01 * share, -0.01 * share];
                let is_near = |(a, b): (f32, f32)| (a - b).abs() < 1e-6;
                assert!(found.into_iter().zip(expected).all(is_near), "{photograph}: {found:?}");
            }
        }
        assert_eq!(exposures.0.steps, [0, 1, 0, 0]);
        let before = exposures.0.clone();
        let error = exposures.step(&[gradient(2, f64::NAN)], &config, 0.01).unwrap_err();
        assert!(error.to_string().contains("photograph 2"), "{error}");
        assert_eq!(exposures.0, before);
    }
}
