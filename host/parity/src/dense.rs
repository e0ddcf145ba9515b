//! The case of `dense`, and the layers of other cases.

use muslin_check::prelude::*;
use organza_shaders::dense::{DenseInputs, DenseParams, HeadParams};

use super::exact::dense::{affine, relu};

/// Where a layer's weights begin: not at 0.
const WEIGHT: u32 = 3;

case!(pub Dense(DenseInputs));

impl Dense {
    /// A layer with filled weights and inputs. The sums of huge numbers stay finite. Rows begin at multiples of four.
    pub fn new(samples: u32, inputs: u32, columns: u32, fill: Fill, random: &mut Random) -> Self {
        let stride = (samples + 5).next_multiple_of(4);
        let bias = WEIGHT + inputs * columns;
        Self(DenseInputs {
            params: DenseParams { samples, stride, inputs, columns, weight: WEIGHT, bias },
            parameters: fill.vectors(random, (bias + columns) as usize, [-1.0, 1.0], 1e15),
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
    pub fn weight(&self, input: u32, output: u32) -> Rounded {
        let at = WEIGHT + input * self.params.columns + output / 4;
        self.parameters[at as usize][output as usize % 4].into()
    }

    /// An input of a sample.
    pub fn value(&self, input: u32, sample: u32) -> Rounded {
        self.at(&self.input, input, sample)
    }

    /// A value of `[rows, stride]`.
    pub fn at(&self, values: &[f32], row: u32, sample: u32) -> Rounded {
        values[(row * self.params.stride + sample) as usize].into()
    }

    /// An output of a sample before the activation (Eq. 2 and 10).
    pub fn sum(&self, sample: u32, output: u32) -> Rounded {
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
}

/// Sets of heads, last layers of one column: inputs of every kind, and logits of all sizes.
pub fn head_sets<S>(new: impl Fn(Dense, Fill, &mut Random) -> S) -> Vec<(String, S)> {
    let mut sets =
        inputs::sets(|n, fill, random| new(Dense::new(n, 16, 1, fill, random), fill, random));
    for size in [0.01, 10.0, 50.0, 1e4] {
        let mut layer = Dense::new(ITEMS, 16, 1, Fill::Random, &mut Random::new(5));
        layer.parameters.iter_mut().for_each(|row| *row = row.abs() * size / 8.0);
        // logits of both signs, whose terms do not cancel
        let stride = layer.params.stride;
        for (at, value) in layer.input.iter_mut().enumerate() {
            let is_negative = (at as u32 % stride).is_multiple_of(2);
            *value = if is_negative { -value.abs() } else { value.abs() };
        }
        sets.push((format!("logits of {size}"), new(layer, Fill::Random, &mut Random::new(6))));
    }
    sets
}

impl Parity for Dense {
    fn sets() -> Vec<(String, Self)> {
        let mut sets = inputs::sets(|n, fill, random| Self::new(n, 19, 8, fill, random));
        for (inputs, columns) in [(1, 4), (64, 4), (150, 8), (3, 16)] {
            let set = Self::new(65, inputs, columns, Fill::Random, &mut Random::new(7));
            sets.push((format!("random, {inputs} inputs, {columns} columns"), set));
        }
        sets
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<Rounded> {
        let (row, sample) = self.place(index)?;
        Some(relu(self.sum(sample, row)))
    }
}
