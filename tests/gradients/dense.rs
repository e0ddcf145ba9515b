//! Layers of Eq. 2 and 10: the gradients of inputs, of weights and of biases.

use glam::Vec4;
use organza::Device;
use organza::parity::inputs::Random;
use organza_shaders::dense_backward::{
    DenseBackwardKernel, DenseBackwardParams, DenseWeightBackwardKernel, DenseWeightBackwardParams,
    DenseWeightSumKernel, DenseWeightSumParams, INPUT_BLOCK, WEIGHT_BLOCK,
};

use super::numeric::{central, everywhere, hold};

/// A layer behind max(x, 0) or not, and dL/d of its outputs: `L = sum g (W x + b)`.
struct Layer {
    samples: u32,
    stride: u32,
    inputs: u32,
    columns: u32,
    rectified: bool,
    /// Inputs before the activation, `[inputs, stride]`.
    before: Vec<f32>,
    /// Packed: weights, then biases.
    parameters: Vec<Vec4>,
    /// `[4 columns, stride]`
    gradient: Vec<f32>,
}

impl Layer {
    fn new(samples: u32, inputs: u32, outputs: u32, rectified: bool) -> Self {
        let mut random = Random::new(u64::from(inputs + outputs));
        let (stride, columns) = (samples + 3, outputs.div_ceil(4));
        let mut before = random.values((inputs * stride) as usize, -1.0, 1.0);
        // none at the kink, which has no derivative
        before.iter_mut().for_each(|x| *x += 0.01_f32.copysign(*x));
        let mut parameters = Vec::new();
        for _ in 0..=inputs {
            let mut row = random.values(4 * columns as usize, -1.0, 1.0);
            row[outputs as usize..].fill(0.0);
            parameters.extend(row.chunks(4).map(Vec4::from_slice));
        }
        let mut gradient = random.values((4 * columns * stride) as usize, -1.0, 1.0);
        gradient[(outputs * stride) as usize..].fill(0.0);
        Self { samples, stride, inputs, columns, rectified, before, parameters, gradient }
    }

    fn activation(&self, x: f64) -> f64 {
        if self.rectified { x.max(0.0) } else { x }
    }

    /// What the layer reads; the rows that pad it up to a block of 16 are zeros.
    fn input(&self) -> Vec<f32> {
        let mut input: Vec<_> =
            self.before.iter().map(|&x| self.activation(f64::from(x)) as f32).collect();
        input.resize((self.end() * self.stride) as usize, 0.0);
        input
    }

    fn end(&self) -> u32 {
        if self.rectified { self.inputs.next_multiple_of(16) } else { self.inputs }
    }

    /// The loss of a sample, of its inputs and all parameters.
    fn loss(&self, sample: usize, before: &[f64], parameters: &[f64]) -> f64 {
        let outputs = 4 * self.columns as usize;
        let weight = |input: usize, output: usize| parameters[input * outputs + output];
        (0..outputs)
            .map(|output| {
                let products =
                    before.iter().enumerate().map(|(i, &x)| weight(i, output) * self.activation(x));
                let y = weight(before.len(), output) + products.sum::<f64>();
                y * f64::from(self.gradient[output * self.stride as usize + sample])
            })
            .sum()
    }

    fn column(&self, sample: usize) -> Vec<f64> {
        let rows = self.before.chunks(self.stride as usize);
        rows.map(|row| f64::from(row[sample])).collect()
    }

    fn parameters(&self) -> Vec<f64> {
        self.parameters.iter().flat_map(|v| v.to_array().map(f64::from)).collect()
    }

    /// `[samples, inputs - first]` of the kernel.
    fn inputs_backward(&self, device: &Device, first: u32) -> Vec<f32> {
        let end = self.end();
        let found = device.zeros::<f32>("input gradient", (end * self.stride) as usize).unwrap();
        let kernel = DenseBackwardKernel {
            params: DenseBackwardParams {
                samples: self.samples,
                stride: self.stride,
                inputs: self.inputs,
                columns: self.columns,
                weight: 0,
                first_input: first,
                end_input: end,
                rectified: u32::from(self.rectified),
            },
            parameters: &device.upload("parameters", &self.parameters).unwrap(),
            input: &device.upload("input", &self.input()).unwrap(),
            output_gradient: &device.upload("gradient", &self.gradient).unwrap(),
            input_gradient: &found,
        };
        device.run(&kernel, self.samples, (end - first).div_ceil(INPUT_BLOCK)).unwrap();
        let found = device.read(&found).unwrap();
        let at = |row: u32, sample: u32| found[(row * self.stride + sample) as usize];
        assert!((self.inputs..end).all(|row| (0..self.samples).all(|s| at(row, s) == 0.0)));
        assert!((0..first).all(|row| (0..self.samples).all(|s| at(row, s) == 0.0)));
        (0..self.samples).flat_map(|s| (first..self.inputs).map(move |row| at(row, s))).collect()
    }

    /// The gradient of the parameters, added to what `gradient` holds.
    fn parameters_backward(&self, device: &Device, slice: u32, times: u32) -> Vec<f32> {
        let parameters = self.parameters.len() as u32;
        let slices = self.samples.div_ceil(slice);
        let partial = device.zeros::<Vec4>("partial", (slices * parameters) as usize).unwrap();
        let gradient = device.zeros::<Vec4>("gradient", parameters as usize).unwrap();
        let kernel = DenseWeightBackwardKernel {
            params: DenseWeightBackwardParams {
                samples: self.samples,
                stride: self.stride,
                inputs: self.inputs,
                columns: self.columns,
                weight: 0,
                bias: self.inputs * self.columns,
                slice,
                first_slice: 0,
                parameters,
            },
            input: &device.upload("input", &self.input()).unwrap(),
            output_gradient: &device.upload("gradient", &self.gradient).unwrap(),
            partial: &partial,
        };
        let blocks = self.inputs.div_ceil(WEIGHT_BLOCK) + 1;
        device.run(&kernel, blocks * self.columns, slices).unwrap();
        for _ in 0..times {
            let kernel = DenseWeightSumKernel {
                params: DenseWeightSumParams { parameters, slices },
                partial: &partial,
                gradient: &gradient,
            };
            device.run(&kernel, parameters, 1).unwrap();
        }
        device.read(&gradient).unwrap().iter().flat_map(Vec4::to_array).collect()
    }
}

/// Layers with and without tails, in their inputs, outputs and samples.
fn layers() -> Vec<Layer> {
    let sizes = [(1, 1, 1), (5, 3, 2), (64, 8, 8), (67, 19, 16), (33, 40, 64), (130, 64, 1)];
    let layer = |(samples, inputs, outputs)| {
        [false, true].map(|rectified| Layer::new(samples, inputs, outputs, rectified))
    };
    sizes.into_iter().flat_map(layer).collect()
}

#[test]
fn inputs_of_a_layer() {
    for (name, device) in everywhere() {
        for layer in layers() {
            let parameters = layer.parameters();
            for first in if layer.rectified { vec![0] } else { vec![0, layer.inputs / 2] } {
                let of_sample = |sample: u32| {
                    let loss = |before: &[f64]| layer.loss(sample as usize, before, &parameters);
                    central(&layer.column(sample as usize), 1e-4, loss).split_off(first as usize)
                };
                let expected: Vec<_> = (0..layer.samples).flat_map(of_sample).collect();
                let found = layer.inputs_backward(&device, first);
                let (inputs, columns) = (layer.inputs, layer.columns);
                hold(
                    &format!("{name}, {inputs} inputs from {first} on, {columns} columns"),
                    &found,
                    &expected,
                );
            }
        }
    }
}

#[test]
fn weights_and_biases_of_a_layer() {
    for (name, device) in everywhere() {
        for layer in layers() {
            let columns: Vec<_> =
                (0..layer.samples as usize).map(|sample| layer.column(sample)).collect();
            // the loss is linear in the parameters: each sample's derivative is its loss of a unit
            let parameters = layer.parameters();
            let few = parameters.len().min(100);
            let loss = |some: &[f64]| {
                let mut all = parameters.clone();
                all[..few].copy_from_slice(some);
                let of = |(sample, column): (usize, &Vec<f64>)| layer.loss(sample, column, &all);
                columns.iter().enumerate().map(of).sum()
            };
            let mut expected = central(&parameters[..few], 1e-3, loss);
            let outputs = 4 * layer.columns as usize;
            let bias = |output: usize| {
                let row = &layer.gradient[output * layer.stride as usize..];
                row[..layer.samples as usize].iter().map(|&g| f64::from(g)).sum::<f64>()
            };
            let biases: Vec<_> = (0..outputs).map(bias).collect();
            for slice in [4096, 32] {
                let found = layer.parameters_backward(&device, slice, 1);
                let what = format!("{name}, {} inputs, slices of {slice}", layer.inputs);
                hold(&what, &found[..few], &expected);
                hold(&format!("{what}, biases"), &found[found.len() - outputs..], &biases);
            }
            // added, not stored
            expected.iter_mut().for_each(|x| *x *= 2.0);
            let found = layer.parameters_backward(&device, 32, 2);
            hold(&format!("{name}, twice"), &found[..few], &expected);
        }
    }
}

/// Padding takes no gradient, whatever a chunk before has left behind the samples.
#[test]
fn padding_stays_zero() {
    for (_, device) in everywhere() {
        let layer = Layer::new(37, 6, 5, true);
        let found = layer.parameters_backward(&device, 16, 1);
        for row in found.chunks(8) {
            assert_eq!(row[5..], [0.0; 3]);
            assert!(row[..5].iter().all(|&x| x != 0.0));
        }
    }
}
