//! The gradient of a hash grid's table: the scale, the fixed-point sums, and the gradient in f32.

use glam::Vec4;
use organza_shaders::hash_grid::HashGridParams;
use organza_shaders::hash_grid_backward::{
    HashGridBackwardKernel, HashGridGradientKernel, HashGridGradientParams, VALUES_PER_FLAG,
};
use organza_shaders::hash_grid_scale::{
    HashGridNormKernel, HashGridNormParams, HashGridPeakKernel, HashGridPeakParams,
    HashGridScaleKernel, HashGridScaleParams, SCALE_VALUES,
};
use organza_shaders::limits::MAX_LAYERS;

use crate::scene::field::DeviceField;
use muslin_device::{Buffer, Count, Device, Error, Result};
use organza_core::scene::MAX_HIDDEN_LAYERS;

const _: () = assert!(MAX_LAYERS as usize == MAX_HIDDEN_LAYERS + 1);

/// Gradient of a hash grid's table.
///
/// For each part of a batch: [`raise_bound`](Self::raise_bound), [`set_scale`](Self::set_scale), then
/// [`accumulate`](Self::accumulate) for each span of chunks, then [`finish`](Self::finish). No call waits for the device. Parts can
/// share a scale: all of them raise the bound before the scale is set.
#[derive(Clone, Debug)]
pub struct HashGridGradient {
    /// `[entries, features]`; [`HashGridGradient::finish`] adds to it.
    pub gradient: Buffer<f32>,
    /// `[ceil(entries * features / 64)]`: not 0 where a block of 64 values has changed. Clear these flags together with the
    /// gradient.
    pub touched: Buffer<u32>,
    /// `[1]`: 0, or a `STATUS_..` of [`organza_shaders::hash_grid_scale`]: some gradients were not finite, and were left out.
    pub status: Buffer<u32>,
    /// `[2 * entries * features]`: 64-bit integers, the low word first; 0 between parts.
    pub(crate) sum: Buffer<u32>,
    /// `[1 + layers]`: bits of the bounds' factors; 0 between parts.
    pub(crate) bound: Buffer<u32>,
    /// `[3]`: see `hash_grid_scale`.
    scale: Buffer<f32>,
}

impl HashGridGradient {
    /// Zeros, for a field.
    pub fn new(device: &Device, field: &DeviceField) -> Result<Self> {
        let values = field.table.len();
        if values > (u32::MAX / 2) as usize {
            let what = format!("the gradient of a hash grid with {values} values");
            return Err(Error::OutOfMemory { needed: 8 * values as u64, available: None, what });
        }
        Ok(Self {
            gradient: device.zeros("gradient of a hash grid", values)?,
            touched: device.zeros("touched blocks", values.div_ceil(VALUES_PER_FLAG as usize))?,
            status: device.zeros("status of a gradient", 1)?,
            sum: device.zeros("sums of a hash grid", 2 * values)?,
            bound: device.zeros("bounds of a gradient", 1 + field.layers.len())?,
            scale: device.zeros("scale of a gradient", SCALE_VALUES as usize)?,
        })
    }

    /// Raises the bound of the gradients that are added until the next [`finish`](Self::finish).
    ///
    /// `pair_gradient [pairs, 3]`. `transmittance` is T `[pairs]`, its exponent and `faint` of [`gradient_count`] for the
    /// transmittance field, `None` for the color field.
    ///
    /// [`gradient_count`]: organza_shaders::transmittance_backward::gradient_count()
    pub fn raise_bound(
        &self,
        device: &Device,
        pair_gradient: &Buffer<Vec4>,
        transmittance: Option<(&Buffer<f32>, f32, f32)>,
        pairs: &Count,
    ) -> Result<()> {
        let capacity = pairs.upper_bound();
        let color = u32::from(transmittance.is_none());
        // every binding needs a buffer, even if the kernel does not read it
        let (transmittance, power, faint) = transmittance.unwrap_or((&self.scale, 1.0, 0.0));
        let kernel = HashGridPeakKernel {
            params: HashGridPeakParams { pairs: capacity, color, power, faint },
            pair_gradient,
            transmittance,
            bound: &self.bound,
        };
        device.run_all(&kernel.counted(pairs))
    }

    /// Sets the unit of the fixed-point sums from the bound, for at most `samples` samples.
    pub fn set_scale(&self, device: &Device, field: &DeviceField, samples: &Count) -> Result<()> {
        for (layer, slot) in field.layers.iter().zip(1..) {
            let params = HashGridNormParams {
                inputs: layer.inputs,
                columns: layer.columns,
                weight: layer.weight,
                slot,
            };
            let parameters = &field.parameters;
            let kernel = HashGridNormKernel { params, parameters, bound: &self.bound };
            device.run_all(&kernel)?;
        }
        let layers = field.layers.len() as u32;
        let kernel = HashGridScaleKernel {
            params: HashGridScaleParams { layers, samples: samples.upper_bound() },
            bound: &self.bound,
            scale: &self.scale,
            status: &self.status,
        };
        device.run_all(&kernel.counted(samples))
    }

    /// Adds the gradients of a span of `count` samples to the sums.
    ///
    /// `points` are the ones of the forward pass. In `feature_gradient [chunks, rows, stride]`, the first row of the grid's
    /// features is `params.first_row`.
    pub fn accumulate(
        &self,
        device: &Device,
        field: &DeviceField,
        params: HashGridParams,
        count: &Count,
        points: &Buffer<f32>,
        feature_gradient: &Buffer<f32>,
    ) -> Result<()> {
        let kernel = HashGridBackwardKernel {
            params,
            levels: &field.levels,
            position: points,
            feature_gradient,
            scale: &self.scale,
            sum: &self.sum,
            touched: &self.touched,
            status: &self.status,
        };
        device.run_all(&kernel.counted(count))
    }

    /// Adds the sums to the gradient, and clears them.
    pub fn finish(&self, device: &Device) -> Result<()> {
        let values = self.gradient.len() as u32;
        let kernel = HashGridGradientKernel {
            params: HashGridGradientParams { values },
            scale: &self.scale,
            touched: &self.touched,
            sum: &self.sum,
            gradient: &self.gradient,
        };
        device.run_all(&kernel)
    }

    /// Clears everything but the status.
    pub fn clear(&self, device: &Device) {
        device.clear(&self.gradient);
        [&self.touched, &self.sum, &self.bound].into_iter().for_each(|b| device.clear(b));
    }
}

#[cfg(test)]
mod tests {
    use std::borrow::Cow;

    use super::*;
    use crate::scene::options::UploadOptions;
    use crate::scene::packed::pack_field;
    use muslin_device::DeviceOptions;
    use organza_core::scene::{Field, GridConfig, Layer, Network};

    /// A grid with a network of two inputs, one hidden layer and one output.
    fn field(device: &Device) -> DeviceField {
        let grid =
            GridConfig { levels: 2, features: 2, log2_table: 6, base_resolution: 3.0, growth: 3.0 };
        let layer = |inputs: usize, outputs: usize| Layer {
            weight: vec![0.5; inputs * outputs],
            bias: vec![0.0; outputs],
            inputs,
            outputs,
        };
        let network = Network { layers: vec![layer(4, 3), layer(3, 1)] };
        let table = vec![0.0; grid.entries() * 2];
        let field = Field { grid: table, network };
        let options = UploadOptions::default();
        let upload = |name, values: Cow<'_, [f32]>| device.upload(name, &values);
        let tensors = pack_field(&field).try_map(["grid", "network"], upload).expect("memory");
        DeviceField::new(device, "color", &grid, &field, &tensors, options).expect("a field")
    }

    #[test]
    fn parts_of_any_scale_add_up() {
        const STRIDE: u32 = 20;
        let device = crate::open_device(&DeviceOptions::cpu(Some(2))).expect("the CPU");
        let field = field(&device);
        let table = HashGridGradient::new(&device, &field).expect("memory");
        let points: Vec<_> = (0..6 * STRIDE).map(|i| (i % 7) as f32 / 8.0).collect();
        let points = device.upload("points", &points).expect("memory");
        let mut total = 0.0;
        for (part, samples) in [(0, 17_u32), (1, 5), (2, 11)] {
            let size = 10_f32.powi(part * 4 - 4);
            // at most the bound: |T dL/dT| times 3/2 and 1/2
            let rows: Vec<_> =
                (0..5 * STRIDE).map(|i| size * 0.375 * (i % 5) as f32 / 4.0).collect();
            for row in 1..5 {
                for chunk in [samples, samples - 3] {
                    let values = &rows[(row * STRIDE) as usize..][..chunk as usize];
                    total += values.iter().map(|&value| f64::from(value)).sum::<f64>();
                }
            }
            let rows = device.upload("rows", &rows).expect("memory");
            let pair = device.upload("pair", &[Vec4::W * size, Vec4::ZERO, Vec4::ZERO]);
            let transmittance = device.upload("transmittance", &[0.5]).expect("memory");
            let pair = pair.expect("memory");
            let all = 2 * samples;
            let counts = [1, all].map(Count::known);
            let transmittance = Some((&transmittance, 1.0, 0.0));
            table.raise_bound(&device, &pair, transmittance, &counts[0]).expect("a bound");
            table.set_scale(&device, &field, &counts[1]).expect("a scale");
            for chunk in [samples, samples - 3] {
                let params = HashGridParams {
                    points: chunk,
                    stride: STRIDE,
                    first_row: 1,
                    features: 2,
                    chunk: 64,
                    point_rows: 6,
                    rows: 5,
                };
                let count = Count::known(chunk);
                table.accumulate(&device, &field, params, &count, &points, &rows).expect("a sum");
            }
            table.finish(&device).expect("a gradient");
        }
        // the weights of a point's corners add up to 1
        let gradient = device.read(&table.gradient).expect("a gradient");
        let found: f64 = gradient.iter().map(|&value| f64::from(value)).sum();
        assert!((found / total - 1.0).abs() < 1e-6, "{found}, {total}");
        assert_eq!(device.read(&table.status).expect("a status"), [0]);
        let touched = device.read(&table.touched).expect("flags");
        for (block, values) in touched.iter().zip(gradient.chunks(VALUES_PER_FLAG as usize)) {
            assert!(*block == 1 || values.iter().all(|&value| value == 0.0));
        }
    }
}
