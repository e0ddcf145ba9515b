//! The derivatives of a field: chunk by chunk from its network's output back to its parameters and inputs, and group by
//! group from there to its hash grid.

use organza_shaders::dense_backward::{
    DenseBackwardKernel, DenseBackwardParams, DenseWeightBackwardKernel, DenseWeightBackwardParams,
    INPUTS_PER_INVOCATION, weight_invocations,
};

use super::samples::{BlockOf, Blocks, Chunk, Layout};
use crate::gradient::FieldGradient;
use crate::scene::device_scene::DeviceScene;
use crate::scene::field::DeviceField;
use crate::scene::network::LayerPlace;
use crate::stages::cut::words;
use crate::stages::tiles::Bins;
use muslin_device::{Buffer, Device, Result};

/// Where the samples of a part's cameras begin.
#[derive(Debug)]
pub struct CameraSamples {
    cameras: u32,
    /// Words of a camera's mask.
    words: u32,
    /// `[cameras, words] + 1`
    first_pair: Buffer<u32>,
    /// `[pairs + 1]`: none where pairs are the samples.
    first_sample: Option<Buffer<u32>>,
}

impl CameraSamples {
    /// Those of the color network; with `first_sample [pairs + 1]`, those of the transmittance network.
    pub fn new(scene: &DeviceScene, bins: &Bins, first_sample: Option<&Buffer<u32>>) -> Self {
        Self {
            cameras: bins.cameras.len() as u32,
            words: words(scene.gaussians),
            first_pair: bins.pair_mask.first.view(),
            first_sample: first_sample.map(Buffer::view),
        }
    }
}

/// Memory of a field's backward pass that chunks share: each writes its own part.
#[derive(Debug)]
pub struct GroupScratch {
    /// Gradients of a group's inputs: `[chunks, rows, stride]`.
    input_gradient: Buffer<f32>,
    /// Gradients of the network's parameters, of a slice that ends in another chunk: `[2, 4 parameters]`.
    carry: Buffer<f32>,
    layout: Layout,
    samples: CameraSamples,
}

impl GroupScratch {
    /// For a field's blocks.
    pub fn new(
        device: &Device,
        field: &DeviceField,
        blocks: &Blocks,
        samples: CameraSamples,
    ) -> Result<Self> {
        let layout = blocks.layout();
        let label = "gradient of inputs";
        let rows = field.layers[0].inputs;
        Ok(Self {
            input_gradient: layout.room_for_group(device, label, rows)?,
            carry: device.unwritten("gradients of a slice", 8 * field.parameters.len())?,
            layout,
            samples,
        })
    }

    /// Gradients of a chunk's inputs: `[rows, stride]`.
    pub fn input_gradient(&self, field: &DeviceField, chunk: &Chunk) -> Buffer<f32> {
        self.layout.chunk_view(&self.input_gradient, chunk.index, field.layers[0].inputs)
    }
}

/// Memory of a chunk's backward pass: the activations of its layers and their gradients.
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

    /// From `scratch.logit_gradient` back through all layers of a chunk: adds the gradients of the network's parameters to
    /// their sums, and leaves those of its inputs from the row `grid_row` on, where the grid's features begin, in `group`.
    pub fn backward(
        &self,
        device: &Device,
        group: &GroupScratch,
        scratch: &ChunkScratch,
        chunk: &Chunk,
        grid_row: u32,
        gradient: &FieldGradient,
    ) -> Result<()> {
        let samples = chunk.samples;
        let of_chunk = group.input_gradient(self, chunk);
        let mut output = &scratch.logit_gradient;
        for (index, layer) in self.layers.iter().enumerate().rev() {
            let input =
                index.checked_sub(1).map_or(&chunk.input, |below| &scratch.activation[below]);
            let of_layer = [input, output];
            self.weights_backward(device, group, layer, chunk, of_layer, &gradient.network.sum)?;
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

    /// Adds the gradients of a group's inputs, which [`DeviceField::backward`] has written, to the sums of the hash grid.
    /// The features of the grid begin at `grid_row`.
    pub fn grid_backward(
        &self,
        device: &Device,
        scratch: &GroupScratch,
        group: &BlockOf<'_>,
        grid_row: u32,
        gradient: &FieldGradient,
    ) -> Result<()> {
        group.pieces().try_for_each(|piece| {
            let params = self.grid_params(&piece, grid_row);
            let count = &piece.count();
            let points = &piece.point();
            let input_gradient = &scratch.input_gradient;
            let rows = self.layers[0].inputs;
            let of_piece = scratch.layout.chunk_view(input_gradient, piece.index(), rows);
            gradient.table.accumulate(device, self, params, count, points, &of_piece)
        })
    }

    /// Adds the gradients of a layer's weights and biases.
    fn weights_backward(
        &self,
        device: &Device,
        group: &GroupScratch,
        layer: &LayerPlace,
        chunk: &Chunk,
        [input, output_gradient]: [&Buffer<f32>; 2],
        sum: &Buffer<u32>,
    ) -> Result<()> {
        let CameraSamples { cameras, words, first_pair, first_sample } = &group.samples;
        let Layout { chunk: full, slice, .. } = group.layout;
        let kernel = DenseWeightBackwardKernel {
            params: DenseWeightBackwardParams {
                samples: chunk.samples,
                first_sample: chunk.first,
                stride: chunk.stride,
                inputs: layer.inputs,
                columns: layer.columns,
                weight: layer.weight,
                bias: layer.bias,
                cameras: *cameras,
                words: *words,
                of_rays: u32::from(first_sample.is_some()),
                slice,
                parameters: self.parameters.len() as u32,
                turn: chunk.first / full % 2,
            },
            first_pair,
            // a binding must be bound
            first_sample: first_sample.as_ref().unwrap_or(first_pair),
            input,
            output_gradient,
            carry: &group.carry,
            sum,
        };
        let invocations = weight_invocations(layer.inputs, layer.columns);
        let windows = chunk.samples.div_ceil(slice);
        device.run(&kernel.counted(&chunk.count), invocations, windows)
    }
}
