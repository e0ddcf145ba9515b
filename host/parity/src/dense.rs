//! The case of `dense`, and the layers of other cases.

use glam::Vec4;
use muslin_check::prelude::*;
use organza_shaders::dense::{DenseInputs, DenseParams, HeadParams, OUTPUTS_PER_INVOCATION};

use super::exact::dense::{affine, relu};

/// Where a layer's weights begin: not at 0.
const WEIGHT: u32 = 3;

case!(pub Dense(DenseInputs));

impl Dense {
    /// A layer whose weights and inputs are filled; `huge` ones leave their sums finite. Rows begin at multiples of four.
    pub fn new(samples: u32, inputs: u32, columns: u32, fill: Fill, random: &mut Random) -> Self {
        let stride = (samples + 5).next_multiple_of(4);
        let bias = WEIGHT + inputs * columns;
        let numbers = fill.values(random, 4 * (bias + columns) as usize, [-1.0, 1.0], 1e15);
        Self(DenseInputs {
            params: DenseParams { samples, stride, inputs, columns, weight: WEIGHT, bias },
            parameters: numbers.chunks_exact(4).map(Vec4::from_slice).collect(),
            input: fill.values(random, (inputs * stride) as usize, [-1.0, 1.0], 1e15),
            output: unwritten((4 * columns * stride) as usize),
        })
    }

    /// The layer as a network's last one, for a chunk of samples that begins at `first`.
    pub fn head_params(&self, first: u32) -> HeadParams {
        let DenseParams { samples, stride, inputs, weight, bias, .. } = self.params;
        HeadParams { samples, first, stride, inputs, weight, bias }
    }

    /// Weight of an input in an output, or the output's bias behind the last input.
    pub fn weight(&self, input: u32, output: u32) -> f64 {
        let at = WEIGHT + input * self.params.columns + output / 4;
        f64::from(self.parameters[at as usize][output as usize % 4])
    }

    /// An input of a sample.
    pub fn value(&self, input: u32, sample: u32) -> f64 {
        self.at(&self.input, input, sample)
    }

    /// A value of `[rows, stride]`.
    pub fn at(&self, values: &[f32], row: u32, sample: u32) -> f64 {
        f64::from(values[(row * self.params.stride + sample) as usize])
    }

    /// An output of a sample before the activation, in f64 (Eq. 2 and 10).
    pub fn sum(&self, sample: u32, output: u32) -> f64 {
        let inputs = 0..self.params.inputs;
        let (weights, values): (Vec<_>, Vec<_>) =
            inputs.map(|i| (self.weight(i, output), self.value(i, sample))).unzip();
        affine(&weights, self.weight(self.params.inputs, output), &values)
    }

    /// Row and sample of an element of `[rows, stride]`; `None` for padding.
    pub fn place(&self, index: usize) -> Option<(u32, u32)> {
        let row = index as u32 / self.params.stride;
        let sample = index as u32 % self.params.stride;
        (sample < self.params.samples).then_some((row, sample))
    }

    /// As [`Dense::place`], for the output of a hidden layer.
    fn output(&self, index: usize) -> Option<(u32, u32)> {
        self.place(index).filter(|&(row, _)| row < 4 * self.params.columns)
    }

    /// How far a sum may be off: the sum of its terms' sizes, and the most that denormals can add.
    pub fn sum_bound(&self, sample: u32, output: u32) -> Bound {
        let mut scale = self.weight(self.params.inputs, output).abs();
        let mut reach = 1.0;
        for input in 0..self.params.inputs {
            let w = self.weight(input, output).abs();
            let x = self.value(input, sample).abs();
            scale += w * x;
            reach += w + x + 1.0;
        }
        Bound { scale, floor: reach * f64::from(TINY) }
    }
}

impl Parity for Dense {
    const KERNEL: &'static str = "dense";
    const TOLERANCE: f64 = 1.2e-7;
    const WHY: &'static str = "a rounding of both devices for each input, of the terms' sizes: drivers may fuse \
        and regroup";

    fn sets() -> Vec<(String, Self)> {
        let mut sets = inputs::sets(|n, fill, random| Self::new(n, 19, 8, fill, random));
        for (inputs, columns) in [(1, 4), (64, 4), (150, 8), (3, 16)] {
            let set = Self::new(65, inputs, columns, Fill::Random, &mut Random::new(7));
            sets.push((format!("random, {inputs} inputs, {columns} columns"), set));
        }
        sets
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let invocations = self.params.columns * 4 / OUTPUTS_PER_INVOCATION;
        runner.run(&self.kernel(), self.params.samples, invocations)
    }

    fn bound(&self, _: &Output, index: usize, _: Rounding) -> Bound {
        let Some((row, sample)) = self.output(index) else { return Bound::EXACT };
        let Bound { scale, floor } = self.sum_bound(sample, row);
        Bound { scale: scale * f64::from(self.params.inputs + 1), floor }
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<f64> {
        let (row, sample) = self.output(index)?;
        Some(relu(self.sum(sample, row)))
    }
}
