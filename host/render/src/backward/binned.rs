//! Gradients that are summed exactly, so that no order of their terms matters.

use muslin::binned::ROWS;
use organza_shaders::binned::{BinnedGradientKernel, BinnedGradientParams};

use muslin_device::{Buffer, Device, Result};

/// A gradient, and the [binned](muslin::binned) sums that become part of it.
#[derive(Debug)]
pub struct BinnedGradient {
    /// [`BinnedGradient::finish`] adds to it.
    pub values: Buffer<f32>,
    /// `[17, values, 2]`: 64-bit integers, the low word first; kernels add to them.
    pub sum: Buffer<u32>,
}

impl BinnedGradient {
    /// Zeros.
    pub fn new(device: &Device, label: &'static str, values: usize) -> Result<Self> {
        let sum = device.zeros("sums of a gradient", 2 * ROWS as usize * values)?;
        Ok(Self { values: device.zeros(label, values)?, sum })
    }

    /// The same gradient, on the same memory.
    pub fn view(&self) -> Self {
        Self { values: self.values.view(), sum: self.sum.view() }
    }

    /// Adds the sums to the gradient, and clears them.
    pub fn finish(&self, device: &Device) -> Result<()> {
        let values = self.values.len() as u32;
        let kernel = BinnedGradientKernel {
            params: BinnedGradientParams { values },
            sum: &self.sum,
            gradient: &self.values,
        };
        device.run(&kernel, values, 1)
    }

    /// Zeros, as in the beginning.
    pub fn clear(&self, device: &Device) {
        device.clear(&self.values);
        device.clear(&self.sum);
    }
}
