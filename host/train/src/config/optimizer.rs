//! Adam and its learning rates: one for each tensor of the Gaussians, and for the fields.

use std::ops::RangeInclusive;

use super::table::within;
use super::{OptimizerConfig, Rate};
use organza_core::gaussian_tensors;

use organza_core::scene::{FieldTensors, GaussianTensors, Tensors};

/// Adam's epsilon.
pub(crate) const EPSILON: f64 = 1e-12;
/// Factor of the rates at the end of their cooldown.
const COOLED: f64 = 0.02;

/// The values that a learning rate can have.
const RATES: RangeInclusive<f64> = 1e-12..=1.0;

macro_rules! define {
    ($($(#[$doc:meta])* $name:ident: $row:tt, $why:literal, $rate:tt;)+) => {
        impl OptimizerConfig {
            /// The rate of each tensor of a scene.
            #[must_use]
            pub fn rates(&self) -> Tensors<Rate> {
                let field = FieldTensors { grid: self.grids, network: self.networks };
                let gaussians = GaussianTensors { $($name: self.$name,)+ };
                Tensors { gaussians, color: field, transmittance: field }
            }

            /// Every rate with its name in the file.
            pub(crate) fn named_rates(&self) -> impl Iterator<Item = (&'static str, Rate)> {
                let of_gaussians = [$((stringify!($name), self.$name)),+];
                let others = [
                    ("grids", self.grids),
                    ("networks", self.networks),
                    ("exposure", self.exposure),
                    ("pose", self.pose),
                ];
                of_gaussians.into_iter().chain(others)
            }
        }
    };
}

gaussian_tensors!(define);

impl OptimizerConfig {
    /// A rate after the part `fraction` of the run, 0 to 1: see [`RunConfig::fraction`](super::RunConfig::fraction).
    #[must_use]
    pub fn rate_at(&self, rate: Rate, fraction: f64) -> f64 {
        let fraction = fraction.min(1.0);
        let left = if self.cooldown > 0.0 { (1.0 - fraction) / self.cooldown } else { 1.0 };
        rate.first * (rate.last / rate.first).powf(fraction) * left.clamp(COOLED, 1.0)
    }

    /// Checks the rates. The error is a sentence about the first value out of range.
    pub(super) fn check_rates(&self) -> Result<(), String> {
        for (name, rate) in self.named_rates() {
            within(&format!("optimizer.{name}.first"), rate.first, RATES)?;
            within(&format!("optimizer.{name}.last"), rate.last, RATES)?;
        }
        Ok(())
    }
}
