//! A hash grid and its network on a device: the grid block by block, the network chunk by chunk.

pub mod backward;
pub mod samples;

use std::sync::Mutex;

use organza_shaders::dense::{DenseKernel, DenseParams, HeadParams};
use organza_shaders::hash_grid::{HashGridKernel, HashGridParams};
use organza_shaders::hash_grid_half::HashGridHalfKernel;

use self::samples::{Blocks, Chunks, Layout, ROWS_OF_POINT};
use crate::scene::field::DeviceField;
use muslin_device::{Buffer, Device, Result};

/// The inputs of a field.
#[derive(Clone, Copy)]
pub struct Inputs<'a> {
    pub blocks: &'a Blocks,
    /// The first row of the grid's features in the network's input.
    pub grid_row: u32,
    /// Writes a chunk's points, and its input rows that do not come from the grid.
    pub others: &'a (dyn Fn(&Chunks<'_>) -> Result<()> + Sync),
}

impl DeviceField {
    /// Writes the network's input in all blocks, and calls `head` with the last hidden layer's activations of each chunk.
    pub fn forward(
        &self,
        device: &Device,
        inputs: Inputs<'_>,
        head: impl Fn(&Buffer<f32>, &Chunks<'_>) -> Result<()> + Sync,
    ) -> Result<()> {
        let scratches = Mutex::default();
        let new = || self.activations(device, inputs.blocks.layout, 2);
        for block in inputs.blocks.iter() {
            self.encode(device, inputs, &block)?;
            device.parallel_for_with(block.chunks(), &scratches, new, |scratch, chunk| {
                head(&self.hidden(device, scratch, &chunk)?, &chunk)
            })?;
        }
        Ok(())
    }

    /// Writes a block's points and the network's input.
    fn encode(&self, device: &Device, inputs: Inputs<'_>, block: &Chunks<'_>) -> Result<()> {
        device.parallel_for(block.chunks(), |chunk| (inputs.others)(&chunk))?;
        block.spans().try_for_each(|span| {
            let params = self.grid_params(&span, inputs.grid_row);
            let position = &span.point();
            let output = &span.input();
            let levels = &self.levels;
            match &self.half_table {
                None => {
                    let table = &self.table;
                    let kernel = HashGridKernel { params, levels, table, position, output };
                    device.run_all(&kernel.counted(&span.count()))
                }
                Some(table) => {
                    let kernel = HashGridHalfKernel { params, levels, table, position, output };
                    device.run_all(&kernel.counted(&span.count()))
                }
            }
        })
    }

    /// The hash grid's parameters for a span of chunks. The features' first row is `first_row`.
    fn grid_params(&self, span: &Chunks<'_>, first_row: u32) -> HashGridParams {
        HashGridParams {
            points: span.samples(),
            stride: span.stride(),
            first_row,
            features: self.features,
            chunk: span.all.layout.chunk,
            point_rows: ROWS_OF_POINT,
            rows: span.all.rows,
        }
    }

    /// The last layer's parameters, for a chunk of samples.
    pub fn head_params(&self, chunk: &Chunks<'_>) -> HeadParams {
        let head = self.head();
        HeadParams {
            samples: chunk.samples(),
            first: chunk.first(),
            stride: chunk.stride(),
            inputs: head.inputs,
            weight: head.weight,
            bias: head.bias,
        }
    }

    /// Buffers for a chunk's activations in some hidden layers, `[rows, stride]` each.
    fn activations(
        &self,
        device: &Device,
        layout: Layout,
        layers: usize,
    ) -> Result<Vec<Buffer<f32>>> {
        let len = self.widest() as usize * layout.stride as usize;
        (0..layers).map(|_| device.unwritten("activations", len)).collect()
    }

    /// Runs the hidden layers on a chunk's input. Layers write to the `activations` in turn. Returns the last layer's output.
    fn hidden(
        &self,
        device: &Device,
        activations: &[Buffer<f32>],
        chunk: &Chunks<'_>,
    ) -> Result<Buffer<f32>> {
        let mut input = chunk.input();
        for (index, layer) in self.hidden_layers().iter().enumerate() {
            let output = &activations[index % activations.len()];
            let params = DenseParams {
                samples: chunk.samples(),
                stride: chunk.stride(),
                inputs: layer.inputs,
                columns: layer.columns,
                weight: layer.weight,
                bias: layer.bias,
            };
            let parameters = &self.parameters;
            let kernel = DenseKernel { params, parameters, input: &input, output };
            device.run_all(&kernel.counted(&chunk.count()))?;
            input = output.clone();
        }
        Ok(input)
    }
}
