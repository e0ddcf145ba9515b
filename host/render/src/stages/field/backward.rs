//! The backward pass of a field: chunk by chunk through its network, from outputs to parameters and inputs, then group by
//! group through its hash grid.

use std::sync::Mutex;

use organza_shaders::dense_backward::{DenseBackwardKernel, DenseBackwardParams};
use organza_shaders::dense_weight_backward::DenseWeightBackwardKernel;
use organza_shaders::weight_slice::DenseWeightBackwardParams;

use super::Inputs;
use super::samples::{Chunks, Layout};
use crate::gradient::FieldGradient;
use crate::scene::device_scene::DeviceScene;
use crate::scene::field::DeviceField;
use crate::scene::network::LayerPlace;
use crate::stages::cut::words;
use crate::stages::tiles::TileBins;
use muslin_device::{Buffer, Device, Result};

/// The backward pass of a field: what it reads, and the sums that it adds to.
#[derive(Clone, Copy)]
pub struct FieldBackward<'a> {
    pub scene: &'a DeviceScene,
    pub bins: &'a TileBins,
    pub field: &'a DeviceField,
    pub inputs: Inputs<'a>,
    /// Whether the forward pass has written the inputs of blocks that are kept.
    pub is_encoded: bool,
    /// `[pairs + 1]`: each pair's first sample; `None` if every pair is one sample.
    pub first_sample: Option<&'a Buffer<u32>>,
    pub gradient: &'a FieldGradient,
}

/// Memory that chunks share: each writes its own part.
struct GroupScratch {
    /// Gradients of a group's inputs: `[chunks, rows, stride]`.
    input_gradient: Buffer<f32>,
    /// `[2, 4 parameters]`: partial gradient sums of the network's parameters, for a slice that goes on in the next chunk.
    carry: Buffer<f32>,
}

/// Memory of a chunk: the activations of its layers and their gradients.
pub struct ChunkScratch {
    /// Each hidden layer's output: `[rows, stride]` each.
    activation: Vec<Buffer<f32>>,
    /// `[4, stride]`: gradient of the network's outputs, which the stage's head writes. Rows without an output are 0.
    pub logit_gradient: Buffer<f32>,
    /// `[samples]`: scratch memory of the stage's head.
    pub head_scratch: Buffer<f32>,
    /// Gradients of two adjacent hidden layers: `[rows, stride]`.
    hidden_gradient: [Buffer<f32>; 2],
}

impl ChunkScratch {
    fn new(device: &Device, field: &DeviceField, layout: Layout) -> Result<Self> {
        let stride = layout.stride as usize;
        let hidden =
            || device.unwritten("gradient of activations", field.widest() as usize * stride);
        Ok(Self {
            activation: field.activations(device, layout, field.hidden_layers().len())?,
            // rows that no head writes stay 0
            logit_gradient: device.zeros("gradient of logits", 4 * stride)?,
            head_scratch: device.unwritten("gradient of a head", layout.chunk as usize)?,
            hidden_gradient: [hidden()?, hidden()?],
        })
    }

    /// The input of a chunk's last layer.
    pub fn last_hidden(&self, chunk: &Chunks<'_>) -> Buffer<f32> {
        self.activation.last().map_or_else(|| chunk.input(), Buffer::clone)
    }
}

impl FieldBackward<'_> {
    /// Adds the gradients of the field's tensors to their sums. `head` writes the gradient of a chunk's logits. `after` gets
    /// the gradients of a chunk's inputs, `[rows, stride]`, in the order of the chunks.
    pub fn run(
        self,
        head: impl Fn(&ChunkScratch, &Chunks<'_>) -> Result<()> + Sync,
        after: impl Fn(&Buffer<f32>, &Chunks<'_>) -> Result<()>,
    ) -> Result<()> {
        let Self { field, inputs, .. } = self;
        let device = self.scene.device();
        let layout = inputs.blocks.layout;
        let rows = field.layers[0].inputs;
        let shared = GroupScratch {
            input_gradient: device
                .unwritten("gradient of inputs", layout.begin(layout.group, rows))?,
            carry: device.unwritten("gradients of a slice", 8 * field.parameters.len())?,
        };
        let input_gradient =
            |chunks: &Chunks<'_>| shared.input_gradient.tail(layout.begin(chunks.index(), rows));
        let scratches = Mutex::default();
        let new = || ChunkScratch::new(device, field, layout);
        for block in inputs.blocks.iter() {
            if !(self.is_encoded && block.is_kept) {
                field.encode(device, inputs, &block)?;
            }
            for group in block.groups() {
                device.parallel_for_with(group.chunks(), &scratches, new, |scratch, chunk| {
                    field.hidden(device, &scratch.activation, &chunk)?;
                    head(scratch, &chunk)?;
                    self.layers(scratch, &chunk, &shared.carry, &input_gradient(&chunk))
                })?;
                for chunk in group.chunks() {
                    after(&input_gradient(&chunk), &chunk)?;
                }
                for span in group.spans() {
                    let params = field.grid_params(&span, inputs.grid_row);
                    let points = &span.point();
                    let d_features = &input_gradient(&span);
                    let table = &self.gradient.table;
                    table.accumulate(device, field, params, &span.count(), points, d_features)?;
                }
            }
        }
        Ok(())
    }

    /// Backpropagates `scratch.logit_gradient` through all layers of a chunk. Adds to the gradient sums of the network's
    /// parameters. Writes the gradients of its inputs to `input_gradient`, from the grid's first row on.
    fn layers(
        &self,
        scratch: &ChunkScratch,
        chunk: &Chunks<'_>,
        carry: &Buffer<f32>,
        input_gradient: &Buffer<f32>,
    ) -> Result<()> {
        let device = self.scene.device();
        let field = self.field;
        let mut output = &scratch.logit_gradient;
        for (index, layer) in field.layers.iter().enumerate().rev() {
            let below = index.checked_sub(1).map(|below| &scratch.activation[below]);
            let input = &below.map_or_else(|| chunk.input(), Buffer::clone);
            self.weights(layer, chunk, [input, output], carry)?;
            let target = match index {
                0 => input_gradient,
                _ => &scratch.hidden_gradient[index % 2],
            };
            // all rows of the hidden layer below, padding included; in the first layer, the input rows from the grid's on
            let [first_input, end_input] = match index {
                0 => [self.inputs.grid_row, layer.inputs],
                _ => [0, field.layers[index - 1].columns * 4],
            };
            let kernel = DenseBackwardKernel {
                params: DenseBackwardParams {
                    samples: chunk.samples(),
                    stride: chunk.stride(),
                    inputs: layer.inputs,
                    columns: layer.columns,
                    weight: layer.weight,
                    first_input,
                    end_input,
                    rectified: u32::from(index > 0),
                },
                parameters: &field.parameters,
                input,
                output_gradient: output,
                input_gradient: target,
            };
            device.run_all(&kernel.counted(&chunk.count()))?;
            output = target;
        }
        Ok(())
    }

    /// Adds the gradients of a layer's weights and biases.
    fn weights(
        &self,
        layer: &LayerPlace,
        chunk: &Chunks<'_>,
        [input, output_gradient]: [&Buffer<f32>; 2],
        carry: &Buffer<f32>,
    ) -> Result<()> {
        let Layout { chunk: full, slice, .. } = chunk.all.layout;
        let first_pair = &self.bins.pair_mask.first;
        let kernel = DenseWeightBackwardKernel {
            params: DenseWeightBackwardParams {
                samples: chunk.samples(),
                first_sample: chunk.first(),
                stride: chunk.stride(),
                inputs: layer.inputs,
                columns: layer.columns,
                weight: layer.weight,
                bias: layer.bias,
                cameras: self.bins.cameras.len() as u32,
                words: words(self.scene.gaussians),
                of_rays: u32::from(self.first_sample.is_some()),
                slice,
                parameters: self.field.parameters.len() as u32,
                turn: chunk.first() / full % 2,
            },
            first_pair,
            // every binding needs a buffer, even if the kernel does not read it
            first_sample: self.first_sample.unwrap_or(first_pair),
            input,
            output_gradient,
            carry,
            sum: &self.gradient.network.sum,
        };
        self.scene.device().run_all(&kernel.counted(&chunk.count()))
    }
}
