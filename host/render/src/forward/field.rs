//! A hash grid and its network on a device: the grid block by block, the network chunk by chunk.

use glam::Vec4;
use organza_shaders::dense::{DenseKernel, DenseParams, OUTPUTS_PER_INVOCATION};
use organza_shaders::hash_grid::{GridLevel, HashGridKernel, HashGridParams};
use organza_shaders::hash_grid_half::HashGridHalfKernel;

use super::block::{BlockOf, Chunk, Layout, ROWS_OF_POINT};
use crate::scene::network::LayerPlace;
use crate::scene::options::UploadOptions;
use muslin_device::{Buffer, Device, Result};
use organza_core::halves::pack_halves;
use organza_core::scene::{Field, FieldTensors, GridConfig};

/// A field whose tensors lie on a device: `table` and `parameters` are those of the scene.
#[derive(Debug)]
pub struct DeviceField {
    pub(crate) levels: Buffer<GridLevel>,
    pub(crate) table: Buffer<f32>,
    /// Instead of `table`: the same as halves.
    pub(crate) half_table: Option<Buffer<u32>>,
    pub parameters: Buffer<Vec4>,
    pub(crate) features: u32,
    pub(crate) layers: Vec<LayerPlace>,
}

impl DeviceField {
    /// Of a host's field whose tensors lie on the device; `name` is what their names begin with.
    ///
    /// # Errors
    /// The same errors as [`Device::upload`]; [`Error::Invalid`](organza_core::Error::Invalid) if a value is too large
    /// for a half.
    pub fn new(
        device: &Device,
        name: &str,
        grid: &GridConfig,
        field: &Field,
        tensors: &FieldTensors<Buffer<f32>>,
        options: UploadOptions,
    ) -> organza_core::error::Result<Self> {
        let half_table = || -> organza_core::error::Result<_> {
            let words = pack_halves(&field.grid, grid.features as usize, &format!("{name}.grid"))?;
            Ok(device.upload("hash grid of halves", &words)?)
        };
        Ok(Self {
            levels: device.upload("grid levels", &grid.levels_for_kernels())?,
            table: tensors.grid.view(),
            half_table: options.half_grids.then(half_table).transpose()?,
            parameters: tensors.network.view(),
            features: grid.features,
            layers: LayerPlace::from_network(&field.network),
        })
    }

    /// The same field, on the same memory.
    pub(crate) fn view(&self) -> Self {
        Self {
            levels: self.levels.view(),
            table: self.table.view(),
            half_table: self.half_table.as_ref().map(Buffer::view),
            parameters: self.parameters.view(),
            features: self.features,
            layers: self.layers.clone(),
        }
    }

    /// Memory beside the tensors.
    pub fn bytes_beside_tensors(&self) -> u64 {
        self.levels.bytes() + self.half_table.as_ref().map_or(0, Buffer::bytes)
    }

    /// The last layer, which each head evaluates on its own.
    pub fn head(&self) -> LayerPlace {
        self.layers[self.layers.len() - 1]
    }

    /// Rows of the widest hidden layer.
    pub(crate) fn widest(&self) -> u32 {
        let hidden = &self.layers[..self.layers.len() - 1];
        hidden.iter().map(|layer| layer.columns * 4).max().unwrap_or(0)
    }

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
