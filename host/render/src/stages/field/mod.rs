//! A hash grid and its network on a device: the grid block by block, the network chunk by chunk.

pub mod backward;
pub mod samples;

use organza_shaders::dense::{DenseKernel, DenseParams, HeadParams, OUTPUTS_PER_INVOCATION};
use organza_shaders::hash_grid::{HashGridKernel, HashGridParams};
use organza_shaders::hash_grid_half::HashGridHalfKernel;

use self::samples::{BlockOf, Chunk, Layout, ROWS_OF_POINT};
use crate::scene::field::DeviceField;
use crate::scene::network::LayerPlace;
use muslin_device::{Buffer, Device, Result};

impl DeviceField {
    /// The hash grid's parameters for a piece of a block, whose features begin at `first_row`.
    pub(crate) fn grid_params(&self, piece: &BlockOf<'_>, first_row: u32) -> HashGridParams {
        let block = piece.block;
        let layout = piece.block.layout;
        HashGridParams {
            points: piece.samples(),
            stride: layout.stride,
            first_row,
            features: self.features,
            chunk: layout.chunk,
            point_rows: ROWS_OF_POINT,
            rows: block.rows,
        }
    }

    /// Writes the hash features of a block's points to the rows of its input from `first_row` on.
    pub fn encode(&self, device: &Device, block: &BlockOf<'_>, first_row: u32) -> Result<()> {
        block.pieces().try_for_each(|piece| self.encode_piece(device, &piece, first_row))
    }

    fn encode_piece(&self, device: &Device, piece: &BlockOf<'_>, first_row: u32) -> Result<()> {
        let params = self.grid_params(piece, first_row);
        let position = &piece.point();
        let output = &piece.input();
        let levels = &self.levels;
        let samples = params.points;
        let layers = self.levels.len() as u32;
        match &self.half_table {
            None => {
                let table = &self.table;
                let kernel = HashGridKernel { params, levels, table, position, output };
                device.run(&kernel.counted(&piece.count()), samples, layers)
            }
            Some(table) => {
                let kernel = HashGridHalfKernel { params, levels, table, position, output };
                device.run(&kernel.counted(&piece.count()), samples, layers)
            }
        }
    }

    /// The last layer's parameters, for a chunk of samples.
    pub fn head_params(&self, chunk: &Chunk) -> HeadParams {
        let head = self.head();
        HeadParams {
            samples: chunk.samples,
            first: chunk.first,
            stride: chunk.stride,
            inputs: head.inputs,
            weight: head.weight,
            bias: head.bias,
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
        let kernel = DenseKernel { params, parameters: &self.parameters, input, output };
        device.run(
            &kernel.counted(&chunk.count),
            chunk.samples,
            layer.columns * 4 / OUTPUTS_PER_INVOCATION,
        )
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
            activation: [
                device.unwritten("activations", len)?,
                device.unwritten("activations", len)?,
            ],
        })
    }
}
