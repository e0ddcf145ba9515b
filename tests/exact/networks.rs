//! Eq. 2, 3, 10 and 11: layers, heads, and the product over a segment.

use organza::parity::Rounding;
use organza::parity::color::ColorHead;
use organza::parity::dense::{Dense, Layer};
use organza::parity::transmittance::{SegmentProduct, TransmittanceHead};

use super::hold::{hold, hold_to};

/// `W x + b`, from the layer's own definition: row `output` of W.
fn affine(layer: &Layer, output: usize, sample: usize) -> f64 {
    let at = |row: usize| {
        let vector = layer.parameters[3 + row * layer.columns as usize + output / 4];
        f64::from(vector[output % 4])
    };
    let inputs = layer.inputs as usize;
    let products = (0..inputs)
        .map(|input| at(input) * f64::from(layer.input[input * layer.stride as usize + sample]));
    products.sum::<f64>() + at(inputs)
}

#[test]
fn hidden_layers_are_rectified_sums() {
    hold::<Dense>(|set, _, index| {
        let (row, sample) = (index / set.layer.stride as usize, index % set.layer.stride as usize);
        let is_output = row < 4 * set.layer.columns as usize && sample < set.layer.samples as usize;
        is_output.then(|| affine(&set.layer, row, sample).max(0.0))
    });
}

#[test]
fn colors_are_sigmoids() {
    hold::<ColorHead>(|set, _, index| {
        let at = index.checked_sub(6)?;
        let (sample, channel) = (at / 3, at % 3);
        let is_color = sample < set.layer.samples as usize;
        is_color.then(|| 1.0 / (1.0 + (-affine(&set.layer, channel, sample)).exp()))
    });
}

#[test]
fn factors_are_powers_of_sigmoids() {
    hold::<TransmittanceHead>(|set, _, index| {
        let sample = index.checked_sub(3)?;
        if sample >= set.layer.samples as usize {
            return None;
        }
        let a = affine(&set.layer, 0, sample);
        let log_sigmoid = a.min(0.0) - (-a.abs()).exp().ln_1p();
        Some(f64::from(set.factor[sample]) * log_sigmoid)
    });
}

#[test]
fn transmittance_is_the_product() {
    // the sum of 16,384 logarithms in f32 is another one than in f64
    hold_to::<SegmentProduct>(Rounding::Regrouped, |set, _, pair| {
        let is_pair = pair + 1 < set.first_sample.len();
        is_pair.then(|| set.of(pair).iter().map(|&x| f64::from(x)).sum::<f64>().exp())
    });
}
