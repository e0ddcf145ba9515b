//! Cases of `dense_backward`.

use muslin_check::prelude::*;
use organza_shaders::dense::DenseParams;
use organza_shaders::dense_backward::{DenseBackwardInputs, DenseBackwardParams};

use super::dense::Dense;
use super::exact::dense::relu;

// The layer's input has all rows with a wanted gradient. Rows behind the layer's own inputs are zeros.
case!(pub DenseBackward(DenseBackwardInputs) { layer: Dense });

impl DenseBackward {
    /// If the inputs are a hidden layer's outputs, their gradient is wanted from the first one on.
    fn new(
        [samples, inputs, columns]: [u32; 3],
        rectified: bool,
        fill: Fill,
        random: &mut Random,
    ) -> Self {
        let mut layer = Dense::new(samples, inputs, columns, fill, random);
        let DenseParams { stride, weight, .. } = layer.params;
        let (first_input, end_input) = match rectified {
            true => (0, inputs.next_multiple_of(16)),
            false => (inputs / 3, inputs),
        };
        layer.input.resize((end_input * stride) as usize, 0.0);
        let rectified = rectified.into();
        let inputs = DenseBackwardInputs {
            params: DenseBackwardParams {
                samples,
                stride,
                inputs,
                columns,
                weight,
                first_input,
                end_input,
                rectified,
            },
            parameters: layer.parameters.clone(),
            input: layer.input.clone(),
            output_gradient: fill.values(random, layer.output.len(), [-1.0, 1.0], 1e15),
            input_gradient: unwritten((end_input * stride) as usize),
        };
        Self { layer, inputs }
    }
}

impl Parity for DenseBackward {
    fn sets() -> Vec<(String, Self)> {
        let mut sets = inputs::sets(|n, fill, random| Self::new([n, 19, 8], true, fill, random));
        for (inputs, columns, rectified) in [
            (1, 1, false),
            (3, 4, true),
            (8, 16, true),
            (9, 1, false),
            (40, 4, false),
            (64, 1, true),
        ] {
            let random = &mut Random::new(7);
            let set = Self::new([65, inputs, columns], rectified, Fill::Random, random);
            sets.push((format!("random, {inputs} inputs, {columns} columns"), set));
        }
        sets
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<Rounded> {
        let layer = &self.layer;
        let (row, sample) = layer.place(index)?;
        if row < self.params.first_input || row >= self.params.end_input {
            return None;
        }
        if row >= layer.params.inputs {
            return Some(Rounded::exact(0.0));
        }
        // ReLU made an activation of 0 from 0 or less, where its slope is 0; the other inputs only add a constant
        let [slope] = gradient([layer.value(row, sample)], |[x]| {
            let x = if self.params.rectified == 1 { relu(x) } else { x };
            Number::sum((0..4 * layer.params.columns).map(|output| {
                let slope = layer.at(&self.output_gradient, output, sample);
                Dual::constant(layer.weight(row, output) * slope) * x
            }))
        });
        Some(slope)
    }
}
