//! The case of `dense_half`.

use glam::Vec4;
use organza_check::{Bound, KernelRunner, Output, Parity, Rounding};
use organza_kernel::half::HalfVector;
use organza_shaders::dense::OUTPUTS_PER_INVOCATION;
use organza_shaders::dense_half::{
    DenseHalfKernel, MAX_INPUT, MAX_WEIGHTS, PRODUCTS_PER_SUM, UNIT,
};

use super::dense::{Dense, Layer};
use super::exact::dense::relu;
use crate::render::half_vectors;
use organza_device::Result;

/// The smallest half that no driver makes zero of.
const NORMAL: f64 = 1.0 / 16_384.0;

/// The same output again, compared with that of the weights before their rounding to 16-bit floats.
const BEFORE_ROUNDING: &str = "output of weights before rounding";

/// Inputs of `dense_half`.
#[derive(Clone, Debug)]
pub struct DenseHalf {
    /// The layer in numbers: weights that halves' sums hold, and inputs as they count.
    pub full: Layer,
    /// The same with the weights that the halves stand for.
    pub rounded: Layer,
    /// The weights, at their places.
    weights: Vec<HalfVector>,
    /// `[inputs, stride]`: also such that are too large.
    input: Vec<f32>,
}

impl DenseHalf {
    fn new(mut full: Layer) -> Self {
        let input = full.input.clone();
        full.input.iter_mut().for_each(|x| *x = x.clamp(-MAX_INPUT, MAX_INPUT));
        let params = full.params();
        let place = params.weight as usize..params.bias as usize;
        let most = Vec4::splat(MAX_WEIGHTS / PRODUCTS_PER_SUM as f32);
        let weights = &mut full.parameters[place.clone()];
        weights.iter_mut().for_each(|weight| *weight = weight.clamp(-most, most));
        let halves = half_vectors(bytemuck::cast_slice(weights));
        let mut rounded = full.clone();
        let numbers = halves.iter().map(|vector| Vec4::from_array(vector.values()));
        rounded.parameters.splice(place.clone(), numbers);
        // no number: nothing before the weights is read
        let nothing = HalfVector([u16::MAX; 4]);
        let weights = std::iter::repeat_n(nothing, place.start).chain(halves).collect();
        Self { full, rounded, weights, input }
    }

    /// The sizes of all numbers that are rounded to halves for an output: of each input and product a term's, and of
    /// the sums in each group.
    #[must_use]
    pub fn rounded_sizes(&self, sample: u32, output: u32) -> f64 {
        let mut sizes = 0.0;
        let mut sum = 0.0;
        for input in 0..self.rounded.inputs {
            let term = self.rounded.weight(input, output) * self.rounded.value(input, sample);
            sum = if input % PRODUCTS_PER_SUM == 0 { term } else { sum + term };
            sizes += 2.0 * term.abs() + sum.abs();
        }
        sizes
    }

    /// What numbers below the normal halves may come to in an output, and the roundings of the `f32` sum.
    #[must_use]
    pub fn floor(&self, sample: u32, output: u32) -> f64 {
        let layer = &self.rounded;
        let lost: f64 = (0..layer.inputs).map(|i| layer.weight(i, output).abs() + 2.0).sum();
        let sums = f64::from(layer.inputs.div_ceil(PRODUCTS_PER_SUM) + 1);
        NORMAL * lost + Dense::TOLERANCE * sums * layer.bound(sample, output).scale
    }

    /// The largest difference from the output of the unrounded weights: the bound of docs/numerics.md.
    fn before_rounding(&self, sample: u32, output: u32) -> f64 {
        let layer = &self.full;
        let growth = (1.0 + f64::from(UNIT)).powi(PRODUCTS_PER_SUM as i32 + 2) - 1.0;
        let sizes = layer.bound(sample, output).scale;
        let terms = sizes - layer.bias(output).abs();
        let flushed: f64 = (0..layer.inputs)
            .map(|i| layer.weight(i, output).abs() + layer.value(i, sample).abs() + 2.0)
            .sum();
        let single =
            2.0_f64.powi(-24) * f64::from(layer.inputs.div_ceil(PRODUCTS_PER_SUM) + 1) * sizes;
        growth * terms + NORMAL * flushed + single
    }
}

impl Parity for DenseHalf {
    const KERNEL: &'static str = "dense_half";
    const TOLERANCE: f64 = 1e-3;
    const WHY: &'static str = "a rounding of both devices to a half, 2^-11 each, of each input, product and sum's size, and 2% \
        for what roundings do to those sizes";
    const NEEDS_HALVES: bool = true;

    fn sets() -> Vec<(String, Self)> {
        Dense::sets().into_iter().map(|(name, set)| (name, Self::new(set.layer))).collect()
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let layer = self.full.params();
        let output = runner.output((4 * layer.columns * layer.stride) as usize)?;
        let kernel = DenseHalfKernel {
            params: layer,
            parameters: &runner.upload(&self.full.parameters)?,
            weights: &runner.upload(&self.weights)?,
            input: &runner.upload(&self.input)?,
            output: &output,
        };
        runner.items(&kernel, layer.samples, layer.columns * 4 / OUTPUTS_PER_INVOCATION)?;
        let output = runner.read(&output)?;
        Ok(vec![Output::float("output", output.clone()), Output::float(BEFORE_ROUNDING, output)])
    }

    fn bound(&self, _: &Output, index: usize, _: Rounding) -> Bound {
        let Some((row, sample)) = self.full.output(index) else {
            return Bound { scale: 0.0, floor: 0.0 };
        };
        Bound { scale: self.rounded_sizes(sample, row), floor: self.floor(sample, row) }
    }

    fn exact(&self, output: &str, len: usize) -> Vec<Option<f64>> {
        let layer = if output == BEFORE_ROUNDING { &self.full } else { &self.rounded };
        let output = |(row, sample)| relu(layer.exact(sample, row));
        (0..len).map(|index| layer.output(index).map(output)).collect()
    }

    fn exact_bound(&self, exact: &Output, index: usize, rounding: Rounding) -> Bound {
        match self.full.output(index) {
            Some((row, sample)) if exact.name == BEFORE_ROUNDING => {
                Bound { scale: 0.0, floor: self.before_rounding(sample, row) }
            }
            _ => self.bound(exact, index, rounding),
        }
    }
}
