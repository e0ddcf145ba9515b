//! The derivatives of a field: chunk by chunk from its network's output back to its parameters and inputs, and group by
//! group from there to its hash grid.

use glam::Vec4;
use organza_shaders::dense_backward::{
    DenseBackwardKernel, DenseBackwardParams, DenseWeightBackwardKernel, DenseWeightBackwardParams,
    DenseWeightSumKernel, DenseWeightSumParams, INPUTS_PER_INVOCATION, WEIGHT_ROWS_PER_INVOCATION,
};

use super::block::{BlockOf, Blocks, Chunk, Layout};
use super::field::DeviceField;
use super::gradient::FieldGradient;
use super::network::LayerPlace;
use super::unit::Units;
use organza_device::{Buffer, Device, Result};

/// What going back through a field takes that its chunks share: each writes its own part.
#[derive(Debug)]
pub struct GroupScratch {
    /// Gradients of a group's inputs: `[chunks, rows, stride]`.
    input_gradient: Buffer<f32>,
    /// Gradients of the network's parameters of a group's slices: `[places, parameters]`.
    partial: Buffer<Vec4>,
    places: u32,
    /// Gradients of the network's parameters: `[units, parameters]`.
    unit_sum: Buffer<Vec4>,
    layout: Layout,
    /// Slices with samples in a chunk, or more.
    slices: u32,
    units: Units,
}

impl GroupScratch {
    /// For a field's blocks.
    pub fn new(
        device: &Device,
        field: &DeviceField,
        blocks: &Blocks,
        units: Units,
    ) -> Result<Self> {
        let (layout, parameters) = (blocks.layout(), field.parameters.len());
        let (label, rows) = ("gradient of inputs", field.layers[0].inputs);
        let places = blocks.slices(layout.group, units.count);
        let [of_slices, of_units] = [places, units.count].map(|count| count as usize * parameters);
        Ok(Self {
            input_gradient: layout.room_for_group(device, label, rows)?,
            partial: device.unwritten("gradients of slices", of_slices)?,
            places,
            unit_sum: device.zeros("gradients of units", of_units)?,
            layout,
            slices: blocks.slices(1, units.count),
            units,
        })
    }

    /// Gradients of the network's parameters: `[units, parameters]`.
    pub fn into_unit_sum(self) -> Buffer<Vec4> {
        self.unit_sum
    }

    /// Gradients of a chunk's inputs: `[rows, stride]`.
    pub fn input_gradient(&self, field: &DeviceField, chunk: &Chunk) -> Buffer<f32> {
        self.layout.of_chunk(&self.input_gradient, chunk.index, field.layers[0].inputs)
    }
}

/// What going back through a chunk takes: the activations of its layers and their gradients.
#[derive(Debug)]
pub struct ChunkScratch {
    /// Each hidden layer's output: `[rows, stride]` each.
    activation: Vec<Buffer<f32>>,
    /// Gradient of the network's outputs, which the stage's head writes: `[4, stride]`, and 0 without an output.
    pub logit_gradient: Buffer<f32>,
    /// Gradients of two hidden layers next to each other: `[rows, stride]`.
    hidden_gradient: [Buffer<f32>; 2],
}

impl ChunkScratch {
    /// For chunks of this layout.
    pub fn new(device: &Device, field: &DeviceField, layout: Layout) -> Result<Self> {
        let rows = |label, rows: u32| device.unwritten(label, (rows * layout.stride) as usize);
        let hidden = &field.layers[..field.layers.len() - 1];
        let activation = hidden.iter().map(|layer| rows("activations", layer.columns * 4));
        let label = "gradient of activations";
        Ok(Self {
            activation: activation.collect::<Result<_>>()?,
            // rows that no head writes stay 0
            logit_gradient: device.zeros("gradient of logits", 4 * layout.stride as usize)?,
            hidden_gradient: [rows(label, field.widest())?, rows(label, field.widest())?],
        })
    }

    /// The input of a chunk's last layer.
    pub fn last_hidden<'a>(&'a self, chunk: &'a Chunk) -> &'a Buffer<f32> {
        self.activation.last().unwrap_or(&chunk.input)
    }
}

impl DeviceField {
    /// Computes the hidden layers' activations of a chunk.
    pub fn activate(&self, device: &Device, scratch: &ChunkScratch, chunk: &Chunk) -> Result<()> {
        let mut input = &chunk.input;
        for (layer, output) in self.layers.iter().zip(&scratch.activation) {
            self.layer(device, layer, input, output, chunk)?;
            input = output;
        }
        Ok(())
    }

    /// From `scratch.logit_gradient` back through all layers of a chunk: leaves the gradients of the network's parameters,
    /// and those of its inputs from the row `grid_row` on, where the grid's features begin, in `group`.
    pub fn backward(
        &self,
        device: &Device,
        group: &GroupScratch,
        scratch: &ChunkScratch,
        chunk: &Chunk,
        grid_row: u32,
    ) -> Result<()> {
        let samples = chunk.samples;
        let of_chunk = group.input_gradient(self, chunk);
        let mut output = &scratch.logit_gradient;
        for (index, layer) in self.layers.iter().enumerate().rev() {
            let input =
                index.checked_sub(1).map_or(&chunk.input, |below| &scratch.activation[below]);
            self.weights_backward(device, group, layer, chunk, input, output)?;
            let target = match index {
                0 => &of_chunk,
                _ => &scratch.hidden_gradient[index % 2],
            };
            // the rows of a hidden layer below, its padding included, or the inputs from the grid's on
            let [first_input, end_input] = match index {
                0 => [grid_row, layer.inputs],
                _ => [0, self.layers[index - 1].columns * 4],
            };
            let kernel = DenseBackwardKernel {
                params: DenseBackwardParams {
                    samples,
                    stride: chunk.stride,
                    inputs: layer.inputs,
                    columns: layer.columns,
                    weight: layer.weight,
                    first_input,
                    end_input,
                    rectified: u32::from(index > 0),
                },
                parameters: &self.parameters,
                input,
                output_gradient: output,
                input_gradient: target,
            };
            let layers = (end_input - first_input).div_ceil(INPUTS_PER_INVOCATION);
            device.run(&kernel.counted(&chunk.count), samples, layers)?;
            output = target;
        }
        Ok(())
    }

    /// Adds what [`DeviceField::backward`] has left of a group: the gradients of the network's parameters to the sums of their
    /// units, and those of the hash grid, whose features begin at `grid_row`, to the grid's.
    pub fn group_backward(
        &self,
        device: &Device,
        scratch: &GroupScratch,
        group: &BlockOf<'_>,
        grid_row: u32,
        gradient: &FieldGradient,
    ) -> Result<()> {
        let kernel = DenseWeightSumKernel {
            params: DenseWeightSumParams {
                parameters: self.parameters.len() as u32,
                first_sample: group.first(),
                samples: group.samples(),
                units: scratch.units.count,
                slice: scratch.layout.slice,
                places: scratch.places,
            },
            unit: &scratch.units.begin,
            partial: &scratch.partial,
            unit_sum: &scratch.unit_sum,
        };
        device.run(&kernel.counted(&group.count()), self.parameters.len() as u32, 1)?;
        group.pieces().try_for_each(|piece| {
            let params = self.grid_params(&piece, grid_row);
            let (count, points) = (&piece.count(), &piece.point());
            let (input_gradient, rows) = (&scratch.input_gradient, self.layers[0].inputs);
            let of_piece = scratch.layout.of_chunk(input_gradient, piece.index(), rows);
            gradient.table.accumulate(device, self, params, count, points, &of_piece)
        })
    }

    /// The gradients of a layer's weights and biases in each slice of a chunk.
    fn weights_backward(
        &self,
        device: &Device,
        group: &GroupScratch,
        layer: &LayerPlace,
        chunk: &Chunk,
        input: &Buffer<f32>,
        output_gradient: &Buffer<f32>,
    ) -> Result<()> {
        let kernel = DenseWeightBackwardKernel {
            params: DenseWeightBackwardParams {
                samples: chunk.samples,
                first_sample: chunk.first,
                stride: chunk.stride,
                inputs: layer.inputs,
                columns: layer.columns,
                weight: layer.weight,
                bias: layer.bias,
                units: group.units.count,
                slice: group.layout.slice,
                places: group.places,
                parameters: self.parameters.len() as u32,
            },
            unit: &group.units.begin,
            input,
            output_gradient,
            partial: &group.partial,
        };
        let blocks = layer.inputs.div_ceil(WEIGHT_ROWS_PER_INVOCATION) + 1;
        device.run(&kernel.counted(&chunk.count), blocks * layer.columns, group.slices)
    }
}
