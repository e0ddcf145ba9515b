//! Learned values of each photograph, with Adam's state: exposures and poses.

use std::collections::BTreeMap;
use std::path::Path;

use serde::{Deserialize, Serialize};

use super::config::{EPSILON, OptimizerConfig};
use organza_core::error::{Error, Result};
use organza_core::scene::Tensor;

/// Prefix of the values' name in a checkpoint.
pub(super) const VALUES_PREFIX: &str = "train.";

/// Number of learned values per photograph.
pub const VALUES: usize = 6;

/// Learned values of all training photographs, with Adam's state.
///
/// A step only changes the photographs that it shows, and each counts its own steps. So Adam's moments of a
/// photograph do not decay while others are shown.
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
