//! The derivatives of a field: chunk by chunk from its network's output back to its parameters and inputs, and group by
//! group from there to its hash grid.

use glam::Vec4;
use organza_shaders::dense_backward::{
    DenseBackwardKernel, DenseBackwardParams, DenseWeightBackwardKernel, DenseWeightBackwardParams,
    DenseWeightSumKernel, DenseWeightSumParams, INPUTS_PER_INVOCATION, WEIGHT_ROWS_PER_INVOCATION,
};
use organza_shaders::limits::{MAX_SLICE, MAX_SLICES};

use super::block::{BlockOf, Chunk, Layout};
use super::field::DeviceField;
use super::gradient::FieldGradient;
use super::network::LayerPlace;
use organza_device::{Buffer, Device, Result};

/// Samples of a slice on a GPU: a chunk has enough of them to fill it.
const GPU_SLICE: u32 = 1 << 8;

/// What going back through a group takes that its chunks share: each writes its own part.
#[derive(Debug)]
pub struct GroupScratch {
    /// Gradients of the inputs: `[chunks, rows, stride]`.
    input_gradient: Buffer<f32>,
    /// Gradients of the network's parameters, a slice's each: `[slices, parameters]`.
    partial: Buffer<Vec4>,
    layout: Layout,
    /// Samples of a slice.
    slice: u32,
}

impl GroupScratch {
    /// For blocks of this layout.
    pub fn new(device: &Device, field: &DeviceField, layout: Layout) -> Result<Self> {
        let slice = if device.is_cpu_like() { layout.chunk } else { GPU_SLICE };
        let slices = layout.group * layout.chunk.div_ceil(slice);
        assert!(slice <= MAX_SLICE && slices <= MAX_SLICES, "{slices} slices of {slice} samples");
        let (label, rows) = ("gradient of inputs", field.layers[0].inputs);
        let partial = slices as usize * field.parameters.len();
        Ok(Self {
            input_gradient: layout.room_for_group(device, label, rows)?,
            partial: device.zeros("gradients of slices", partial)?,
            layout,
            slice,
        })
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

    /// Adds what [`DeviceField::backward`] has left of a group: the gradients of the network's parameters, chunk by chunk
    /// in their order, and those of the hash grid, whose features begin at `grid_row`.
    pub fn group_backward(
        &self,
        device: &Device,
        scratch: &GroupScratch,
        group: BlockOf<'_>,
        grid_row: u32,
        gradient: &FieldGradient,
    ) -> Result<()> {
        let kernel = DenseWeightSumKernel {
            params: DenseWeightSumParams {
                parameters: self.parameters.len() as u32,
                slices: group.samples.div_ceil(scratch.slice),
            },
            partial: &scratch.partial,
            gradient: &gradient.parameters,
        };
        device.run(&kernel, kernel.params.parameters, 1)?;
        let params = self.grid_params(group, grid_row);
        let points = &group.point();
        let count = &group.count();
        gradient.table.accumulate(device, self, params, count, points, &scratch.input_gradient)
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
        // all chunks before are full
        let first_slice = chunk.index * group.layout.chunk.div_ceil(group.slice);
        let kernel = DenseWeightBackwardKernel {
            params: DenseWeightBackwardParams {
                samples: chunk.samples,
                stride: chunk.stride,
                inputs: layer.inputs,
                columns: layer.columns,
                weight: layer.weight,
                bias: layer.bias,
                slice: group.slice,
                first_slice,
                parameters: self.parameters.len() as u32,
            },
            input,
            output_gradient,
            partial: &group.partial,
        };
        let blocks = layer.inputs.div_ceil(WEIGHT_ROWS_PER_INVOCATION) + 1;
        let slices = chunk.samples.div_ceil(group.slice);
        device.run(&kernel.counted(&chunk.count), blocks * layer.columns, slices)
    }
}
