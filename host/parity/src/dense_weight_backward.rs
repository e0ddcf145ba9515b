//! Cases of `dense_weight_backward`.

use std::ops::Range;

use muslin_check::prelude::*;
use organza_shaders::dense::DenseParams;
use organza_shaders::dense_weight_backward::DenseWeightBackwardInputs;
use organza_shaders::weight_slice::DenseWeightBackwardParams;

use super::binned::{read_sums, write_sums};
use super::dense::Dense;

/// Words of a camera's mask.
const WORDS: u32 = 2;

case!(pub DenseWeightBackward(DenseWeightBackwardInputs) {
    /// Its parameters are not read.
    layer: Dense,
    /// Where the samples of each camera begin, and where the last ones end.
    first: Vec<u32>,
    /// `[4 parameters]`: the sums of other chunks.
    before: Vec<f32>,
});

impl DenseWeightBackward {
    fn new(
        [samples, inputs, columns]: [u32; 3],
        first: Vec<u32>,
        [slice, first_sample]: [u32; 2],
        fill: Fill,
        random: &mut Random,
    ) -> Self {
        let layer = Dense::new(samples, inputs, columns, fill, random);
        let output_gradient = fill.values(random, layer.output.len(), [-1.0, 1.0], 1e15);
        let parameters = layer.parameters.len();
        let carry = fill.values(random, 2 * 4 * parameters, [-1.0, 1.0], 1e15);
        let before = fill.values(random, 4 * parameters, [-1.0, 1.0], 1e15);
        let turn = random.below(2);
        let of_rays = random.below(2);
        // the pairs of a camera are its rays, of one sample each, or there is one pair for each camera
        let pair = |camera: u32| if of_rays == 1 { camera } else { first[camera as usize] };
        let cameras = first.len() as u32 - 1;
        let DenseParams { stride, weight, bias, .. } = layer.params;
        let inputs = DenseWeightBackwardInputs {
            params: DenseWeightBackwardParams {
                samples,
                first_sample,
                stride,
                inputs,
                columns,
                weight,
                bias,
                cameras,
                words: WORDS,
                of_rays,
                slice,
                parameters: parameters as u32,
                turn,
            },
            first_pair: (0..=WORDS * cameras).map(|word| pair(word / WORDS)).collect(),
            first_sample: if of_rays == 1 { first.clone() } else { vec![0] },
            input: layer.input.clone(),
            output_gradient,
            carry,
            sum: write_sums(&before),
        };
        Self { layer, first, before, inputs }
    }

    fn chunk(&self) -> Range<u32> {
        let first = self.params.first_sample;
        first..first + self.layer.params.samples
    }

    /// The samples of the slices that end in the chunk, or of the slice that goes on behind it.
    fn slices(&self, are_whole: bool) -> impl Iterator<Item = Range<u32>> {
        let cameras = self.first.windows(2).flat_map(move |camera| {
            let starts = (camera[0]..camera[1]).step_by(self.params.slice as usize);
            starts.map(move |start| start..camera[1].min(start + self.params.slice))
        });
        let chunk = self.chunk();
        cameras.filter(move |slice| {
            let has_samples = slice.end > chunk.start && slice.start < chunk.end;
            has_samples && (slice.end <= chunk.end) == are_whole
        })
    }

    /// Input and output of a parameter, by the number of its value. A bias has the number of inputs as its input.
    fn place(&self, value: usize) -> Option<(u32, u32)> {
        let layer = &self.layer;
        let place = (value as u32 / 4).checked_sub(layer.params.weight)?;
        Some((place / layer.params.columns, 4 * (place % layer.params.columns) + value as u32 % 4))
    }

    /// A parameter's sum over a slice: the samples in the chunk, and the carry of the chunk before.
    fn sum(&self, slice: &Range<u32>, value: usize) -> Rounded {
        let Some((input, row)) = self.place(value) else { return Rounded::exact(0.0) };
        let chunk = self.chunk();
        let samples = slice.start.max(chunk.start)..slice.end.min(chunk.end);
        let term = |sample: u32| {
            let sample = sample - chunk.start;
            let slope = self.layer.at(&self.output_gradient, row, sample);
            if input == self.layer.params.inputs {
                slope
            } else {
                self.layer.value(input, sample) * slope
            }
        };
        let from = self.params.turn as usize * self.before.len() + value;
        let before = if slice.start < chunk.start { self.carry[from] } else { 0.0 };
        Number::sum(samples.map(term).chain([before.into()]))
    }
}

impl Parity for DenseWeightBackward {
    fn sets() -> Vec<(String, Self)> {
        let mut sets = inputs::sets(|n, fill, random| {
            Self::new([n, 6, 2], vec![0, n], [100, 0], fill, random)
        });
        // the last two have more than one tile; the biases of 32 inputs need invocations of their own
        for (inputs, columns, slice) in [
            (1, 1, 4096),
            (4, 3, 16),
            (5, 2, 1),
            (32, 8, 70),
            (7, 16, 33),
            (64, 1, 300),
            (194, 1, 64),
            (67, 17, 100),
        ] {
            let sizes = [300, inputs, columns];
            let random = &mut Random::new(11);
            let set = Self::new(sizes, vec![0, 300], [slice, 0], Fill::Random, random);
            let name = format!("random, {inputs} inputs, {columns} columns, slices of {slice}");
            sets.push((name, set));
        }
        let random = &mut Random::new(17);
        let mut padded = Self::new([37, 6, 2], vec![0, 37], [16, 0], Fill::Random, random);
        let padding = 5 * padded.inputs.params.stride as usize;
        padded.inputs.output_gradient[padding..].fill(0.0);
        sets.push(("three of eight outputs are padding".into(), padded));
        // the chunk begins in a slice, and ends in another one; a camera in it is empty
        for (name, fill, inputs, columns) in [
            ("random", Fill::Random, 6, 2),
            ("mixed", Fill::Mixed, 6, 2),
            ("several tiles", Fill::Random, 66, 9),
        ] {
            for [first_sample, slice] in [[70, 33], [70, 4096], [50, 1], [0, 7]] {
                let first = vec![0, 50, 131, 131, 131, 200, 420];
                let sizes = [300, inputs, columns];
                let random = &mut Random::new(19);
                let set = Self::new(sizes, first, [slice, first_sample], fill, random);
                sets.push((format!("{name}, slices of {slice}, from {first_sample} on"), set));
            }
        }
        sets
    }

    fn convert(&self, mut outputs: Vec<Output>) -> Vec<Output> {
        outputs[1] = Output::float("sum", read_sums(&outputs[1].words(), self.before.len()));
        outputs
    }

    /// A parameter's derivative is the sum of its factors. Slices are added exactly.
    fn exact_at(&self, output: &str, index: usize) -> Option<Rounded> {
        let values = self.before.len();
        if output == "sum" {
            let before = f64::from(self.before[index]);
            // a sum that a GPU may flush is not added
            let before = if before.abs() < f64::from(TINY) { 0.0 } else { before };
            // f64 rounds them, too
            let before = Rounded::within(before, 1e-15 * before.abs());
            return Some(self.slices(true).fold(before, |sum, slice| {
                let slice = self.sum(&slice, index);
                let error = sum.error + slice.error + 1e-14 * slice.terms;
                Rounded::within(sum.value + slice.value, error)
            }));
        }
        let value = index % values;
        let is_own = index / values != self.params.turn as usize && self.place(value).is_some();
        // the slice that goes on behind the chunk
        Some(match self.slices(false).next().filter(|_| is_own) {
            Some(slice) => self.sum(&slice, value),
            None => Rounded::exact(f64::from(*self.carry.get(index)?)),
        })
    }
}
