//! Cases of `dense_backward` and `dense_weight_backward`.

use std::ops::Range;

use muslin_check::prelude::*;
use organza_shaders::dense::DenseParams;
use organza_shaders::dense_backward::{
    DenseBackwardInputs, DenseBackwardParams, DenseWeightBackwardInputs, DenseWeightBackwardParams,
    INPUTS_PER_INVOCATION, weight_invocations,
};

use super::binned::{with_sums, write_sums};
use super::dense::Dense;
use super::exact::dense::{affine, relu};
use super::exact::numeric::{Dual, gradient};

/// How far a sum of products may be off: a rounding for each, of the terms' sizes, and the most that denormals can add.
fn sum_of_products(terms: impl IntoIterator<Item = [f64; 2]>) -> Bound {
    let mut count = 0.0;
    let mut scale = 0.0;
    let mut reach = 1.0;
    for [a, b] in terms {
        count += 1.0;
        scale += (a * b).abs();
        reach += a.abs() + b.abs() + 1.0;
    }
    Bound { scale: scale * (1.0 + count), floor: reach * f64::from(TINY) }
}

/// The layer's input has rows up to the last whose gradient is wanted: those behind its own are zeros.
#[derive(Clone)]
pub struct DenseBackward {
    layer: Dense,
    inputs: DenseBackwardInputs,
}

impl DenseBackward {
    /// If the inputs are a hidden layer's outputs, their gradient is wanted from the first one on.
    fn new(mut layer: Dense, rectified: bool, fill: Fill, random: &mut Random) -> Self {
        let DenseParams { samples, stride, inputs, columns, weight, .. } = layer.params;
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

    fn output_gradient(&self, output: u32, sample: u32) -> f64 {
        self.layer.at(&self.inputs.output_gradient, output, sample)
    }
}

impl Parity for DenseBackward {
    const KERNEL: &'static str = "dense_backward";
    const TOLERANCE: f64 = 1.2e-7;
    const WHY: &'static str = "a rounding of both devices for each output, of the terms' sizes; a denormal activation \
        that may be flushed may pass its gradient on or not";

    fn sets() -> Vec<(String, Self)> {
        let mut sets = inputs::sets(|n, fill, random| {
            let layer = Dense::new(n, 19, 8, fill, random);
            Self::new(layer, true, fill, random)
        });
        for (inputs, columns, rectified) in [
            (1, 1, false),
            (3, 4, true),
            (8, 16, true),
            (9, 1, false),
            (40, 4, false),
            (64, 1, true),
        ] {
            let mut random = Random::new(7);
            let layer = Dense::new(65, inputs, columns, Fill::Random, &mut random);
            let set = Self::new(layer, rectified, Fill::Random, &mut random);
            sets.push((format!("random, {inputs} inputs, {columns} columns"), set));
        }
        sets
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let DenseBackwardParams { samples, first_input, end_input, .. } = self.inputs.params;
        let invocations = (end_input - first_input).div_ceil(INPUTS_PER_INVOCATION);
        runner.run(&self.inputs.kernel(), samples, invocations)
    }

    fn bound(&self, _: &Output, index: usize, _: Rounding) -> Bound {
        let layer = &self.layer;
        let row = index as u32 / layer.params.stride;
        let sample = index as u32 % layer.params.stride;
        let is_written = row >= self.inputs.params.first_input
            && row < layer.params.inputs
            && sample < layer.params.samples;
        if !is_written {
            return Bound::EXACT;
        }
        let outputs = 0..4 * layer.params.columns;
        let bound = sum_of_products(
            outputs.map(|output| [layer.weight(row, output), self.output_gradient(output, sample)]),
        );
        let input = layer.value(row, sample);
        let is_denormal = input > 0.0 && input < f64::from(TINY);
        Bound { floor: bound.floor + if is_denormal { bound.scale } else { 0.0 }, ..bound }
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<f64> {
        let layer = &self.layer;
        // the other inputs only add a constant
        let loss = |input: u32, sample: u32, [x]: [Dual; 1]| {
            let x = if self.inputs.params.rectified == 1 { relu(x) } else { x };
            (0..4 * layer.params.columns).fold(Dual::from(0.0), |loss, output| {
                let y = affine(&[layer.weight(input, output).into()], Dual::from(0.0), &[x]);
                loss + Dual::from(self.output_gradient(output, sample)) * y
            })
        };
        let (row, sample) = layer.place(index)?;
        let is_written =
            row >= self.inputs.params.first_input && row < self.inputs.params.end_input;
        is_written.then(|| {
            if row >= layer.params.inputs {
                return 0.0;
            }
            // ReLU made an activation of 0 from 0 or less, where its slope is 0
            let [slope] = gradient([layer.value(row, sample)], |x| loss(row, sample, x));
            slope
        })
    }
}

/// Words of a camera's mask.
const WORDS: u32 = 2;

/// The layer's parameters are not read.
#[derive(Clone)]
pub struct DenseWeightBackward {
    layer: Dense,
    /// Where the samples of each camera begin, and where the last ones end.
    first: Vec<u32>,
    /// `[4 parameters]`: what other chunks have added.
    before: Vec<f32>,
    inputs: DenseWeightBackwardInputs,
}

impl DenseWeightBackward {
    fn new(
        layer: Dense,
        first: Vec<u32>,
        [slice, first_sample]: [u32; 2],
        fill: Fill,
        random: &mut Random,
    ) -> Self {
        let output_gradient = fill.values(random, layer.output.len(), [-1.0, 1.0], 1e15);
        let parameters = layer.parameters.len();
        let carry = fill.values(random, 2 * 4 * parameters, [-1.0, 1.0], 1e15);
        let before = fill.values(random, 4 * parameters, [-1.0, 1.0], 1e15);
        let turn = random.below(2);
        let of_rays = random.below(2);
        // the pairs of a camera are its rays, of one sample each, or there is one pair for each camera
        let pair = |camera: u32| if of_rays == 1 { camera } else { first[camera as usize] };
        let cameras = first.len() as u32 - 1;
        let DenseParams { samples, stride, inputs, columns, weight, bias } = layer.params;
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

    /// Every slice's samples.
    fn slices(&self) -> Vec<Range<u32>> {
        let of_camera = |range: &[u32]| {
            let [begin, end] = [range[0], range[1]];
            (begin..end)
                .step_by(self.inputs.params.slice as usize)
                .map(move |first| first..end.min(first + self.inputs.params.slice))
        };
        self.first.windows(2).flat_map(of_camera).collect()
    }

    fn chunk(&self) -> Range<u32> {
        let first = self.inputs.params.first_sample;
        first..first + self.layer.params.samples
    }

    /// The slices that end in the chunk, or the one that goes on behind it.
    fn in_chunk(&self, are_whole: bool) -> impl Iterator<Item = Range<u32>> {
        let chunk = self.chunk();
        self.slices().into_iter().filter(move |slice| {
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

    /// The factors of a parameter's sum over a slice: those of its samples in the chunk, and what the chunk before has left.
    fn terms(&self, slice: &Range<u32>, value: usize) -> Vec<[f64; 2]> {
        let Some((input, row)) = self.place(value) else { return Vec::new() };
        let chunk = self.chunk();
        let samples = slice.start.max(chunk.start)..slice.end.min(chunk.end);
        let term = |sample: u32| {
            let sample = sample - chunk.start;
            let is_bias = input == self.layer.params.inputs;
            let x = if is_bias { 1.0 } else { self.layer.value(input, sample) };
            [x, self.layer.at(&self.inputs.output_gradient, row, sample)]
        };
        let from = self.inputs.params.turn as usize * self.before.len() + value;
        let before = if slice.start < chunk.start { self.inputs.carry[from] } else { 0.0 };
        samples.map(term).chain([[f64::from(before), 1.0]]).collect()
    }

    /// The slices that are added to a value of an output, the parameter's value, and what was there before.
    fn slices_added(&self, output: &str, index: usize) -> Option<(Vec<Range<u32>>, usize, f64)> {
        let values = self.before.len();
        if output == "sum" {
            let before = f64::from(*self.before.get(index)?);
            // what a GPU may flush is not added
            let before = if before.abs() < f64::from(TINY) { 0.0 } else { before };
            return Some((self.in_chunk(true).collect(), index, before));
        }
        let before = f64::from(*self.inputs.carry.get(index)?);
        let half = index / values;
        let value = index % values;
        let continues: Vec<_> = self.in_chunk(false).collect();
        let is_written = half != self.inputs.params.turn as usize && !continues.is_empty();
        let is_parameter = self.place(value).is_some();
        let before = if is_written && is_parameter { 0.0 } else { before };
        Some((if is_written { continues } else { Vec::new() }, value, before))
    }
}

impl Parity for DenseWeightBackward {
    const KERNEL: &'static str = "dense_weight_backward";
    const TOLERANCE: f64 = 1.2e-7;
    const WHY: &'static str = "a rounding of both devices for each sample of the slice, of the terms' sizes: lanes are \
        added up in another order; slices are added exactly";

    fn sets() -> Vec<(String, Self)> {
        let mut sets = inputs::sets(|n, fill, random| {
            let layer = Dense::new(n, 6, 2, fill, random);
            Self::new(layer, vec![0, n], [100, 0], fill, random)
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
            let mut random = Random::new(11);
            let layer = Dense::new(300, inputs, columns, Fill::Random, &mut random);
            let set = Self::new(layer, vec![0, 300], [slice, 0], Fill::Random, &mut random);
            let name = format!("random, {inputs} inputs, {columns} columns, slices of {slice}");
            sets.push((name, set));
        }
        let mut random = Random::new(17);
        let layer = Dense::new(37, 6, 2, Fill::Random, &mut random);
        let mut padded = Self::new(layer, vec![0, 37], [16, 0], Fill::Random, &mut random);
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
                let mut random = Random::new(19);
                let layer = Dense::new(300, inputs, columns, fill, &mut random);
                let set = Self::new(layer, first, [slice, first_sample], fill, &mut random);
                sets.push((format!("{name}, slices of {slice}, from {first_sample} on"), set));
            }
        }
        sets
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let DenseWeightBackwardParams { samples, inputs, columns, slice, .. } = self.inputs.params;
        // and behind the last window
        let windows = samples.div_ceil(slice) + 1;
        let invocations = weight_invocations(inputs, columns);
        let outputs = runner.run(&self.inputs.kernel(), invocations, windows)?;
        Ok(outputs.into_iter().map(|output| with_sums(output, self.before.len())).collect())
    }

    fn bound(&self, output: &Output, index: usize, _: Rounding) -> Bound {
        let Some((slices, value, _)) = self.slices_added(output.name, index) else {
            return Bound::EXACT;
        };
        if self.place(value).is_none() {
            return Bound::EXACT;
        }
        let bounds = slices.iter().map(|slice| sum_of_products(self.terms(slice, value)));
        bounds.fold(Bound::EXACT, |sum, bound| Bound {
            scale: sum.scale + bound.scale,
            floor: sum.floor + bound.floor,
        })
    }

    /// A parameter's slope is the sum of what it is multiplied with.
    fn exact_at(&self, output: &str, index: usize) -> Option<f64> {
        let (slices, value, before) = self.slices_added(output, index)?;
        let sum = |slice| self.terms(slice, value).iter().map(|[a, b]| a * b).sum::<f64>();
        Some(before + slices.iter().map(sum).sum::<f64>())
    }
}
