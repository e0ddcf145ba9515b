//! Learned values of each photograph, with Adam's state: exposures and poses.

use std::collections::BTreeMap;
use std::path::Path;

use organza_shaders::exposure::{self, ExposureCenterKernel, ExposureCenterParams, STRIDE};
use organza_shaders::limits::MAX_PHOTOGRAPHS;
use serde::{Deserialize, Serialize};

use super::config::{EPSILON, OptimizerConfig};
use super::optimizer::{Adam, Update};
use muslin_device::{Buffer, Device};
use organza_core::error::argument;
use organza_core::scene::Tensor;
use organza_core::{Error, Result, TileBatch};
use organza_render::TensorGradient;

/// Prefix of the values' name in a checkpoint.
pub(super) const VALUES_PREFIX: &str = "train.";

/// Number of learned values per photograph.
pub const VALUES: usize = exposure::VALUES as usize;

/// Learned values of all training photographs, with Adam's state.
///
/// A step only changes the values of photographs in its batch: moments do not decay in other steps. Exposures, whose values are on the
/// device, follow the run's number of steps; for poses, each photograph counts its own.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct PerPhotograph {
    /// Learned values, `[photographs, 6]`.
    pub values: Vec<[f32; VALUES]>,
    /// Adam's moments of `values`.
    pub moments: [Vec<[f32; VALUES]>; 2],
    /// Number of steps that showed each photograph, `[photographs]`; empty for exposures.
    pub steps: Vec<u32>,
}

impl PerPhotograph {
    /// Values of 0 for each photograph, before the first step.
    #[must_use]
    pub fn new(photographs: usize) -> Self {
        let zeros = || vec![[0.0; VALUES]; photographs];
        Self { values: zeros(), moments: [zeros(), zeros()], steps: vec![0; photographs] }
    }

    /// Takes one step of Adam for the photographs that have a gradient. There is a rate for each value. `what` names the
    /// values in errors.
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
    /// Steps are whole numbers, which f32 represents up to 2^24; exposures have none.
    pub(super) fn tensors(&self, name: &str, shape: &[usize]) -> Vec<(String, Tensor)> {
        let count = self.values.len();
        let [first, second] = &self.moments;
        let values = [&self.values, first, second].map(|values| Tensor {
            shape: [&[count], shape].concat(),
            data: values.as_flattened().to_vec(),
        });
        let steps = self.steps.iter().map(|&steps| steps as f32).collect();
        let steps = Tensor { shape: vec![count], data: steps };
        let steps = (!self.steps.is_empty()).then_some(steps);
        names(name).into_iter().zip(values.into_iter().chain(steps)).collect()
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
        let is_whole = steps.is_empty() || lengths[0] == VALUES * steps.len();
        if lengths != [lengths[0]; 3] || !is_whole || !steps.iter().all(is_count) {
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

/// The exposures of all training photographs, on the device: see [`organza_shaders::exposure`]. Adam leaves photographs that a step
/// does not show as they are.
#[derive(Debug)]
pub(super) struct Exposures {
    /// `[photographs, STRIDE]`
    pub values: Buffer<f32>,
    moments: [Buffer<f32>; 2],
    photographs: u32,
}

impl Exposures {
    /// Uploads exposures.
    ///
    /// # Errors
    /// [`Error::Argument`] if there are too many photographs; the same errors as [`Device::upload`].
    pub fn new(device: &Device, learned: &PerPhotograph) -> Result<Self> {
        let photographs = learned.values.len() as u32;
        if photographs > MAX_PHOTOGRAPHS {
            return argument(format!(
                "exposures of {photographs} photographs cannot be learned, only of {MAX_PHOTOGRAPHS}: use `exposure.learn=off`"
            ));
        }
        let upload = |rows: &Vec<[f32; VALUES]>| {
            let mut padded = vec![0.0; rows.len() * STRIDE as usize];
            let places = padded.chunks_exact_mut(STRIDE as usize);
            places.zip(rows).for_each(|(place, row)| place[..VALUES].copy_from_slice(row));
            device.upload("exposures", &padded)
        };
        let [first, second] = &learned.moments;
        let moments = [upload(first)?, upload(second)?];
        Ok(Self { values: upload(&learned.values)?, moments, photographs })
    }

    /// The values as they are now.
    pub fn read(&self, device: &Device) -> Result<PerPhotograph> {
        let read = |buffer: &Buffer<f32>| -> Result<Vec<[f32; VALUES]>> {
            let rows = device.read(buffer)?;
            let row = |row: &[f32]| std::array::from_fn(|at| row[at]);
            Ok(rows.chunks_exact(STRIDE as usize).map(row).collect())
        };
        let [first, second] = &self.moments;
        let moments = [read(first)?, read(second)?];
        Ok(PerPhotograph { values: read(&self.values)?, moments, steps: Vec::new() })
    }

    /// Takes one step of Adam for the photographs of a batch, and shifts all values so that their means are 0.
    pub fn step(&self, adam: &Adam<'_>, batch: &TileBatch, update: Update) -> Result<()> {
        let mut touched = vec![0; self.photographs as usize];
        batch.tiles.iter().for_each(|tile| touched[tile.camera] = 1);
        let touched = adam.device.upload("photographs of a step", &touched)?;
        let sums = adam.gradient.exposures.as_ref().expect("a gradient with exposures");
        let gradient = TensorGradient::whole(sums.values.clone(), Some(touched));
        let [first, second] = &self.moments;
        adam.step((&self.values, &gradient), Some(update), (first, second))?;
        let values = VALUES as u32;
        let kernel = ExposureCenterKernel {
            params: ExposureCenterParams { photographs: self.photographs, values },
            exposure: &self.values,
        };
        Ok(adam.device.run_all(&kernel.counted(&adam.gradient.unless_failed(values)))?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn adam_moves_what_is_shown_by_its_rate() {
        let mut learned = PerPhotograph::new(3);
        let config = OptimizerConfig::default();
        let mut step = |photograph: usize, gradient: f64| {
            let gradients = BTreeMap::from([(photograph, [gradient; VALUES])]);
            learned.adam(&gradients, &config, [0.01; VALUES], "pose").map(|()| learned.clone())
        };
        // Adam's first step has the size of the rate, for any size of the gradient
        let moved = step(1, 3e-5).unwrap();
        for (photograph, expected) in [(0, 0.0), (1, -0.01), (2, 0.0)] {
            let is_near = |value: &f32| (value - expected).abs() < 1e-6;
            assert!(moved.values[photograph].iter().all(is_near), "{photograph}: {moved:?}");
        }
        assert_eq!(moved.steps, [0, 1, 0]);
        let error = step(2, f64::NAN).unwrap_err();
        assert!(error.to_string().contains("photograph 2"), "{error}");
        assert_eq!(learned, moved);
    }
}
