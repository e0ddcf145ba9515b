//! A hash grid and its network on a device: the grid block by block, the network chunk by chunk.

use glam::Vec4;
use organza_kernel::half::HalfVector;
use organza_shaders::dense::{DenseKernel, DenseParams, HIDDEN_BLOCK};
use organza_shaders::hash_grid::{GridLevel, HashGridKernel, HashGridParams};
use organza_shaders::hash_grid_half::HashGridHalfKernel;

use super::UploadOptions;
use super::block::{BlockOf, Chunk, Layout, ROWS_OF_POINT};
use super::dense_half::half_weights;
use super::hash_grid_half::pack_halves;
use crate::scene::{Field, GridConfig, Interpolation, Network};
use organza_device::Result;
use organza_device::{Buffer, Device};

/// A field whose tensors lie on a device.
#[derive(Debug)]
pub struct DeviceField {
    pub(super) levels: Buffer<GridLevel>,
    pub(super) table: Buffer<f32>,
    /// Instead of `table`: the same as halves.
    pub(super) half_table: Option<Buffer<u32>>,
    pub parameters: Buffer<Vec4>,
    /// Instead of the hidden layers' weights among `parameters`: the same as halves.
    pub(super) half_weights: Option<Buffer<HalfVector>>,
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
    /// `name` is what the names of the field's tensors begin with.
    ///
    /// # Errors
    /// As [`Device::upload`]; [`Error::Invalid`](crate::Error::Invalid) where a value is too large for a half.
    pub fn upload(
        device: &Device,
        grid: &GridConfig,
        field: &Field,
        options: UploadOptions,
        name: &str,
    ) -> crate::error::Result<Self> {
        let (table, half_table) = if options.half_grids {
            let words = pack_halves(&field.grid, grid.features as usize, &format!("{name}.grid"))?;
            (device.zeros("hash grid", 0)?, Some(device.upload("hash grid of halves", &words)?))
        } else {
            (device.upload("hash grid", &field.grid)?, None)
        };
        let (parameters, layers) = pack_network(&field.network);
        let half_weights = if options.half_networks {
            let weights = half_weights(&field.network, &parameters, &layers, name)?;
            Some(device.upload("network of halves", &weights)?)
        } else {
            None
        };
        Ok(Self {
            levels: device.upload("grid levels", &grid.levels_for_kernels())?,
            table,
            half_table,
            parameters: device.upload("network", &parameters)?,
            half_weights,
            features: grid.features,
            smoothstep: grid.interpolation == Interpolation::Smoothstep,
            layers,
        })
    }

    pub fn bytes(&self) -> u64 {
        let halves = self.half_table.as_ref().map_or(0, Buffer::bytes)
            + self.half_weights.as_ref().map_or(0, Buffer::bytes);
        self.levels.bytes() + self.table.bytes() + self.parameters.bytes() + halves
    }

    /// The last layer, which each head evaluates on its own.
    pub fn head(&self) -> LayerPlace {
        self.layers[self.layers.len() - 1]
    }

    /// Rows of the widest hidden layer.
    pub(super) fn widest(&self) -> u32 {
        let hidden = &self.layers[..self.layers.len() - 1];
        hidden.iter().map(|layer| layer.columns * 4).max().unwrap_or(0)
    }

    /// The hash grid's parameters for a block, whose features begin at `first_row`.
    pub(super) fn grid_params(&self, block: BlockOf<'_>, first_row: u32) -> HashGridParams {
        let layout = block.block.layout;
        HashGridParams {
            points: block.samples,
            stride: layout.stride,
            first_row,
            features: self.features,
            smoothstep: u32::from(self.smoothstep),
            chunk: layout.chunk,
            point_rows: ROWS_OF_POINT,
            rows: block.block.rows,
        }
    }

    /// Writes the hash features of a block's points to the rows of its input from `first_row` on.
    pub fn encode(&self, device: &Device, block: BlockOf<'_>, first_row: u32) -> Result<()> {
        let params = self.grid_params(block, first_row);
        let (position, output) = (&block.point(), &block.input());
        let (levels, samples, layers) = (&self.levels, block.samples, self.levels.len() as u32);
        match &self.half_table {
            None => {
                let table = &self.table;
                let kernel = HashGridKernel { params, levels, table, position, output };
                device.run(&kernel.counted(&block.count()), samples, layers)
            }
            Some(table) => {
                let kernel = HashGridHalfKernel { params, levels, table, position, output };
                device.run(&kernel.counted(&block.count()), samples, layers)
            }
        }
    }

    /// Runs the hidden layers over a chunk's input; returns the last one's activations.
    pub fn hidden<'s>(
        &self,
        device: &Device,
        scratch: &'s Scratch,
        chunk: &'s Chunk,
    ) -> Result<&'s Buffer<f32>> {
        let mut input = &chunk.input;
        for (index, layer) in self.layers[..self.layers.len() - 1].iter().enumerate() {
            let output = &scratch.activation[index % 2];
            self.layer(device, layer, input, output, chunk)?;
            input = output;
        }
        Ok(input)
    }

    /// A hidden layer for a chunk: `input [inputs, stride]` to `output [4 columns, stride]`.
    pub fn layer(
        &self,
        device: &Device,
        layer: &LayerPlace,
        input: &Buffer<f32>,
        output: &Buffer<f32>,
        chunk: &Chunk,
    ) -> Result<()> {
        let params = DenseParams {
            samples: chunk.samples,
            stride: chunk.stride,
            inputs: layer.inputs,
            columns: layer.columns,
            weight: layer.weight,
            bias: layer.bias,
        };
        if let Some(weights) = &self.half_weights {
            return self.half_layer(device, params, &chunk.count, weights, [input, output]);
        }
        let kernel = DenseKernel { params, parameters: &self.parameters, input, output };
        device.run(&kernel.counted(&chunk.count), chunk.samples, layer.columns * 4 / HIDDEN_BLOCK)
    }
}

/// Activations of one chunk, of two hidden layers next to each other: `[rows, stride]` each.
#[derive(Debug)]
pub struct Scratch {
    activation: [Buffer<f32>; 2],
}

impl Scratch {
    /// For chunks of this layout.
    pub fn new(device: &Device, field: &DeviceField, layout: Layout) -> Result<Self> {
        let len = field.widest() as usize * layout.stride as usize;
        Ok(Self {
            activation: [device.zeros("activations", len)?, device.zeros("activations", len)?],
        })
    }
}

/// A network's parameters as [`organza_shaders::dense`] reads them.
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
