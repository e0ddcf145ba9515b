//! The derivatives of a field: chunk by chunk, from its network's output back to its parameters and inputs.

use glam::Vec4;
use organza_kernels::dense_backward::{
    DenseBackwardKernel, DenseBackwardParams, DenseWeightBackwardKernel, DenseWeightBackwardParams,
    DenseWeightSumKernel, DenseWeightSumParams, INPUT_BLOCK, WEIGHT_BLOCK,
};
use organza_kernels::hash_grid::POINT_ROWS;
use organza_kernels::limits::{MAX_SLICE, MAX_SLICES};

use super::field::{DeviceField, LayerPlace, Rows, chunks, stride_of};
use super::gradient::FieldGradient;
use crate::backend::{Buffer, Device};
use crate::error::Result;

/// Samples of a chunk on a CPU: activations and gradients of about 300 rows stay in its second cache.
const CPU_CHUNK: u32 = 1 << 11;
/// Samples of a chunk on a GPU.
const GPU_CHUNK: u32 = 1 << 16;
/// Samples of a slice on a GPU: a chunk has enough of them to fill it.
const GPU_SLICE: u32 = 1 << 8;

const _: () = assert!(CPU_CHUNK <= MAX_SLICE && GPU_CHUNK / GPU_SLICE <= MAX_SLICES);

/// What one chunk takes: the activations of all layers, and the gradients.
#[derive(Debug)]
pub struct BackwardScratch {
    /// The points to encode, and what else a stage puts into their last row: `[7, stride]`.
    point: Buffer<f32>,
    /// The network's input, then each hidden layer's output: `[rows, stride]` each.
    activation: Vec<Buffer<f32>>,
    /// Gradient of the network's outputs, which the stage's head writes: `[4, stride]`, and 0 where there is no output.
    pub logit_gradient: Buffer<f32>,
    /// Gradient of the network's input: `[rows, stride]`.
    pub input_gradient: Buffer<f32>,
    /// Gradients of two hidden layers next to each other: `[rows, stride]`.
    hidden_gradient: [Buffer<f32>; 2],
    /// Gradients of the network's parameters, a slice's each: `[slices, parameters]`.
    partial: Buffer<Vec4>,
    pub stride: u32,
    chunk: u32,
    slice: u32,
}

impl BackwardScratch {
    /// Enough for chunks of at most `samples` samples.
    pub fn new(device: &Device, field: &DeviceField, samples: u32) -> Result<Self> {
        let is_cpu_like = device.is_cpu_like();
        let chunk = samples.min(if is_cpu_like { CPU_CHUNK } else { GPU_CHUNK });
        let slice = if is_cpu_like { CPU_CHUNK } else { GPU_SLICE };
        let stride = stride_of(chunk);
        let rows = |label, rows: u32| device.zeros(label, rows as usize * stride as usize);
        let inputs = field.layers[0].inputs;
        let hidden = &field.layers[..field.layers.len() - 1];
        let widest = hidden.iter().map(|layer| layer.columns * 4).max().unwrap_or(0);
        let mut activation = vec![rows("network input", inputs)?];
        for layer in hidden {
            activation.push(rows("activations", layer.columns * 4)?);
        }
        let partial = chunk.div_ceil(slice) as usize * field.parameters.len();
        Ok(Self {
            point: rows("points", POINT_ROWS + 1)?,
            activation,
            logit_gradient: rows("gradient of logits", 4)?,
            input_gradient: rows("gradient of inputs", inputs)?,
            hidden_gradient: [
                rows("gradient of activations", widest)?,
                rows("gradient of activations", widest)?,
            ],
            partial: device.zeros("gradients of slices", partial)?,
            stride,
            chunk,
            slice,
        })
    }

    /// What the network reads.
    pub fn rows(&self) -> Rows<'_> {
        Rows { point: &self.point, input: &self.activation[0], stride: self.stride }
    }

    /// The last hidden layer's output.
    pub fn last_hidden(&self) -> &Buffer<f32> {
        &self.activation[self.activation.len() - 1]
    }

    /// The chunks of `samples` samples: first and count.
    pub fn chunks(&self, samples: u32) -> impl Iterator<Item = (u32, u32)> + use<> {
        chunks(self.chunk, samples)
    }
}

impl DeviceField {
    /// Computes the features of a chunk's points, from a row of the input on, and the hidden layers' activations.
    pub fn activate(
        &self,
        device: &Device,
        scratch: &BackwardScratch,
        samples: u32,
        grid_row: u32,
    ) -> Result<()> {
        let stride = scratch.stride;
        self.encode(device, scratch.rows(), samples, grid_row)?;
        let hidden = &self.layers[..self.layers.len() - 1];
        for (layer, pair) in hidden.iter().zip(scratch.activation.windows(2)) {
            self.layer(device, layer, &pair[0], &pair[1], stride, samples)?;
        }
        Ok(())
    }

    /// From `scratch.logit_gradient` back through all layers: adds the gradients of the network's parameters and of the
    /// grid, whose features begin at `grid_row`, and leaves the gradients of the inputs from there on in
    /// `scratch.input_gradient`.
    pub fn backward(
        &self,
        device: &Device,
        scratch: &BackwardScratch,
        samples: u32,
        grid_row: u32,
        gradient: &FieldGradient,
    ) -> Result<()> {
        let mut output = &scratch.logit_gradient;
        for (index, layer) in self.layers.iter().enumerate().rev() {
            let input = &scratch.activation[index];
            self.weights_backward(device, scratch, layer, samples, input, output)?;
            let target = match index {
                0 => &scratch.input_gradient,
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
                    stride: scratch.stride,
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
            device.run(&kernel, samples, (end_input - first_input).div_ceil(INPUT_BLOCK))?;
            output = target;
        }
        let kernel = DenseWeightSumKernel {
            params: DenseWeightSumParams {
                parameters: self.parameters.len() as u32,
                slices: samples.div_ceil(scratch.slice),
            },
            partial: &scratch.partial,
            gradient: &gradient.parameters,
        };
        device.run(&kernel, kernel.params.parameters, 1)?;
        let (points, features) = (&scratch.point, &scratch.input_gradient);
        gradient.table.accumulate(device, self, points, features, grid_row, scratch.stride, samples)
    }

    /// The gradients of a layer's weights and biases in each slice of a chunk.
    fn weights_backward(
        &self,
        device: &Device,
        scratch: &BackwardScratch,
        layer: &LayerPlace,
        samples: u32,
        input: &Buffer<f32>,
        output_gradient: &Buffer<f32>,
    ) -> Result<()> {
        let kernel = DenseWeightBackwardKernel {
            params: DenseWeightBackwardParams {
                samples,
                stride: scratch.stride,
                inputs: layer.inputs,
                columns: layer.columns,
                weight: layer.weight,
                bias: layer.bias,
                slice: scratch.slice,
                parameters: self.parameters.len() as u32,
            },
            input,
            output_gradient,
            partial: &scratch.partial,
        };
        let blocks = layer.inputs.div_ceil(WEIGHT_BLOCK) + 1;
        device.run(&kernel, blocks * layer.columns, samples.div_ceil(scratch.slice))
    }
}
