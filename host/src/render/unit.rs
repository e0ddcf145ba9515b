//! Units: what a part has of each camera. Gradients are added unit by unit, so that their bits do not depend on how a batch
//! is cut into parts, nor on who computes them.

use glam::Vec4;
use organza_shaders::dense_backward::{DenseUnitSumKernel, DenseUnitSumParams};
use organza_shaders::unit::{UNIT_VALUES, UnitBeginKernel, UnitBeginParams};

use super::bin::Bins;
use super::gradient::FieldGradient;
use super::plan::words;
use super::scene::DeviceScene;
use organza_device::{Buffer, Device, Result};

/// How the samples of a field lie in the units of a part.
#[derive(Debug)]
pub struct Units {
    /// Their number.
    pub count: u32,
    /// `[units + 1, 2]`: see [`organza_shaders::unit`].
    pub begin: Buffer<u32>,
}

impl Units {
    /// Those of the color network, with slices of `slice` samples; with `first_sample [pairs + 1]`, those of the transmittance
    /// network.
    pub fn new(
        device: &Device,
        scene: &DeviceScene,
        bins: &Bins,
        slice: u32,
        first_sample: Option<&Buffer<u32>>,
    ) -> Result<Self> {
        let (count, words) = (bins.cameras.len() as u32, words(scene.gaussians));
        let begin = device.unwritten("units", ((count + 1) * UNIT_VALUES) as usize)?;
        let first_pair = &bins.pair_mask.first;
        let kernel = UnitBeginKernel {
            params: UnitBeginParams {
                units: count,
                words,
                slice,
                of_rays: u32::from(first_sample.is_some()),
            },
            first_pair,
            first_sample: first_sample.unwrap_or(first_pair),
            unit: &begin,
        };
        device.run(&kernel, 1, 1)?;
        Ok(Self { count, begin })
    }
}

/// What going back through a field leaves for the sums over units.
#[derive(Debug)]
pub struct FieldUnits {
    /// Gradients of the network's parameters: `[units, parameters]`.
    pub network: Buffer<Vec4>,
    /// Gradients of each pair's material or extra vector: `[pairs, width]`.
    pub pair_vector: Buffer<f32>,
    /// Values of such a vector.
    pub width: u32,
}

impl FieldUnits {
    /// Adds the gradients of the network, unit by unit.
    pub fn add_network(&self, device: &Device, gradient: &FieldGradient) -> Result<()> {
        let parameters = gradient.parameters.len();
        let units = self.network.len() / parameters;
        let kernel = DenseUnitSumKernel {
            params: DenseUnitSumParams { parameters: parameters as u32, units: units as u32 },
            unit_sum: &self.network,
            gradient: &gradient.parameters,
        };
        device.run(&kernel, kernel.params.parameters, 1)
    }
}
