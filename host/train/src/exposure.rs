//! The exposure of each photograph: a gain and an offset for each channel, learned with the scene.

use std::collections::BTreeMap;

use super::config::OptimizerConfig;
use super::per_photograph::{PerPhotograph, VALUES};
use organza_core::error::Result;
use organza_core::tile::TileBatch;
use organza_render::ExposureGradient;

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
    ///
    /// # Errors
    /// The same errors as [`PerPhotograph::adam`].
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

/// Computed in f64, whose exponential is the same in every program on one machine.
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
