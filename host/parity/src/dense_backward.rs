//! Cases of `dense_backward`, `dense_weight_backward`, `dense_weight_sum` and `dense_unit_sum`.

use std::ops::Range;

use glam::Vec4;
use organza_check::{
    Bound, KernelRunner, Output, Parity, Rounding,
    inputs::{self, Fill, ITEMS, Random},
};
use organza_kernel::math::TINY;
use organza_shaders::dense_backward::{
    DenseBackwardKernel, DenseBackwardParams, DenseUnitSumKernel, DenseUnitSumParams,
    DenseWeightBackwardKernel, DenseWeightBackwardParams, DenseWeightSumKernel,
    DenseWeightSumParams, INPUTS_PER_INVOCATION, WEIGHT_ROWS_PER_INVOCATION,
};

use super::dense::Layer;
use super::exact::dense::{affine, relu};
use super::exact::numeric::{Dual, gradient};
use super::unit::Slices;
use organza_device::Result;

/// How far a sum of products may be off: a rounding for each, of the terms' sizes, and what denormals may come to.
fn sum_of_products(terms: impl Iterator<Item = (f64, f64)>) -> Bound {
    let (mut count, mut scale, mut reach) = (0.0, 0.0, 1.0);
    for (a, b) in terms {
        count += 1.0;
        scale += (a * b).abs();
        reach += a.abs() + b.abs() + 1.0;
    }
    Bound { scale: scale * (1.0 + count), floor: reach * f64::from(TINY) }
}

/// Vectors of four of the numbers.
fn vectors(numbers: &[f32]) -> Vec<Vec4> {
    numbers.chunks_exact(4).map(Vec4::from_slice).collect()
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
            input_gradient: &runner.unwritten((self.end * layer.stride) as usize),
        };
        runner.run(&kernel, layer.samples, (self.end - self.first).div_ceil(INPUTS_PER_INVOCATION))
    }

    fn bound(&self, _: &Output, index: usize, _: Rounding) -> Bound {
        let layer = &self.layer;
        let (row, sample) = (index as u32 / layer.stride, index as u32 % layer.stride);
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
    /// Slices of all samples.
    pub slices: Slices,
    /// The chunk's first sample.
    pub first_sample: u32,
    /// `[places, parameters]`: what the chunk before has left.
    pub partial: Vec<Vec4>,
}

impl DenseWeightBackward {
    /// A layer whose rows begin at multiples of four.
    fn layer(samples: u32, inputs: u32, columns: u32, fill: Fill, random: &mut Random) -> Layer {
        let stride = (samples + 5).next_multiple_of(4);
        Layer::with_stride(samples, stride, inputs, columns, fill, random)
    }

    fn new(layer: Layer, slice: u32, fill: Fill, random: &mut Random) -> Self {
        let slices = Slices { first: vec![0, layer.samples], slice };
        Self::of_units(layer, slices, 0, fill, random)
    }

    fn of_units(
        layer: Layer,
        slices: Slices,
        first_sample: u32,
        fill: Fill,
        random: &mut Random,
    ) -> Self {
        let len = (4 * layer.columns * layer.stride) as usize;
        let gradient = fill.values(random, len, [-1.0, 1.0], 1e15);
        let mut set = Self { layer, gradient, slices, first_sample, partial: Vec::new() };
        let len = set.in_chunk().len().max(1) * set.layer.parameters.len();
        set.partial = vectors(&fill.values(random, 4 * len, [-1.0, 1.0], 1e15));
        set
    }

    /// The slices with samples in the chunk: their numbers, and their samples.
    fn in_chunk(&self) -> Vec<(usize, Range<u32>)> {
        let chunk = self.first_sample..self.first_sample + self.layer.samples;
        let all = self.slices.all().into_iter().map(|(_, samples)| samples).enumerate();
        all.filter(|(_, samples)| samples.start < chunk.end && samples.end > chunk.start).collect()
    }

    fn places(&self) -> u32 {
        (self.partial.len() / self.layer.parameters.len()) as u32
    }

    /// Input and output of a weight, the samples of its sum in the chunk, and whether that goes on.  A bias has the number of
    /// inputs as its input.
    fn place(&self, index: usize) -> Option<(u32, u32, Range<u32>, bool)> {
        let layer = &self.layer;
        let (at, parameters) = (index as u32 / 4, layer.parameters.len() as u32);
        let (slot, place) = (at / parameters, at % parameters);
        let slices = self.in_chunk();
        let (_, samples) =
            slices.into_iter().find(|(number, _)| *number as u32 % self.places() == slot)?;
        let place = place.checked_sub(layer.params().weight)?;
        let output = 4 * (place % layer.columns) + index as u32 % 4;
        let in_chunk = |sample: u32| sample.saturating_sub(self.first_sample).min(layer.samples);
        let goes_on = samples.start < self.first_sample;
        let samples = in_chunk(samples.start)..in_chunk(samples.end);
        Some((place / layer.columns, output, samples, goes_on))
    }

    /// What the chunk before has left of a sum.
    fn before(&self, index: usize, goes_on: bool) -> f64 {
        if goes_on { f64::from(self.partial[index / 4][index % 4]) } else { 0.0 }
    }

    fn output_gradient(&self, output: u32, sample: u32) -> f64 {
        f64::from(self.gradient[(output * self.layer.stride + sample) as usize])
    }
}

impl Parity for DenseWeightBackward {
    const KERNEL: &'static str = "dense_weight_backward";
    const TOLERANCE: f64 = 1.2e-7;
    const WHY: &'static str = "a rounding of both devices for each sample of the slice, of the terms' sizes: lanes are \
        added up in another order";

    fn sets() -> Vec<(String, Self)> {
        let mut sets = inputs::sets(|n, fill, random| {
            let layer = Self::layer(n, 6, 2, fill, random);
            Self::new(layer, 100, fill, random)
        });
        for (inputs, columns, slice) in
            [(1, 1, 4096), (4, 3, 16), (5, 2, 1), (7, 16, 33), (64, 1, 300)]
        {
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
        // the chunk begins in a slice, and ends in another one; a unit in it is empty
        for (name, fill) in [("random", Fill::Random), ("mixed", Fill::Mixed)] {
            let slices = Slices { first: vec![0, 50, 131, 131, 200, 420], slice: 33 };
            let mut random = Random::new(19);
            let layer = Self::layer(300, 6, 2, fill, &mut random);
            let set = Self::of_units(layer, slices, 70, fill, &mut random);
            sets.push((format!("{name}, slices of units"), set));
        }
        sets
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let layer = &self.layer;
        let parameters = layer.parameters.len() as u32;
        let places = layer.params();
        let kernel = DenseWeightBackwardKernel {
            params: DenseWeightBackwardParams {
                samples: layer.samples,
                first_sample: self.first_sample,
                stride: layer.stride,
                inputs: layer.inputs,
                columns: layer.columns,
                weight: places.weight,
                bias: places.bias,
                units: self.slices.units(),
                slice: self.slices.slice,
                places: self.places(),
                parameters,
            },
            unit: &self.slices.table(),
            input: &layer.input,
            output_gradient: &self.gradient,
            partial: &self.partial,
        };
        let blocks = layer.inputs.div_ceil(WEIGHT_ROWS_PER_INVOCATION) + 1;
        // and behind the last slice
        runner.run(&kernel, blocks * layer.columns, self.in_chunk().len() as u32 + 1)
    }

    fn bound(&self, _: &Output, index: usize, _: Rounding) -> Bound {
        let layer = &self.layer;
        let Some((input, output, samples, goes_on)) = self.place(index) else {
            return Bound::EXACT;
        };
        let before = (self.before(index, goes_on), 1.0);
        let terms = samples.map(|sample| {
            let is_bias = input == layer.inputs;
            let value = if is_bias { 1.0 } else { layer.value(input, sample) };
            (value, self.output_gradient(output, sample))
        });
        sum_of_products(terms.chain([before]))
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<f64> {
        let layer = &self.layer;
        // the other parameters only add a constant
        let output = |input: u32, sample: u32, parameter: Dual| match input == layer.inputs {
            true => affine(&[], parameter, &[]),
            false => affine(&[parameter], Dual::from(0.0), &[layer.value(input, sample).into()]),
        };
        let Some((input, row, samples, goes_on)) = self.place(index) else {
            return self.partial.get(index / 4).map(|v| f64::from(v[index % 4]));
        };
        // the layer is linear: any value of the parameter gives the same slope
        let [slope] = gradient([0.0], |[parameter]| {
            samples.clone().fold(Dual::from(0.0), |loss, sample| {
                let g = Dual::from(self.output_gradient(row, sample));
                loss + g * output(input, sample, parameter)
            })
        });
        Some(self.before(index, goes_on) + slope)
    }
}

/// Inputs of `dense_weight_sum`.
#[derive(Clone, Debug)]
pub struct DenseWeightSum {
    /// Slices of all samples.
    pub slices: Slices,
    /// The group's samples.
    pub samples: Range<u32>,
    /// `[units, parameters]`, before
    pub unit_sum: Vec<Vec4>,
    /// `[places, parameters]`
    pub partial: Vec<Vec4>,
}

impl DenseWeightSum {
    fn parameters(&self) -> usize {
        self.unit_sum.len() / self.slices.units() as usize
    }

    /// Where the terms of a unit's sum lie in `partial`: those of its slices that end in the group.
    fn terms(&self, index: usize) -> impl Iterator<Item = f64> {
        let (parameters, vector) = (self.parameters(), index / 4);
        let (unit, parameter) = (vector / parameters, vector % parameters);
        let places = self.partial.len() / parameters;
        let all = self.slices.all().into_iter().enumerate();
        all.filter(move |(_, (owner, samples))| {
            *owner == unit && samples.end > self.samples.start && samples.end <= self.samples.end
        })
        .map(move |(slice, _)| {
            f64::from(self.partial[slice % places * parameters + parameter][index % 4])
        })
    }
}

impl Parity for DenseWeightSum {
    const KERNEL: &'static str = "dense_weight_sum";
    const TOLERANCE: f64 = 1.2e-7;
    const WHY: &'static str =
        "a rounding for each slice where drivers regroup, of the terms' sizes";

    fn sets() -> Vec<(String, Self)> {
        let set = |len: u32, first: &[u32], samples: Range<u32>, fill: Fill| {
            let mut random = Random::new(12);
            let slices = Slices { first: first.to_vec(), slice: 16 };
            let places = slices.all().len().max(1) as u32;
            let mut values =
                |len: u32| vectors(&fill.values(&mut random, 4 * len as usize, [-1.0, 1.0], 1e30));
            let unit_sum = values(slices.units() * len);
            Self { slices, samples, unit_sum, partial: values(places * len) }
        };
        let mut sets = inputs::sets(|n, fill, _| set(n, &[0, 40], 0..40, fill));
        sets.retain(|(_, set)| set.parameters() > 0);
        let units = [0, 20, 20, 61, 96, 200];
        for (name, first, samples) in [
            ("no samples", &[0, 0][..], 0..0),
            ("256 slices", &[0, 4096], 0..4096),
            ("all of all units", &units, 0..200),
            // a slice that has begun before, and one that goes on
            ("some of some units", &units, 10..120),
            ("of a slice that goes on", &units, 21..30),
        ] {
            sets.push((name.to_owned(), set(ITEMS, first, samples, Fill::Random)));
        }
        sets
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let parameters = self.parameters() as u32;
        let kernel = DenseWeightSumKernel {
            params: DenseWeightSumParams {
                parameters,
                first_sample: self.samples.start,
                samples: self.samples.len() as u32,
                units: self.slices.units(),
                slice: self.slices.slice,
                places: self.partial.len() as u32 / parameters,
            },
            unit: &self.slices.table(),
            partial: &self.partial,
            unit_sum: &self.unit_sum,
        };
        runner.run(&kernel, parameters, 1)
    }

    fn bound(&self, _: &Output, index: usize, _: Rounding) -> Bound {
        let before = self.unit_sum[index / 4];
        let terms = self.terms(index).chain([f64::from(before[index % 4])]);
        sum_of_products(terms.map(|value| (value, 1.0)))
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<f64> {
        let before = f64::from(self.unit_sum[index / 4][index % 4]);
        Some(before + self.terms(index).sum::<f64>())
    }
}

/// Inputs of `dense_unit_sum`.
#[derive(Clone, Debug)]
pub struct DenseUnitSum {
    /// `[parameters]`, before
    pub gradient: Vec<Vec4>,
    /// `[units, parameters]`
    pub unit_sum: Vec<Vec4>,
}

impl Parity for DenseUnitSum {
    const KERNEL: &'static str = "dense_unit_sum";
    const TOLERANCE: f64 = 1.2e-7;
    const WHY: &'static str = "a rounding for each unit where drivers regroup, of the terms' sizes";

    fn sets() -> Vec<(String, Self)> {
        let set = |len: u32, units: u32, fill: Fill, random: &mut Random| {
            let mut values =
                |len: u32| vectors(&fill.values(random, 4 * len as usize, [-1.0, 1.0], 1e30));
            Self { gradient: values(len), unit_sum: values(units * len) }
        };
        let mut sets = inputs::sets(|n, fill, random| set(n, 3, fill, random));
        for units in [0, 1, 256] {
            let mut random = Random::new(12);
            sets.push((format!("{units} units"), set(ITEMS, units, Fill::Random, &mut random)));
        }
        sets
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let parameters = self.gradient.len() as u32;
        let units = self.unit_sum.len() as u32 / parameters.max(1);
        let kernel = DenseUnitSumKernel {
            params: DenseUnitSumParams { parameters, units },
            unit_sum: &self.unit_sum,
            gradient: &self.gradient,
        };
        runner.run(&kernel, parameters, 1)
    }

    fn bound(&self, _: &Output, index: usize, _: Rounding) -> Bound {
        let before = self.gradient[index / 4];
        let units = self.unit_sum.chunks_exact(self.gradient.len());
        let terms = units.map(|unit| unit[index / 4]).chain([before]);
        sum_of_products(terms.map(|vector| (f64::from(vector[index % 4]), 1.0)))
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<f64> {
        let at = |vectors: &[Vec4]| f64::from(vectors[index / 4][index % 4]);
        let units = self.unit_sum.chunks_exact(self.gradient.len());
        Some(at(&self.gradient) + units.map(at).sum::<f64>())
    }
}
