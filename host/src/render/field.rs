//! A hash grid and its network on a device, evaluated chunk by chunk.

use glam::Vec4;
use organza_kernels::dense::{DenseKernel, DenseParams, HIDDEN_BLOCK};
use organza_kernels::hash_grid::{GridLevel, HashGridKernel, HashGridParams, POINT_ROWS};

use crate::backend::{Buffer, Device};
use crate::error::Result;
use crate::scene::{Field, GridConfig, Interpolation, Network};

/// A field whose tensors lie on a device.
#[derive(Debug)]
pub struct DeviceField {
    pub(super) levels: Buffer<GridLevel>,
    pub(super) table: Buffer<f32>,
    pub parameters: Buffer<Vec4>,
    pub(super) features: u32,
    pub(super) smoothstep: bool,
    pub(super) layers: Vec<LayerPlace>,
}

/// Where a layer lies in the buffer of a network's parameters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LayerPlace {
    pub inputs: u32,
    pub columns: u32,
    pub weight: u32,
    pub bias: u32,
}

impl DeviceField {
    pub fn upload(device: &Device, grid: &GridConfig, field: &Field) -> Result<Self> {
        let levels: Vec<_> = grid
            .levels_geometry()
            .iter()
            .map(|level| {
                GridLevel::new(
                    level.scale,
                    level.resolution,
                    level.first,
                    level.count,
                    level.hashed,
                )
            })
            .collect();
        let (parameters, layers) = pack_network(&field.network);
        Ok(Self {
            levels: device.upload("grid levels", &levels)?,
            table: device.upload("hash grid", &field.grid)?,
            parameters: device.upload("network", &parameters)?,
            features: grid.features,
            smoothstep: grid.interpolation == Interpolation::Smoothstep,
            layers,
        })
    }

    pub fn bytes(&self) -> u64 {
        self.levels.bytes() + self.table.bytes() + self.parameters.bytes()
    }

    /// The last layer, which each head evaluates on its own.
    pub fn head(&self) -> LayerPlace {
        self.layers[self.layers.len() - 1]
    }

    /// Rows of activations that evaluating `inputs` takes, in each of the scratch's two buffers.
    fn rows(&self, inputs: usize) -> usize {
        let hidden =
            self.layers[..self.layers.len() - 1].iter().map(|layer| layer.columns as usize * 4);
        hidden.fold(inputs, usize::max)
    }

    /// Writes the hash features of a chunk's points to the rows of its input from `first_row` on.
    pub fn encode(
        &self,
        device: &Device,
        rows: Rows<'_>,
        points: u32,
        first_row: u32,
    ) -> Result<()> {
        let kernel = HashGridKernel {
            params: HashGridParams {
                points,
                stride: rows.stride,
                first_row,
                features: self.features,
                smoothstep: u32::from(self.smoothstep),
            },
            levels: &self.levels,
            table: &self.table,
            position: rows.point,
            output: rows.input,
        };
        device.run(&kernel, points, self.levels.len() as u32)
    }

    /// Runs the hidden layers over `scratch.input`; returns the last one's activations.
    pub fn hidden<'s>(
        &self,
        device: &Device,
        scratch: &'s Scratch,
        samples: u32,
    ) -> Result<&'s Buffer<f32>> {
        let (mut input, mut output) = (&scratch.input, &scratch.output);
        for layer in &self.layers[..self.layers.len() - 1] {
            self.layer(device, layer, input, output, scratch.stride, samples)?;
            (input, output) = (output, input);
        }
        Ok(input)
    }

    /// A hidden layer: `input [inputs, stride]` to `output [4 columns, stride]`.
    pub fn layer(
        &self,
        device: &Device,
        layer: &LayerPlace,
        input: &Buffer<f32>,
        output: &Buffer<f32>,
        stride: u32,
        samples: u32,
    ) -> Result<()> {
        let params = DenseParams {
            samples,
            stride,
            inputs: layer.inputs,
            columns: layer.columns,
            weight: layer.weight,
            bias: layer.bias,
        };
        let kernel = DenseKernel { params, parameters: &self.parameters, input, output };
        device.run(&kernel, samples, layer.columns * 4 / HIDDEN_BLOCK)
    }
}

/// What a chunk's network reads.
#[derive(Clone, Copy, Debug)]
pub struct Rows<'a> {
    /// `[6, stride]`, and what else a stage puts behind it.
    pub point: &'a Buffer<f32>,
    /// `[inputs, stride]`
    pub input: &'a Buffer<f32>,
    pub stride: u32,
}

/// Activations of one chunk, `[rows, stride]` each, and the chunk's points and `s_factor`, `[7, stride]`.
#[derive(Debug)]
pub struct Scratch {
    pub point: Buffer<f32>,
    pub input: Buffer<f32>,
    output: Buffer<f32>,
    pub stride: u32,
    /// Samples of a chunk.
    pub chunk: u32,
}

impl Scratch {
    /// Enough for chunks of at most `samples` samples with `inputs` inputs.
    pub fn new(device: &Device, field: &DeviceField, inputs: usize, samples: u32) -> Result<Self> {
        // a CPU's chunk stays in its caches; a GPU's fills it
        let largest: u32 = if device.is_cpu_like() { 1 << 12 } else { 1 << 17 };
        let chunk = samples.min(largest);
        let stride = stride_of(chunk);
        let rows = field.rows(inputs);
        Ok(Self {
            point: device.zeros("points", (POINT_ROWS as usize + 1) * stride as usize)?,
            input: device.zeros("network input", rows * stride as usize)?,
            output: device.zeros("network output", rows * stride as usize)?,
            stride,
            chunk,
        })
    }

    /// What the network reads.
    pub fn rows(&self) -> Rows<'_> {
        Rows { point: &self.point, input: &self.input, stride: self.stride }
    }

    /// The chunks of `samples` samples: first and count.
    pub fn chunks(&self, samples: u32) -> impl Iterator<Item = (u32, u32)> + use<> {
        chunks(self.chunk, samples)
    }
}

/// Distance of two rows of a chunk's activations.
pub fn stride_of(chunk: u32) -> u32 {
    // not a power of two: rows would fall into the same sets of a cache
    chunk.next_multiple_of(16) + 16
}

/// `samples` samples, `chunk` at a time: first and count.
pub fn chunks(chunk: u32, samples: u32) -> impl Iterator<Item = (u32, u32)> {
    let chunk = chunk.max(1);
    (0..samples.div_ceil(chunk))
        .map(move |index| (index * chunk, chunk.min(samples - index * chunk)))
}

/// A network's parameters as [`organza_kernels::dense`] reads them.
pub(super) fn pack_network(network: &Network) -> (Vec<Vec4>, Vec<LayerPlace>) {
    let mut parameters = Vec::new();
    let mut places: Vec<LayerPlace> = Vec::new();
    for (index, layer) in network.layers.iter().enumerate() {
        let is_hidden = index + 1 < network.layers.len();
        let padded =
            layer.outputs.next_multiple_of(if is_hidden { HIDDEN_BLOCK as usize } else { 4 });
        let columns = padded / 4;
        // outputs past the last are zero, and nothing reads them
        let weight = |input: usize, output: usize| {
            if output < layer.outputs { layer.weight[output * layer.inputs + input] } else { 0.0 }
        };
        let bias = |output: usize| layer.bias.get(output).copied().unwrap_or(0.0);
        let place = parameters.len() as u32;
        for input in 0..layer.inputs {
            parameters.extend(
                (0..columns)
                    .map(|c| Vec4::from_array(std::array::from_fn(|o| weight(input, 4 * c + o)))),
            );
        }
        places.push(LayerPlace {
            inputs: layer.inputs as u32,
            columns: columns as u32,
            weight: place,
            bias: parameters.len() as u32,
        });
        parameters.extend(
            (0..columns).map(|c| Vec4::from_array(std::array::from_fn(|o| bias(4 * c + o)))),
        );
    }
    (parameters, places)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Layer;

    #[test]
    fn a_packed_network_is_the_transpose_padded() {
        let layer = |inputs: usize, outputs: usize| Layer {
            weight: (0..inputs * outputs).map(|i| 1.0 + i as f32).collect(),
            bias: (0..outputs).map(|i| -1.0 - i as f32).collect(),
            inputs,
            outputs,
        };
        let (parameters, places) =
            pack_network(&Network { layers: vec![layer(2, 5), layer(5, 3)] });
        assert_eq!(places[0], LayerPlace { inputs: 2, columns: 4, weight: 0, bias: 8 });
        assert_eq!(places[1], LayerPlace { inputs: 5, columns: 1, weight: 12, bias: 17 });
        assert_eq!(parameters.len(), 18);
        // weights of input 1: the second column of [5, 2]
        assert_eq!(parameters[4], Vec4::new(2.0, 4.0, 6.0, 8.0));
        assert_eq!(parameters[5], Vec4::new(10.0, 0.0, 0.0, 0.0));
        assert_eq!(parameters[17], Vec4::new(-1.0, -2.0, -3.0, 0.0));
    }
}
