//! Adam and its learning rates: one for each tensor of the Gaussians, and for the fields.

use serde::{Deserialize, Serialize};

use super::check::within;
use organza_core::gaussian_tensors;

use crate::scene::{FieldTensors, GaussianTensors, Tensors};

/// Adam's epsilon.
pub(in crate::train) const EPSILON: f64 = 1e-12;
/// Factor of the rates at the end of their cooldown.
const COOLED: f64 = 0.02;

/// A learning rate that falls from the first step to the last by a constant factor per step. See also
/// [`OptimizerConfig::cooldown`].
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Rate {
    /// Rate at the first step.
    pub first: f64,
    /// Rate at the last step, without the cooldown.
    pub last: f64,
}

macro_rules! define {
    ($($(#[$doc:meta])* $name:ident: $row:tt, $why:literal;)+) => {
        /// Adam (Kingma and Ba) and its rates. The rate of `position` is relative to half the longest side of the
        /// scene's box.
        #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
        #[serde(deny_unknown_fields, default)]
        pub struct OptimizerConfig {
            /// beta1
            pub beta1: f64,
            /// beta2
            pub beta2: f64,
            /// Final part of the run, 0 to 1, in which all rates also fall linearly to a fiftieth, so that noise
            /// settles (Hägele et al. 2024, "Scaling Laws and Compute-Optimal Training Beyond Fixed Training
            /// Durations").
            pub cooldown: f64,
            /// lambda, the weight decay of the transmittance network's grid (AdamW, Loshchilov and Hutter 2019). Each
            /// step multiplies its values by `1 - alpha lambda`, so space stays empty unless photographs need more.
            pub transmittance_decay: f64,
            $($(#[$doc])* pub $name: Rate,)+
            /// Rate of both hash grids.
            pub grids: Rate,
            /// Rate of both networks.
            pub networks: Rate,
            /// Rate of the photographs' exposures, if they are learned.
            pub exposure: Rate,
            /// Rate of the cameras' poses, if they are refined: of rotations in radians. The rate of shifts is
            /// relative to half the longest side of the scene's box.
            pub pose: Rate,
        }

        impl OptimizerConfig {
            /// The rate of each tensor of a scene.
            #[must_use]
            pub fn rates(&self) -> Tensors<Rate> {
                let field = FieldTensors { grid: self.grids, network: self.networks };
                let gaussians = GaussianTensors { $($name: self.$name,)+ };
                Tensors { gaussians, color: field, transmittance: field }
            }

            /// Every rate with its name in the file.
            pub(in crate::train) fn named_rates(&self) -> impl Iterator<Item = (&'static str, Rate)> {
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

impl Default for OptimizerConfig {
    fn default() -> Self {
        let rate = |first, last| Rate { first, last };
        Self {
            beta1: 0.9,
            beta2: 0.99,
            cooldown: 0.3,
            transmittance_decay: 1.0,
            position: rate(2e-3, 1e-4),
            rotation: rate(4e-3, 4e-3),
            log_scale: rate(2e-2, 2e-2),
            opacity: rate(1e-1, 1e-1),
            material: rate(2e-2, 2e-2),
            extra: rate(2e-2, 2e-2),
            grids: rate(1e-2, 1e-2),
            networks: rate(5e-3, 5e-3),
            exposure: rate(1e-2, 1e-3),
            pose: rate(3e-4, 3e-5),
        }
    }
}

impl OptimizerConfig {
    /// A rate after the part `share` of the run, 0 to 1: see [`RunConfig::share`](super::RunConfig::share).
    #[must_use]
    pub fn rate_at(&self, rate: Rate, share: f64) -> f64 {
        let share = share.min(1.0);
        let left = if self.cooldown > 0.0 { (1.0 - share) / self.cooldown } else { 1.0 };
        rate.first * (rate.last / rate.first).powf(share) * left.clamp(COOLED, 1.0)
    }

    /// Checks the rates. The error is a sentence about the first value out of range.
    pub(super) fn check(&self) -> Result<(), String> {
        within("optimizer.beta1", self.beta1, 0.0, 0.999_999)?;
        within("optimizer.beta2", self.beta2, 0.0, 0.999_999_9)?;
        within("optimizer.cooldown", self.cooldown, 0.0, 1.0)?;
        within("optimizer.transmittance_decay", self.transmittance_decay, 0.0, 1.0)?;
        for (name, rate) in self.named_rates() {
            within(&format!("optimizer.{name}.first"), rate.first, 1e-12, 1.0)?;
            within(&format!("optimizer.{name}.last"), rate.last, 1e-12, 1.0)?;
        }
        Ok(())
    }
}
