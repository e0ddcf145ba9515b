//! The case of `dense`, and the sum that both heads share with it.

use glam::Vec4;
use muslin_check::prelude::*;
use organza_shaders::dense::{DenseKernel, DenseParams, OUTPUTS_PER_INVOCATION};

use super::exact::dense::{affine, relu};

/// Where a layer's weights begin: not at 0.
const WEIGHT: u32 = 3;

/// A layer and the samples it is evaluated for.
#[derive(Clone, Debug)]
pub struct Layer {
    /// Samples.
    pub samples: u32,
    /// Distance of two rows of `input`.
    pub stride: u32,
    /// Inputs.
    pub inputs: u32,
    /// Columns of four outputs.
    pub columns: u32,
    /// Weights from 3 on, then biases.
    pub parameters: Vec<Vec4>,
    /// `[inputs, stride]`
    pub input: Vec<f32>,
}

impl Layer {
    /// A layer whose weights and inputs are filled; `huge` ones leave their sums finite.
    pub fn new(samples: u32, inputs: u32, columns: u32, fill: Fill, random: &mut Random) -> Self {
        let stride = (samples + 5).next_multiple_of(4);
        Self::with_stride(samples, stride, inputs, columns, fill, random)
    }

    /// As [`new`](Self::new), with another distance of rows.
    pub fn with_stride(
        samples: u32,
        stride: u32,
        inputs: u32,
        columns: u32,
        fill: Fill,
        random: &mut Random,
    ) -> Self {
        let numbers = 4 * (WEIGHT + (inputs + 1) * columns) as usize;
        let parameters = fill.values(random, numbers, [-1.0, 1.0], 1e15);
        let input = fill.values(random, (inputs * stride) as usize, [-1.0, 1.0], 1e15);
        let (vectors, _) = parameters.as_chunks::<4>();
        let parameters = vectors.iter().copied().map(Vec4::from_array).collect();
        Self { samples, stride, inputs, columns, parameters, input }
    }

    /// As the kernels take it.
    pub fn params(&self) -> DenseParams {
        DenseParams {
            samples: self.samples,
            stride: self.stride,
            inputs: self.inputs,
            columns: self.columns,
            weight: WEIGHT,
            bias: WEIGHT + self.inputs * self.columns,
        }
    }

    /// Weight of an input in an output.
    pub fn weight(&self, input: u32, output: u32) -> f64 {
        let at = WEIGHT + input * self.columns + output / 4;
        f64::from(self.parameters[at as usize][output as usize % 4])
    }

    /// Bias of an output.
    pub fn bias(&self, output: u32) -> f64 {
        self.weight(self.inputs, output)
    }

    /// An input of a sample.
    pub fn value(&self, input: u32, sample: u32) -> f64 {
        f64::from(self.input[(input * self.stride + sample) as usize])
    }

    /// An output of a sample before the activation, in f64 (Eq. 2 and 10).
    pub fn exact(&self, sample: u32, output: u32) -> f64 {
        let inputs = 0..self.inputs;
        let (weights, values): (Vec<_>, Vec<_>) =
            inputs.map(|i| (self.weight(i, output), self.value(i, sample))).unzip();
        affine(&weights, self.bias(output), &values)
    }

    /// Row and sample of an element of `[rows, stride]`; `None` for padding.
    pub fn place(&self, index: usize) -> Option<(u32, u32)> {
        let row = index as u32 / self.stride;
        let sample = index as u32 % self.stride;
        (sample < self.samples).then_some((row, sample))
    }

    /// As [`Layer::place`], for the output of a hidden layer.
    pub fn output(&self, index: usize) -> Option<(u32, u32)> {
        self.place(index).filter(|&(row, _)| row < 4 * self.columns)
    }

    /// How far a sum may be off: the sum of its terms' sizes, and the most that denormals can add.
    pub fn bound(&self, sample: u32, output: u32) -> Bound {
        let mut scale = self.bias(output).abs();
        let mut reach = 1.0;
        for input in 0..self.inputs {
            let w = self.weight(input, output).abs();
            let x = self.value(input, sample).abs();
            scale += w * x;
            reach += w + x + 1.0;
        }
        Bound { scale, floor: reach * f64::from(TINY) }
    }
}

/// Inputs of `dense`.
#[derive(Clone, Debug)]
pub struct Dense {
    /// The layer; its columns are a multiple of four.
    pub layer: Layer,
}

impl Parity for Dense {
    const KERNEL: &'static str = "dense";
    const TOLERANCE: f64 = 1.2e-7;
    const WHY: &'static str = "a rounding of both devices for each input, of the terms' sizes: drivers may fuse \
        and regroup";

    fn sets() -> Vec<(String, Self)> {
        let mut sets =
            inputs::sets(|n, fill, random| Self { layer: Layer::new(n, 19, 8, fill, random) });
        for (inputs, columns) in [(1, 4), (64, 4), (150, 8), (3, 16)] {
            let layer = Layer::new(65, inputs, columns, Fill::Random, &mut Random::new(7));
            sets.push((format!("random, {inputs} inputs, {columns} columns"), Self { layer }));
        }
        sets
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let layer = &self.layer;
        let kernel = DenseKernel {
            params: layer.params(),
            parameters: &layer.parameters,
            input: &layer.input,
            output: &unwritten((4 * layer.columns * layer.stride) as usize),
        };
        runner.run(&kernel, layer.samples, layer.columns * 4 / OUTPUTS_PER_INVOCATION)
    }

    fn bound(&self, _: &Output, index: usize, _: Rounding) -> Bound {
        let Some((row, sample)) = self.layer.output(index) else {
            return Bound::EXACT;
        };
        let Bound { scale, floor } = self.layer.bound(sample, row);
        Bound { scale: scale * f64::from(self.layer.inputs + 1), floor }
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<f64> {
        let (row, sample) = self.layer.output(index)?;
        Some(relu(self.layer.exact(sample, row)))
    }
}
