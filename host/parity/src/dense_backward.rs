//! Cases of `dense_backward` and `dense_weight_backward`.

use std::ops::Range;

use muslin_check::prelude::*;
use organza_shaders::dense_backward::{
    DenseBackwardKernel, DenseBackwardParams, DenseWeightBackwardKernel, DenseWeightBackwardParams,
    INPUTS_PER_INVOCATION, weight_invocations,
};

use super::binned::{with_sums, write_sums};
use super::dense::Layer;
use super::exact::dense::{affine, relu};
use super::exact::numeric::{Dual, gradient};

/// How far a sum of products may be off: a rounding for each, of the terms' sizes, and the most that denormals can add.
fn sum_of_products(terms: impl Iterator<Item = (f64, f64)>) -> Bound {
    let mut count = 0.0;
    let mut scale = 0.0;
    let mut reach = 1.0;
    for (a, b) in terms {
        count += 1.0;
        scale += (a * b).abs();
        reach += a.abs() + b.abs() + 1.0;
    }
    Bound { scale: scale * (1.0 + count), floor: reach * f64::from(TINY) }
}

/// Inputs of `dense_backward`.
#[derive(Clone, Debug)]
pub struct DenseBackward {
    /// The layer; its input has the rows up to `end`, those behind its last zeros.
    pub layer: Layer,
    /// `[4 columns, stride]`
    pub gradient: Vec<f32>,
    /// The first input whose gradient is wanted.
    pub first: u32,
    /// The last one, and one.
    pub end: u32,
    /// Whether the inputs are a hidden layer's outputs.
    pub rectified: bool,
}

impl DenseBackward {
    fn new(mut layer: Layer, rectified: bool, fill: Fill, random: &mut Random) -> Self {
        let len = (4 * layer.columns * layer.stride) as usize;
        let gradient = fill.values(random, len, [-1.0, 1.0], 1e15);
        let (first, end) = match rectified {
            true => (0, layer.inputs.next_multiple_of(16)),
            false => (layer.inputs / 3, layer.inputs),
        };
        layer.input.resize((end * layer.stride) as usize, 0.0);
        Self { layer, gradient, first, end, rectified }
    }

    fn output_gradient(&self, output: u32, sample: u32) -> f64 {
        f64::from(self.gradient[(output * self.layer.stride + sample) as usize])
    }
}

impl Parity for DenseBackward {
    const KERNEL: &'static str = "dense_backward";
    const TOLERANCE: f64 = 1.2e-7;
    const WHY: &'static str = "a rounding of both devices for each output, of the terms' sizes; a denormal activation \
        that may be flushed may pass its gradient on or not";

    fn sets() -> Vec<(String, Self)> {
        let mut sets = inputs::sets(|n, fill, random| {
            let layer = Layer::new(n, 19, 8, fill, random);
            Self::new(layer, true, fill, random)
        });
        for (inputs, columns, rectified) in
            [(1, 1, false), (3, 4, true), (8, 16, true), (40, 4, false), (64, 1, true)]
        {
            let mut random = Random::new(7);
            let layer = Layer::new(65, inputs, columns, Fill::Random, &mut random);
            let set = Self::new(layer, rectified, Fill::Random, &mut random);
            sets.push((format!("random, {inputs} inputs, {columns} columns"), set));
        }
        sets
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let layer = &self.layer;
        let kernel = DenseBackwardKernel {
            params: DenseBackwardParams {
                samples: layer.samples,
                stride: layer.stride,
                inputs: layer.inputs,
                columns: layer.columns,
                weight: layer.params().weight,
                first_input: self.first,
                end_input: self.end,
                rectified: u32::from(self.rectified),
            },
            parameters: &layer.parameters,
            input: &layer.input,
            output_gradient: &self.gradient,
            input_gradient: &unwritten((self.end * layer.stride) as usize),
        };
        runner.run(&kernel, layer.samples, (self.end - self.first).div_ceil(INPUTS_PER_INVOCATION))
    }

    fn bound(&self, _: &Output, index: usize, _: Rounding) -> Bound {
        let layer = &self.layer;
        let row = index as u32 / layer.stride;
        let sample = index as u32 % layer.stride;
        let is_written = row >= self.first && row < layer.inputs && sample < layer.samples;
        if !is_written {
            return Bound::EXACT;
        }
        let outputs = 0..4 * layer.columns;
        let bound = sum_of_products(
            outputs.map(|output| (layer.weight(row, output), self.output_gradient(output, sample))),
        );
        let input = layer.value(row, sample);
        let is_denormal = input > 0.0 && input < f64::from(TINY);
        Bound { floor: bound.floor + if is_denormal { bound.scale } else { 0.0 }, ..bound }
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<f64> {
        let layer = &self.layer;
        // the other inputs only add a constant
        let loss = |input: u32, sample: u32, [x]: [Dual; 1]| {
            let x = if self.rectified { relu(x) } else { x };
            (0..4 * layer.columns).fold(Dual::from(0.0), |loss, output| {
                let y = affine(&[layer.weight(input, output).into()], Dual::from(0.0), &[x]);
                loss + Dual::from(self.output_gradient(output, sample)) * y
            })
        };
        let (row, sample) = layer.place(index)?;
        let is_written = row >= self.first && row < self.end;
        is_written.then(|| {
            if row >= layer.inputs {
                return 0.0;
            }
            // ReLU made an activation of 0 from 0 or less, where its slope is 0
            let [slope] = gradient([layer.value(row, sample)], |x| loss(row, sample, x));
            slope
        })
    }
}

/// Inputs of `dense_weight_backward`.
#[derive(Clone, Debug)]
pub struct DenseWeightBackward {
    /// The layer: its parameters are not read.
    pub layer: Layer,
    /// `[4 columns, stride]`
    pub gradient: Vec<f32>,
    /// Where the samples of each camera begin, and where the last ones end.
    pub first: Vec<u32>,
    /// Samples of a slice.
    pub slice: u32,
    /// Whether samples are those of rays.
    pub of_rays: bool,
    /// The chunk's first sample.
    pub first_sample: u32,
    /// `[2, 4 parameters]`: the carry of the chunk before, and that of the one before it.
    pub carry: Vec<f32>,
    /// Which half of `carry` the chunk before has written.
    pub turn: u32,
    /// `[4 parameters]`: what other chunks have added.
    pub before: Vec<f32>,
}

/// Words of a camera's mask.
const WORDS: u32 = 2;

impl DenseWeightBackward {
    /// A layer whose rows begin at multiples of four.
    fn layer(samples: u32, inputs: u32, columns: u32, fill: Fill, random: &mut Random) -> Layer {
        let stride = (samples + 5).next_multiple_of(4);
        Layer::with_stride(samples, stride, inputs, columns, fill, random)
    }

    fn new(layer: Layer, slice: u32, fill: Fill, random: &mut Random) -> Self {
        let first = vec![0, layer.samples];
        Self::from_cameras(layer, first, slice, 0, fill, random)
    }

    fn from_cameras(
        layer: Layer,
        first: Vec<u32>,
        slice: u32,
        first_sample: u32,
        fill: Fill,
        random: &mut Random,
    ) -> Self {
        let len = (4 * layer.columns * layer.stride) as usize;
        let gradient = fill.values(random, len, [-1.0, 1.0], 1e15);
        let parameters = 4 * layer.parameters.len();
        let carry = fill.values(random, 2 * parameters, [-1.0, 1.0], 1e15);
        let before = fill.values(random, parameters, [-1.0, 1.0], 1e15);
        let turn = random.below(2);
        let of_rays = random.below(2) == 1;
        Self { layer, gradient, first, slice, of_rays, first_sample, carry, turn, before }
    }

    /// Every slice's samples.
    fn slices(&self) -> Vec<Range<u32>> {
        let of_camera = |range: &[u32]| {
            let [begin, end] = [range[0], range[1]];
            (begin..end)
                .step_by(self.slice as usize)
                .map(move |first| first..end.min(first + self.slice))
        };
        self.first.windows(2).flat_map(of_camera).collect()
    }

    fn chunk(&self) -> Range<u32> {
        self.first_sample..self.first_sample + self.layer.samples
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
        let place = (value as u32 / 4).checked_sub(layer.params().weight)?;
        Some((place / layer.columns, 4 * (place % layer.columns) + value as u32 % 4))
    }

    /// The terms of a parameter's sum over a slice: the samples in the chunk, and the sum that the chunk before has left.
    fn terms(&self, slice: &Range<u32>, value: usize) -> (Range<u32>, f64) {
        let chunk = self.chunk();
        let samples = slice.start.max(chunk.start)..slice.end.min(chunk.end);
        let from = self.turn as usize * self.before.len() + value;
        let before = if slice.start < chunk.start { self.carry[from] } else { 0.0 };
        (samples.start - chunk.start..samples.end - chunk.start, f64::from(before))
    }

    fn output_gradient(&self, output: u32, sample: u32) -> f64 {
        f64::from(self.gradient[(output * self.layer.stride + sample) as usize])
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
        let before = f64::from(*self.carry.get(index)?);
        let half = index / values;
        let value = index % values;
        let continues: Vec<_> = self.in_chunk(false).collect();
        let is_written = half != self.turn as usize && !continues.is_empty();
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
            let layer = Self::layer(n, 6, 2, fill, random);
            Self::new(layer, 100, fill, random)
        });
        // the last two have more than one tile
        for (inputs, columns, slice) in [
            (1, 1, 4096),
            (4, 3, 16),
            (5, 2, 1),
            (7, 16, 33),
            (64, 1, 300),
            (130, 1, 64),
            (67, 17, 100),
        ] {
            let mut random = Random::new(11);
            let layer = Self::layer(300, inputs, columns, Fill::Random, &mut random);
            let set = Self::new(layer, slice, Fill::Random, &mut random);
            sets.push((
                format!("random, {inputs} inputs, {columns} columns, slices of {slice}"),
                set,
            ));
        }
        let mut random = Random::new(17);
        let layer = Self::layer(37, 6, 2, Fill::Random, &mut random);
        let mut padded = Self::new(layer, 16, Fill::Random, &mut random);
        padded.gradient[5 * padded.layer.stride as usize..].fill(0.0);
        sets.push(("three of eight outputs are padding".into(), padded));
        // the chunk begins in a slice, and ends in another one; a camera in it is empty
        for (name, fill, inputs, columns) in [
            ("random", Fill::Random, 6, 2),
            ("mixed", Fill::Mixed, 6, 2),
            ("several tiles", Fill::Random, 66, 9),
        ] {
            for (first_sample, slice) in [(70, 33), (70, 4096), (50, 1), (0, 7)] {
                let first = vec![0, 50, 131, 131, 131, 200, 420];
                let mut random = Random::new(19);
                let layer = Self::layer(300, inputs, columns, fill, &mut random);
                let set = Self::from_cameras(layer, first, slice, first_sample, fill, &mut random);
                sets.push((format!("{name}, slices of {slice}, from {first_sample} on"), set));
            }
        }
        sets
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let layer = &self.layer;
        let values = self.before.len();
        let places = layer.params();
        // the pairs of a camera are its rays, of one sample each, or there is one pair for each camera
        let pair = |camera: u32| if self.of_rays { camera } else { self.first[camera as usize] };
        let cameras = self.first.len() as u32 - 1;
        let first_pair: Vec<_> = (0..=WORDS * cameras).map(|word| pair(word / WORDS)).collect();
        let first_sample = if self.of_rays { self.first.clone() } else { vec![0] };
        let kernel = DenseWeightBackwardKernel {
            params: DenseWeightBackwardParams {
                samples: layer.samples,
                first_sample: self.first_sample,
                stride: layer.stride,
                inputs: layer.inputs,
                columns: layer.columns,
                weight: places.weight,
                bias: places.bias,
                cameras,
                words: WORDS,
                of_rays: u32::from(self.of_rays),
                slice: self.slice,
                parameters: layer.parameters.len() as u32,
                turn: self.turn,
            },
            first_pair: &first_pair,
            first_sample: &first_sample,
            input: &layer.input,
            output_gradient: &self.gradient,
            carry: &self.carry,
            sum: &write_sums(&self.before),
        };
        let invocations = weight_invocations(layer.inputs, layer.columns);
        // and behind the last window
        let windows = layer.samples.div_ceil(self.slice) + 1;
        let outputs = runner.run(&kernel, invocations, windows)?;
        Ok(outputs.into_iter().map(|output| with_sums(output, values)).collect())
    }

    fn bound(&self, output: &Output, index: usize, _: Rounding) -> Bound {
        let layer = &self.layer;
        let Some((slices, value, _)) = self.slices_added(output.name, index) else {
            return Bound::EXACT;
        };
        let Some((input, row)) = self.place(value) else { return Bound::EXACT };
        let mut scale = 0.0;
        let mut floor = 0.0;
        for slice in slices {
            let (samples, before) = self.terms(&slice, value);
            let terms = samples.map(|sample| {
                let is_bias = input == layer.inputs;
                let x = if is_bias { 1.0 } else { layer.value(input, sample) };
                (x, self.output_gradient(row, sample))
            });
            let bound = sum_of_products(terms.chain([(before, 1.0)]));
            scale += bound.scale;
            floor += bound.floor;
        }
        Bound { scale, floor }
    }

    fn exact(&self, output: &str, len: usize) -> Vec<Option<f64>> {
        let layer = &self.layer;
        // the other parameters only add a constant
        let affine_of = |input: u32, sample: u32, parameter: Dual| match input == layer.inputs {
            true => affine(&[], parameter, &[]),
            false => affine(&[parameter], Dual::from(0.0), &[layer.value(input, sample).into()]),
        };
        let exact = |index| {
            let (slices, value, before) = self.slices_added(output, index)?;
            let Some((input, row)) = self.place(value) else { return Some(before) };
            let sum_of = |slice: &Range<u32>| {
                let (samples, carried) = self.terms(slice, value);
                // the layer is linear: any value of the parameter gives the same slope
                let [slope] = gradient([0.0], |[parameter]| {
                    samples.clone().fold(Dual::from(0.0), |loss, sample| {
                        let g = Dual::from(self.output_gradient(row, sample));
                        loss + g * affine_of(input, sample, parameter)
                    })
                });
                carried + slope
            };
            Some(before + slices.iter().map(sum_of).sum::<f64>())
        };
        (0..len).map(exact).collect()
    }
}
